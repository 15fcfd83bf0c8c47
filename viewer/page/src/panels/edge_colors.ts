// SPDX-License-Identifier: BSD-3-Clause
// The choice by what edges are colored, and its legend.
import type { DisplayOptions } from "../scene/display_options";
import { EDGE_COLORINGS, type EdgeColoring, levelNames, type LevelColoring } from "../scene/edge_levels";
import { lineNumber, swatch } from "./controls";
import { create, setTextOrHide } from "./dom";

const NAMES: Record<EdgeColoring, string> = { role: "role", chi2: "chi2", weight: "robust weight", verdict: "verdict" };
const TITLES: Record<LevelColoring, string> = { chi2: "chi2 per row", weight: "Robust weight", verdict: "Verdict" };
const EXPLANATIONS: Record<LevelColoring, string> = {
  chi2: "chi2 of the edge per row of its error, before the kernel; about 1 is expected.",
  weight: "The factor by which the kernel reduces the edge.",
  verdict: "Whether the last run found the edge false. Choose suspects in Settings, Search for false edges, and optimize.",
};

export class EdgeColors {
  /** What the colors mean; it is in the picture. */
  readonly legend = create("div", { id: "edge-legend" });
  private readonly explanation = create("p", { className: "dim" });

  /** The options are changed in place. */
  build(options: DisplayOptions): HTMLElement[] {
    const select = create("select", { id: "edge-coloring" },
      ...EDGE_COLORINGS.map((value) => create("option", { value }, NAMES[value])));
    select.value = options.edge_coloring;
    select.addEventListener("input", () => (options.edge_coloring = select.value as EdgeColoring));
    return [create("label", { className: "choice" }, "Color edges by", select), this.explanation];
  }

  /** `counts` are the numbers of lines of each level. */
  showLegend(coloring: EdgeColoring, counts: number[] | null): void {
    this.legend.hidden = coloring === "role" || !counts;
    setTextOrHide(this.explanation, coloring === "role" ? "" : EXPLANATIONS[coloring]);
    if (coloring === "role" || !counts) return;
    const lines = levelNames(coloring).map(([level, name]) =>
      create("li", {}, swatch(`level-${level}`), name, lineNumber(counts[level]!)));
    this.legend.replaceChildren(create("p", { className: "dim" }, TITLES[coloring]), create("ul", { className: "legend" }, ...lines));
  }
}
