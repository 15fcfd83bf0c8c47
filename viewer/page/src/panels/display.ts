// SPDX-License-Identifier: BSD-3-Clause
// What the picture shows: sizes, types of vertices and edges, and the filter of points.
import { count, counted, general } from "../format";
import { type EdgeRole, isSameKind, type Structure } from "../protocol/messages";
import { type DisplayOptions, defaultOptions } from "../scene/display_options";
import type { GraphScene } from "../scene/graph_scene";
import { isPoint } from "../scene/statistics";
import type { SceneView } from "../scene/scene_view";
import { byId, create, setText } from "./dom";

/** With more points than this, each of them is small. */
const MANY_POINTS = 5000;
const ROLE_NAMES: Record<EdgeRole, string> = {
  odometry: "Odometry",
  "loop closure": "Loop closures",
  observation: "Observations",
  other: "Others",
};
const MOST_SCALE_EXPONENT = 4;
const LEAST_ERROR_EXPONENT = -1, MOST_ERROR_EXPONENT = 2;

/** A line with a check box. */
interface Entry {
  swatch: string;
  name: string;
  type: string;
  number: number;
}

export class Display {
  private options: DisplayOptions = defaultOptions();
  private structure: Structure | null = null;
  private graph: GraphScene | null = null;
  private hidden_text = create("p", { id: "hidden-points", className: "dim" });

  constructor(private readonly view: SceneView) {
    view.on_structure = (graph) => this.show(graph);
  }

  /** Builds the form anew if the structure has other types. */
  private show(graph: GraphScene): void {
    const { structure } = graph;
    const is_known = this.structure !== null && isSameKind(structure, this.structure);
    const is_new = this.graph !== graph;
    this.graph = graph;
    this.structure = structure;
    if (!is_known) {
      this.options = startOptions(structure, this.options);
      this.build(structure);
    }
    if (is_new) this.apply();
    this.updateFilterText();
  }

  private apply(): void {
    this.view.setOptions(this.options);
    this.updateFilterText();
  }

  private build(structure: Structure): void {
    byId("display").replaceChildren(
      ...[this.vertexBoxes(structure), this.edgeBoxes(structure), this.pointLimits(structure), this.sizes(structure)].filter(
        (part) => part !== null,
      ),
    );
  }

  private vertexBoxes(structure: Structure): HTMLElement {
    const boxes = structure.vertices.map((group, i) => {
      const swatch = isPoint(group) ? "dot landmark" : group.shape === "pose" ? "triangle pose" : "triangle camera";
      const name = isPoint(group) ? (structure.is_bundle ? "Points" : "Landmarks") : group.shape === "pose" ? "Poses" : "Cameras";
      return this.checkBox(`vertices-${i}`, { swatch, name, type: group.name, number: group.count }, this.options.hidden_vertices, i);
    });
    const fixed = structure.fixed.reduce((sum, flag) => sum + flag, 0);
    if (fixed > 0) {
      boxes.push(create("p", { className: "check" }, create("span", { className: "swatch ring" }),
        "Fixed", create("span", { className: "number" }, count(fixed))));
    }
    return fieldset("Vertices", ...boxes);
  }

  private edgeBoxes(structure: Structure): HTMLElement | null {
    if (structure.edges.length === 0) return null;
    const boxes = structure.edges.map((group, i) => {
      const swatch = group.role.replace(" ", "-");
      const entry = { swatch, name: ROLE_NAMES[group.role], type: group.name, number: group.count };
      return this.checkBox(`edges-${i}`, entry, this.options.hidden_edges, i);
    });
    if (structure.left_out > 0) {
      boxes.push(create("p", { className: "dim" }, `${counted(structure.left_out, "edge is", "edges are")} not drawn.`));
    }
    return fieldset("Edges", ...boxes);
  }

  private checkBox(id: string, entry: Entry, hidden: Set<number>, i: number): HTMLElement {
    const box = create("input", { type: "checkbox", id, checked: !hidden.has(i) });
    box.addEventListener("change", () => {
      if (box.checked) hidden.delete(i);
      else hidden.add(i);
      this.apply();
    });
    return create("label", { className: "check", title: `${entry.name}: ${entry.type}` },
      box, create("span", { className: `swatch ${entry.swatch}` }), entry.name,
      create("span", { className: "type" }, entry.type), create("span", { className: "number" }, count(entry.number)));
  }

