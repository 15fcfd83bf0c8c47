// SPDX-License-Identifier: BSD-3-Clause
// What the picture shows: types of vertices and edges, the filter of points, sizes, and the background.
import { count, counted, general } from "../format";
import { isSameKind, type Structure } from "../protocol/messages";
import { type DisplayOptions, defaultOptions, styleOf } from "../scene/display_options";
import type { GraphScene } from "../scene/graph_scene";
import type { SceneView } from "../scene/scene_view";
import { storedOptions, storeOptions } from "../scene/stored_options";
import { currentTheme, onThemeChange, type Theme } from "../theme";
import { checkBox, colorField, fieldset, lineNumber, slider, swatch } from "./controls";
import { byId, create, setText } from "./dom";
import { sizeSlider, typeRow } from "./type_rows";

const MOST_TRACK_LENGTH = 20;
/** The slider of errors is logarithmic: powers of 10. */
const LEAST_ERROR_EXPONENT = -1, MOST_ERROR_EXPONENT = 2;

export class Display {
  private options: DisplayOptions = storedOptions();
  private structure: Structure | null = null;
  private graph: GraphScene | null = null;
  private readonly hidden_text = create("p", { id: "hidden-points", className: "dim" });
  private readonly reset = create("button", { id: "reset-display", type: "button" }, "Reset to defaults");

  constructor(private readonly view: SceneView) {
    view.on_structure = (graph) => this.show(graph);
    view.setOptions(this.options);
    // The theme has other default colors.
    onThemeChange(() => this.structure && this.build(this.structure));
    this.reset.addEventListener("click", () => {
      this.options = defaultOptions();
      this.build(this.structure!);
      this.apply();
    });
  }

  /** Builds the form anew if the structure has other types. */
  private show(graph: GraphScene): void {
    const { structure } = graph;
    const is_known = this.structure !== null && isSameKind(structure, this.structure);
    const is_new = this.graph !== graph;
    this.graph = graph;
    this.structure = structure;
    if (!is_known) this.build(structure);
    if (is_new) this.apply();
    this.updateFilterText();
  }

  private apply(): void {
    this.view.setOptions(this.options);
    storeOptions(this.options);
    this.updateFilterText();
  }

  private build(structure: Structure): void {
    const theme = currentTheme();
    const parts = [fieldset("Vertices", this.vertexRows(structure, theme))];
    if (structure.edges.length > 0) parts.push(fieldset("Edges", this.edgeRows(structure, theme)));
    if (structure.is_bundle && structure.vertices.some(({ shape }) => shape === "point"))
      parts.push(fieldset("Points", this.pointLimits()));
    parts.push(fieldset("Sizes", this.sizes(structure)));
    if (structure.edges.length > 0) parts.push(fieldset("Opacity of edges", this.opacities(structure)));
    parts.push(fieldset("Picture", [this.background(theme)]));
    const form = byId("display");
    form.replaceChildren(...parts, this.reset);
    form.oninput = () => this.apply();
  }

  private vertexRows(structure: Structure, theme: Theme): HTMLElement[] {
    const rows = structure.vertices.map((group, i) =>
      typeRow(`vertices-${i}`, structure, group, styleOf(this.options, group), theme));
    const fixed = structure.fixed.reduce((sum, flag) => sum + flag, 0);
    if (fixed > 0) {
      const sign = create("span", { className: "check" }, swatch("ring"), "Fixed");
      rows.push(create("div", { className: "type-row" }, sign, lineNumber(fixed), create("span", { className: "color" })));
    }
    return rows;
  }

  private edgeRows(structure: Structure, theme: Theme): HTMLElement[] {
    const rows: HTMLElement[] = structure.edges.map((group, i) =>
      typeRow(`edges-${i}`, structure, group, styleOf(this.options, group), theme));
    if (structure.left_out > 0) {
      const text = `${counted(structure.left_out, "edge is", "edges are")} not drawn.`;
      rows.push(create("p", { className: "dim" }, text));
    }
    return rows;
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
    const parts = structure.vertices.map((group, i) =>
      sizeSlider(`vertices-${i}`, structure, group, styleOf(this.options, group)));
    if (structure.dimension !== 2 && structure.vertices.some(({ shape }) => shape === "pose")) {
      parts.push(checkBox("poses-as-axes", this.options.poses_as_axes, ["Poses as axes"], "x orange, y green, z blue",
        (checked) => (this.options.poses_as_axes = checked)));
    }
    return parts;
  }

  private opacities(structure: Structure): HTMLElement[] {
    return structure.edges.map((group, i) =>
      sizeSlider(`edges-${i}`, structure, group, styleOf(this.options, group)));
  }

  private background(theme: Theme): HTMLElement {
    const default_color = `#${theme.background.getHexString()}`;
    const field = colorField("background", "Background", this.options.background, default_color,
      (color) => (this.options.background = color));
    return create("div", { className: "type-row" }, create("span", { className: "check" }, "Background"), field);
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
