// SPDX-License-Identifier: BSD-3-Clause
// What the picture shows: types of vertices and edges, the filter of points, sizes, and the background.
import { count, counted, general } from "../format";
import { isSameKind, type Structure, type Truth, type VertexGroup } from "../protocol/messages";
import { type DisplayOptions, defaultOptions, styleOf } from "../scene/display_options";
import type { ColorMode } from "../scene/coloring";
import { HUGE, LARGE, type Limited } from "../scene/ellipses";
import type { GraphScene } from "../scene/graph_scene";
import type { SceneView } from "../scene/scene_view";
import { storedOptions, storeOptions } from "../scene/stored_options";
import { classColors, currentTheme, onThemeChange, type Theme } from "../theme";
import { checkBox, choice, colorField, fieldset, lineNumber, slider, swatch } from "./controls";
import { byId, create, setText, setTextOrHide } from "./dom";
import { EdgeColors } from "./edge_colors";
import { sizeSlider, typeRow } from "./type_rows";

const COLOR_MODE_NAMES: Record<ColorMode, string> = {
  type: "Type",
  degree: "Degree (number of edges)",
  component: "Connected component",
  uncertainty: "Uncertainty (1σ)",
};
const OF_NEWEST = "Uncertainties belong to the newest estimates. The picture shows earlier ones.";
const MOST_TRACK_LENGTH = 20;
/** The slider of errors is logarithmic: powers of 10. */
const LEAST_ERROR_EXPONENT = -1, MOST_ERROR_EXPONENT = 2;

export class Display {
  private options: DisplayOptions = storedOptions();
  private structure: Structure | null = null;
  private graph: GraphScene | null = null;
  private readonly edge_colors = new EdgeColors();
  private readonly hidden_text = create("p", { id: "hidden-points", className: "dim" });
  private readonly initial_text = create("p", { id: "initial-unknown", className: "dim" },
    "This page does not know them any more. Reset brings them back.");
  /** Opens a file with the truth; see Files. */
  readonly open_truth = create("button",
    { id: "open-truth", type: "button", title: "Open a file with the true estimates", disabled: true }, "Truth…");
  private readonly truth_text = create("p", { id: "truth-note", className: "dim" });
  private readonly uncertainty_text = create("p", { id: "uncertainty-note", className: "dim" });
  /** Computes the uncertainty; see Covariances. */
  readonly compute = create("button",
    { id: "compute-uncertainty", type: "button", className: "needs-server", disabled: true }, "Compute");
  private readonly legend = create("div", { id: "legend" });
  /** Shows the pattern of H; see PatternDialog. */
  readonly show_pattern = create("button",
    { id: "show-pattern", type: "button", className: "needs-server", disabled: true }, "Pattern of H and L…");
  private readonly reset = create("button", { id: "reset-display", type: "button" }, "Reset to defaults");

  constructor(private readonly view: SceneView) {
    view.on_structure = (graph) => this.show(graph);
    view.on_initial = () => this.updateInitialText();
    view.on_truth = () => this.updateTruthText();
    view.on_newer = () => this.updateTexts();
    view.setOptions(this.options);
    byId("legends").append(this.legend, this.edge_colors.legend);
    this.legend.hidden = this.edge_colors.legend.hidden = true;
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
    this.updateTexts();
  }

  private apply(): void {
    this.view.setOptions(this.options);
    storeOptions(this.options);
    this.updateTexts();
  }

  private build(structure: Structure): void {
    const theme = currentTheme();
    const parts = [fieldset("Vertices", this.vertexRows(structure, theme))];
    parts.push(fieldset("Color of vertices", [this.colorMode()]));
    if (structure.edges.length > 0) parts.push(fieldset("Edges", this.edgeRows(structure, theme)));
    if (structure.is_bundle && structure.vertices.some(({ shape }) => shape === "point"))
      parts.push(fieldset("Points", this.pointLimits()));
    parts.push(fieldset("Sizes", this.sizes(structure)));
    if (structure.edges.length > 0) parts.push(fieldset("Opacity of edges", this.opacities(structure)));
    parts.push(fieldset("Picture", [this.background(theme)]));
    const form = byId("display");
    form.replaceChildren(...parts, create("div", { className: "row" }, this.reset, this.show_pattern));
    form.oninput = () => this.apply();
    this.updateTexts();
  }

