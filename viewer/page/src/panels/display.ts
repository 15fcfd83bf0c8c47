// SPDX-License-Identifier: BSD-3-Clause
// What the picture shows: types of vertices and edges, the filter of points, and sizes.
import { count, counted, general } from "../format";
import { type EdgeRole, isSameKind, type Structure, type VertexGroup } from "../protocol/messages";
import { type DisplayOptions, defaultOptions } from "../scene/display_options";
import type { GraphScene } from "../scene/graph_scene";
import type { SceneView } from "../scene/scene_view";
import { isPoint } from "../scene/statistics";
import { checkBox, fieldset, lineNumber, type Range, slider, swatch } from "./controls";
import { byId, create, setText } from "./dom";

/** With more points than this, each of them is small. */
const MANY_POINTS = 5000;
const MOST_TRACK_LENGTH = 20;
/** The sliders of factors and of errors are logarithmic: powers of 2 and of 10. */
const MOST_SCALE_EXPONENT = 4;
const LEAST_ERROR_EXPONENT = -1, MOST_ERROR_EXPONENT = 2;

const ROLE_NAMES: Record<EdgeRole, string> = {
  odometry: "Odometry",
  "loop closure": "Loop closures",
  observation: "Observations",
  other: "Others",
};

export class Display {
  private options: DisplayOptions = defaultOptions();
  private structure: Structure | null = null;
  private graph: GraphScene | null = null;
  private readonly hidden_text = create("p", { id: "hidden-points", className: "dim" });

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
    const parts = [fieldset("Vertices", this.vertexBoxes(structure))];
    if (structure.edges.length > 0) parts.push(fieldset("Edges", this.edgeBoxes(structure)));
    if (structure.is_bundle && hasShape(structure, "point")) parts.push(fieldset("Points", this.pointLimits()));
    parts.push(fieldset("Sizes and opacity", this.sizes(structure)));
    const form = byId("display");
    form.replaceChildren(...parts);
    form.oninput = () => this.apply();
  }

  private vertexBoxes(structure: Structure): HTMLElement[] {
    const boxes = structure.vertices.map((group, i) => {
      const { name, kind } = vertexSign(group, structure.is_bundle);
      return this.typeBox(`vertices-${i}`, swatch(kind), name, group, this.options.hidden_vertices, i);
    });
    const fixed = structure.fixed.reduce((sum, flag) => sum + flag, 0);
    if (fixed > 0) boxes.push(create("p", { className: "check" }, swatch("ring"), "Fixed", lineNumber(fixed)));
    return boxes;
  }

  private edgeBoxes(structure: Structure): HTMLElement[] {
    const boxes = structure.edges.map((group, i) => {
      const sign = swatch(group.role.replace(" ", "-"));
      return this.typeBox(`edges-${i}`, sign, ROLE_NAMES[group.role], group, this.options.hidden_edges, i);
    });
    if (structure.left_out > 0) {
      const text = `${counted(structure.left_out, "edge is", "edges are")} not drawn.`;
      boxes.push(create("p", { className: "dim" }, text));
    }
    return boxes;
  }

  private typeBox(
    id: string, sign: HTMLElement, name: string, group: { name: string; count: number }, hidden: Set<number>, i: number,
  ): HTMLElement {
    const box = checkBox(id, !hidden.has(i), [sign, name], group.name, (checked) => {
      if (checked) hidden.delete(i);
      else hidden.add(i);
    });
    box.append(lineNumber(group.count));
    return box;
  }

  private pointLimits(): HTMLElement[] {
    const { limits } = this.options;
    const longest = Math.min(MOST_TRACK_LENGTH, Math.max(2, this.graph!.filter.longestTrack));
    const track = { min: 1, max: longest, step: 1, value: Math.max(1, limits.least_track_length) };
    const most = Math.log10(limits.most_error);
    const error = { min: LEAST_ERROR_EXPONENT, max: MOST_ERROR_EXPONENT, step: 0.05, value: most };
    return [
      slider("least-track-length", "Seen by ≥", track, (value) => {
        limits.least_track_length = value;
        return `${value}`;
      }),
      slider("most-error", "Error ≤", error, (value) => {
        limits.most_error = value >= MOST_ERROR_EXPONENT ? Infinity : 10 ** value;
        return limits.most_error === Infinity ? "any" : `${general(limits.most_error, 2)} px`;
      }),
      this.hidden_text,
    ];
  }

  private sizes(structure: Structure): HTMLElement[] {
    const { options } = this;
    const parts: HTMLElement[] = [];
    if (hasShape(structure, "pose")) parts.push(this.scaleSlider("pose-size", "Poses", "pose_scale"));
    if (hasShape(structure, "camera")) parts.push(this.scaleSlider("camera-size", "Cameras", "camera_scale"));
    if (hasShape(structure, "point")) {
      const range = { min: 1, max: 12, step: 0.5, value: options.point_size };
      parts.push(slider("point-size", "Points", range, (value) => `${general((options.point_size = value), 2)} px`));
    }
    if (structure.edges.length > 0) {
      const range = { min: 0, max: 1, step: 0.05, value: options.edge_opacity };
      parts.push(slider("edge-opacity", "Edges", range, (value) => `${Math.round(100 * (options.edge_opacity = value))} %`));
    }
    if (hasShape(structure, "pose") && structure.dimension !== 2) {
      parts.push(checkBox("poses-as-axes", options.poses_as_axes, ["Poses as axes"], "x orange, y green, z blue",
        (checked) => (options.poses_as_axes = checked)));
    }
    return parts;
  }

  private scaleSlider(id: string, name: string, option: "pose_scale" | "camera_scale"): HTMLElement {
    const value = Math.log2(this.options[option]);
    const range: Range = { min: -MOST_SCALE_EXPONENT, max: MOST_SCALE_EXPONENT, step: 0.25, value };
    return slider(id, name, range, (exponent) => `× ${general((this.options[option] = 2 ** exponent), 2)}`);
  }

  private updateFilterText(): void {
    if (!this.graph) return;
    const { hidden, count: total, errors } = this.graph.filter;
    const is_waiting = this.options.limits.most_error < Infinity && !errors;
    setText(this.hidden_text,
      (hidden === 0 ? `All ${count(total)} points pass.` : `Hides ${count(hidden)} of ${count(total)} points.`) +
      (is_waiting ? " The errors of points are not known yet." : ""));
  }
}

function vertexSign(group: VertexGroup, is_bundle: boolean): { name: string; kind: string } {
  if (isPoint(group)) return { name: is_bundle ? "Points" : "Landmarks", kind: "dot landmark" };
  return group.shape === "pose" ? { name: "Poses", kind: "triangle pose" } : { name: "Cameras", kind: "triangle camera" };
}

function hasShape(structure: Structure, shape: "pose" | "camera" | "point"): boolean {
  return structure.vertices.some((group) => group.shape.startsWith(shape));
}

/** Keeps the sizes that the user chose. */
function startOptions(structure: Structure, previous: DisplayOptions): DisplayOptions {
  const points = structure.vertices.filter(isPoint).reduce((sum, group) => sum + group.count, 0);
  const hidden_edges = new Set<number>();
  // The observations of a reconstruction would cover all else.
  structure.edges.forEach((group, i) => {
    if (structure.is_bundle && group.role === "observation") hidden_edges.add(i);
  });
  return { ...previous, point_size: points > MANY_POINTS ? 2 : 5, hidden_vertices: new Set(), hidden_edges };
}
