// SPDX-License-Identifier: BSD-3-Clause
// Edges colored by chi2, by robust weight or by verdict: each line has one of a few levels, the last of which is that of
// outliers.

/** What decides the level of a line; "role" means that lines have no levels. */
export const EDGE_COLORINGS = ["role", "chi2", "weight", "verdict"] as const;
export type EdgeColoring = (typeof EDGE_COLORINGS)[number];
export type LevelColoring = Exclude<EdgeColoring, "role">;

/** What is known of the lines of a graph at rest. */
export interface LineValues {
  /** chi2 divided by the number of rows; its expectation is about 1. */
  chi2: Float32Array;
  /** From 0 to 1; null if all weights are 1. */
  weights: Float32Array | null;
  /** Of the last run, as in viewer/PROTOCOL.md; null if it has none. */
  verdicts: Uint8Array | null;
}

export const LEVELS = 6;

interface Scale {
  /** The level of a line, from 0 to LEVELS - 1; null if all lines have level 0. */
  levels(values: LineValues): ((line: number) => number) | null;
  /** The names of the levels that occur. */
  names: [number, string][];
}

/** A line belongs to the level after all limits that it has passed. */
function limited(values: Float32Array, limits: number[], passed: (value: number, limit: number) => boolean) {
  return (line: number) => {
    let level = 0;
    while (level < limits.length && passed(values[line]!, limits[level]!)) ++level;
    return level;
  };
}

/** The levels of the verdicts 0 to 3. */
const VERDICT_LEVELS = [0, 2, 3, 5];

// A value that is not a number passes all limits, so it is an outlier.
const SCALES: Record<LevelColoring, Scale> = {
  chi2: {
    levels: ({ chi2 }) => limited(chi2, [0.01, 0.1, 1, 3, 10], (value, limit) => !(value < limit)),
    names: [...["< 0.01", "0.01 to 0.1", "0.1 to 1", "1 to 3", "3 to 10", "≥ 10"].entries()],
  },
  weight: {
    levels: ({ weights }) => weights && limited(weights, [0.9, 0.5, 0.25, 0.1, 0.01], (value, limit) => !(value >= limit)),
    names: [...["≥ 0.9", "0.5 to 0.9", "0.25 to 0.5", "0.1 to 0.25", "0.01 to 0.1", "< 0.01"].entries()],
  },
  verdict: {
    levels: ({ verdicts }) => verdicts && ((line) => VERDICT_LEVELS[verdicts[line]!]!),
    names: ["no suspect", "inlier", "undecided", "outlier"].map((name, verdict) => [VERDICT_LEVELS[verdict]!, name]),
  },
};

export function levelNames(coloring: LevelColoring): [number, string][] {
  return SCALES[coloring].names;
}

/** Returns the level of each line. */
export function levelsOf(coloring: LevelColoring, values: LineValues): Uint8Array {
  const level = SCALES[coloring].levels(values);
  return Uint8Array.from(values.chi2, (_, line) => level?.(line) ?? 0);
}

/** Returns the lines from `first` to `first + count - 1` that have the level: two vertex numbers each. */
export function linesOfLevel(
  lines: Uint32Array, first: number, count: number, levels: Uint8Array, level: number,
): Uint32Array {
  const chosen: number[] = [];
  for (let line = first; line < first + count; ++line) {
    if (levels[line] === level) chosen.push(lines[2 * line]!, lines[2 * line + 1]!);
  }
  return Uint32Array.from(chosen);
}

/** Returns the number of lines of each level. */
export function levelCounts(levels: Uint8Array): number[] {
  const counts = new Array<number>(LEVELS).fill(0);
  for (const level of levels) ++counts[level]!;
  return counts;
}