  private vertexRows(structure: Structure, theme: Theme): HTMLElement[] {
    const rows = drawn(structure).map(([group, i]) =>
      typeRow(`vertices-${i}`, structure, group, styleOf(this.options, group), theme));
    const fixed = structure.fixed.reduce((sum, flag) => sum + flag, 0);
    if (fixed > 0) rows.push(signRow(swatch("ring"), "Fixed", fixed));
    return [...rows, ...this.initial(), ...this.truth(), ...this.uncertainty(), ...this.scans(structure)];
  }

  private colorMode(): HTMLElement {
    return choice("color-mode", "Color of vertices", this.options.color_mode, COLOR_MODE_NAMES,
      (mode) => (this.options.color_mode = mode));
  }

  private edgeRows(structure: Structure, theme: Theme): HTMLElement[] {
    const rows: HTMLElement[] = structure.edges.map((group, i) =>
      typeRow(`edges-${i}`, structure, group, styleOf(this.options, group), theme));
    if (structure.left_out > 0) {
      const text = `${counted(structure.left_out, "edge is", "edges are")} not drawn.`;
      rows.push(create("p", { className: "dim" }, text));
    }
    rows.push(...this.edge_colors.build(this.options));
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
    const parts = drawn(structure).map(([group, i]) =>
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

  private initial(): HTMLElement[] {
    const box = checkBox("show-initial", this.options.shows_initial, [swatch("before"), "Estimates of the file"], "",
      (checked) => (this.options.shows_initial = checked));
    return [box, this.initial_text];
  }

  private truth(): HTMLElement[] {
    const box = checkBox("show-truth", this.options.shows_truth, [swatch("truth"), "Truth"], "",
      (checked) => (this.options.shows_truth = checked));
    return [create("div", { className: "type-row needs-server" }, box, this.open_truth), this.truth_text];
  }

  private uncertainty(): HTMLElement[] {
    const box = checkBox("show-uncertainty", this.options.shows_uncertainty, [swatch("uncertainty"), "Uncertainty (2σ)"], "",
      (checked) => (this.options.shows_uncertainty = checked));
    return [create("div", { className: "type-row" }, box, this.compute), this.uncertainty_text];
  }

  private scans({ scans }: Structure): HTMLElement[] {
    if (!scans) return [];
    const box = checkBox("show-scans", this.options.shows_scans, [swatch("scan dot"), "Laser scans"], "",
      (checked) => (this.options.shows_scans = checked));
    return [create("div", { className: "type-row" }, box, lineNumber(scans.vertices.length))];
  }

  private background(theme: Theme): HTMLElement {
    const default_color = `#${theme.background.getHexString()}`;
    const field = colorField("background", "Background", this.options.background, default_color,
      (color) => (this.options.background = color));
    return create("div", { className: "type-row" }, create("span", { className: "check" }, "Background"), field);
  }

  private updateTexts(): void {
    this.edge_colors.showLegend(this.options.edge_coloring, this.graph?.level_counts ?? null);
    this.updateFilterText();
    this.updateLegend();
    this.updateInitialText();
    this.updateTruthText();
    setTextOrHide(this.uncertainty_text, this.uncertaintyText());
    const { shown, newer } = this.view;
    tickIfKnown("show-uncertainty", this.options.shows_uncertainty, ((newer ?? shown)?.uncertainty?.vertices.length ?? 0) > 0);
  }

  private updateInitialText(): void {
    this.initial_text.hidden = !this.options.shows_initial || this.view.knowsInitial;
  }

  private updateTruthText(): void {
    const { truth } = this.view;
    setTextOrHide(this.truth_text, truth ? matchText(truth) : "");
    tickIfKnown("show-truth", this.options.shows_truth, truth !== null);
  }

  /** The colors of classes of vertices, and how many vertices have them. */
  private updateLegend(): void {
    const coloring = this.graph?.coloring;
    this.legend.hidden = !coloring;
    if (!coloring) return;
    const colors = classColors(currentTheme(), coloring);
    const rows = coloring.classes.map(({ name, count: vertices }, i) => {
      const sign = swatch("dot");
      sign.style.background = `#${colors[i]!.getHexString()}`;
      return signRow(sign, name, vertices);
    });
    const { left_out } = this.structure!;
    const notes = [
      ...this.uncertaintyNotes(),
      ...(left_out > 0 && this.options.color_mode !== "uncertainty" ? ["Edges that are not drawn do not count."] : []),
      ...(this.options.poses_as_axes ? ["Axes keep their own colors."] : []),
    ];
    this.legend.replaceChildren(...rows, ...notes.map((note) => create("p", { className: "dim" }, note)));
  }

  private uncertaintyText(): string {
    const { shown, newer } = this.view;
    if (newer) return newer.uncertainty ? OF_NEWEST : "";
    const { note } = shown?.uncertainty ?? { note: "" };
    const limited = this.graph?.limitedUncertainties;
    if (note === "") return "";
    const sentence = `${note.charAt(0).toUpperCase()}${note.slice(1)}.`;
    return limited?.large ? `${sentence} ${limitText(limited)}` : sentence;
  }

  private uncertaintyNotes(): string[] {
    if (this.options.color_mode !== "uncertainty") return [];
    if (this.view.newer) return [OF_NEWEST];
    if (!this.view.shown?.uncertainty) return ["Compute the uncertainty first."];
    return ["Standard deviation of the position, in the unit of the graph."];
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

/** A box for something that is not known is neither ticked nor enabled. */
function tickIfKnown(id: string, chosen: boolean, is_known: boolean): void {
  const box = document.getElementById(id);
  if (!(box instanceof HTMLInputElement)) return;
  box.checked = chosen && is_known;
  box.disabled = !is_known;
}

/** Which regions are not drawn as they are. */
function limitText({ large, drawn: outlines, huge }: Limited): string {
  const percent = (part: number) => `${count(100 * part)} %`;
  const are = (number: number) => (number === 1 ? "is" : "are");
  const some = outlines < large ? `${count(outlines)} of them are drawn, as outlines` : "drawn as outlines";
  const text = `${counted(large, "region is", "regions are")} larger than ${percent(LARGE)} of the graph, and ${some}.`;
  if (huge === 0) return text;
  return `${text} ${count(huge)} ${are(huge)} even larger than ${percent(HUGE)}, and drawn with this size instead.`;
}

/** A line that explains a sign of the picture. */
function signRow(sign: HTMLElement, name: string, vertices: number): HTMLElement {
  return create("div", { className: "type-row" }, create("span", { className: "check" }, sign, name), lineNumber(vertices),
    create("span", { className: "color" }));
}

/** How much of the graph has a truth, and how much of the truth is in the graph. */
function matchText({ name, matched_by, matched, poses, true_poses }: Truth): string {
  const of_graph = `${count(matched)} of ${counted(poses, "pose", "poses")}`;
  const of_truth = matched === true_poses ? "" : ` ${count(matched)} of ${count(true_poses)} true ones`;
  return `${name}: ${of_graph} match${of_truth} by ${matched_by}.`;
}

/** The types of vertices that are more than ends of lines, with their numbers. */
function drawn(structure: Structure): [VertexGroup, number][] {
  return [...structure.vertices.entries()]
    .filter(([, { shape }]) => shape !== "corner")
    .map(([i, group]) => [group, i]);
}
