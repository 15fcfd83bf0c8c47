// SPDX-License-Identifier: BSD-3-Clause
// Edges colored by chi2 or by robust weight: each line has one of a few levels, the last of which is that of outliers.

export type EdgeColoring = "role" | "chi2" | "weight";

/** What is known of the lines of a graph at rest. */
export interface LineValues {
  /** chi2 divided by the number of rows; its expectation is about 1. */
  chi2: Float32Array;
  /** From 0 to 1; null if all weights are 1. */
  weights: Float32Array | null;
}

interface Scale {
  /** A line belongs to the level after all limits that it has passed. */
  limits: number[];
  passed(value: number, limit: number): boolean;
  names: string[];
}

// A value that is not a number passes all limits, so it is an outlier.
const SCALES: Record<"chi2" | "weight", Scale> = {
  chi2: {
    limits: [0.01, 0.1, 1, 3, 10],
    passed: (value, limit) => !(value < limit),
    names: ["< 0.01", "0.01 to 0.1", "0.1 to 1", "1 to 3", "3 to 10", "≥ 10"],
  },
  weight: {
    limits: [0.9, 0.5, 0.25, 0.1, 0.01],
    passed: (value, limit) => !(value >= limit),
    names: ["≥ 0.9", "0.5 to 0.9", "0.25 to 0.5", "0.1 to 0.25", "0.01 to 0.1", "< 0.01"],
  },
};

export const LEVELS = 6;

export function levelNames(coloring: "chi2" | "weight"): string[] {
  return SCALES[coloring].names;
}

/** Returns the level of each line. */
export function levelsOf(coloring: "chi2" | "weight", { chi2, weights }: LineValues): Uint8Array {
  const { limits, passed } = SCALES[coloring];
  const values = coloring === "chi2" ? chi2 : weights;
  const levels = new Uint8Array(chi2.length);
  if (!values) return levels;
  for (let line = 0; line < levels.length; ++line) {
    const value = values[line]!;
    while (levels[line]! < limits.length && passed(value, limits[levels[line]!]!)) ++levels[line]!;
  }
  return levels;
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