  private sizes(structure: Structure): HTMLElement {
    const { options } = this;
    const has = (shape: string) => structure.vertices.some((group) => group.shape.startsWith(shape));
    const factor = (value: number) => `× ${general(value, 2)}`;
    const parts = [];
    if (has("pose")) {
      parts.push(this.slider("pose-size", "Poses", scaleRange(options.pose_scale), (value) => {
        options.pose_scale = 2 ** value;
        return factor(options.pose_scale);
      }));
    }
    if (has("camera")) {
      parts.push(this.slider("camera-size", "Cameras", scaleRange(options.camera_scale), (value) => {
        options.camera_scale = 2 ** value;
        return factor(options.camera_scale);
      }));
    }
    if (has("point")) {
      parts.push(this.slider("point-size", "Points", { min: 1, max: 12, step: 0.5, value: options.point_size }, (value) => {
        options.point_size = value;
        return `${general(value, 2)} px`;
      }));
    }
    if (structure.edges.length > 0) {
      parts.push(this.slider("edge-opacity", "Edges", { min: 0, max: 1, step: 0.05, value: options.edge_opacity }, (value) => {
        options.edge_opacity = value;
        return `${Math.round(100 * value)} %`;
      }));
    }
    if (has("pose") && structure.dimension !== 2) parts.push(this.axesBox());
    return fieldset("Sizes and opacity", ...parts);
  }

  private axesBox(): HTMLElement {
    const box = create("input", { type: "checkbox", id: "poses-as-axes", checked: this.options.poses_as_axes });
    box.addEventListener("change", () => {
      this.options.poses_as_axes = box.checked;
      this.apply();
    });
    return create("label", { className: "check" }, box, "Poses as axes", create("span", { className: "type" }, "x orange, y green, z blue"));
  }

  private pointLimits(structure: Structure): HTMLElement | null {
    if (!structure.is_bundle || !structure.vertices.some(isPoint)) return null;
    const { limits } = this.options;
    const longest = this.graph!.filter.longestTrack;
    const track = { min: 1, max: Math.min(20, Math.max(2, longest)), step: 1, value: Math.max(1, limits.least_track_length) };
    const error = { min: LEAST_ERROR_EXPONENT, max: MOST_ERROR_EXPONENT, step: 0.05, value: Math.log10(limits.most_error) };
    return fieldset("Points",
      this.slider("least-track-length", "Seen by ≥", track, (value) => {
        limits.least_track_length = value;
        return `${value}`;
      }),
      this.slider("most-error", "Error ≤", error, (value) => {
        limits.most_error = value >= MOST_ERROR_EXPONENT ? Infinity : 10 ** value;
        return limits.most_error === Infinity ? "any" : `${general(limits.most_error, 2)} px`;
      }),
      this.hidden_text);
  }

  /** `take` stores the value, and returns its text. */
  private slider(
    id: string, name: string, range: { min: number; max: number; step: number; value: number }, take: (value: number) => string,
  ): HTMLElement {
    const input = create("input", { type: "range", id });
    for (const key of ["min", "max", "step", "value"] as const) input[key] = String(Math.min(range[key], range.max));
    const output = create("output", {}, take(input.valueAsNumber));
    input.addEventListener("input", () => {
      setText(output, take(input.valueAsNumber));
      this.apply();
    });
    return create("label", { className: "slider" }, name, input, output);
  }

  private updateFilterText(): void {
    if (!this.graph) return;
    const { hidden, count: total, errors } = this.graph.filter;
    const waits = this.options.limits.most_error < Infinity && !errors ? " The errors of points are not known yet." : "";
    setText(this.hidden_text, (hidden === 0 ? `All ${count(total)} points pass.` : `Hides ${count(hidden)} of ${count(total)} points.`) + waits);
  }
}

/** Keeps the sizes that the user chose. */
function startOptions(structure: Structure, previous: DisplayOptions): DisplayOptions {
  const points = structure.vertices.filter(isPoint).reduce((sum, group) => sum + group.count, 0);
  const options = {
    ...previous,
    point_size: points > MANY_POINTS ? 2 : 5,
    hidden_vertices: new Set<number>(),
    hidden_edges: new Set<number>(),
  };
  // The observations of a reconstruction would cover all else.
  structure.edges.forEach((group, i) => {
    if (structure.is_bundle && group.role === "observation") options.hidden_edges.add(i);
  });
  return options;
}

function scaleRange(scale: number) {
  return { min: -MOST_SCALE_EXPONENT, max: MOST_SCALE_EXPONENT, step: 0.25, value: Math.log2(scale) };
}

function fieldset(title: string, ...children: HTMLElement[]): HTMLElement {
  return create("fieldset", {}, create("legend", {}, title), ...children);
}
