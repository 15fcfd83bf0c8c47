// SPDX-License-Identifier: BSD-3-Clause
// Classes of vertices that have a color each: by degree or connected component, which follow from the lines of the structure, or by
// how uncertain their positions are.
import { count, general } from "../format";
import type { Structure, Uncertainty } from "../protocol/messages";

export const COLOR_MODES = ["type", "degree", "component", "uncertainty"] as const;
export type ColorMode = (typeof COLOR_MODES)[number];

/** The materials have this number of colors. */
export const MOST_CLASSES = 8;

export interface VertexClass {
  name: string;
  count: number;
}

export interface Coloring {
  /** "ramp": from low to high. "distinct": the last class of MOST_CLASSES is what is left over. */
  scale: "ramp" | "distinct";
  /** True if the last class of a ramp is what is left over. */
  has_rest: boolean;
  classes: VertexClass[];
  /** The class of each vertex. */
  of_vertex: Uint8Array;
}

/** The least degree of each class. */
const DEGREE_LIMITS = [0, 1, 2, 3, 4, 5, 9, 17];
const SIGMA_CLASSES = 6;
/** The part of all standard deviations at each end of their range that does not determine the limits of classes. */
const IGNORED = 0.02;
/** Numbers that differ by a smaller factor are one class. */
const LEAST_RANGE = 1.01;

/** Returns null for colors by type. `uncertainty` is null if it was not computed. */
export function coloringOf(structure: Structure, mode: ColorMode, uncertainty: Uncertainty | null): Coloring | null {
  switch (mode) {
    case "type": return null;
    case "degree": return degreeColoring(structure);
    case "component": return componentColoring(structure);
    case "uncertainty": return uncertaintyColoring(structure.fixed.length, uncertainty);
  }
}

/** Vertices by the number of their lines; classes without vertices are absent. */
function degreeColoring({ lines, fixed }: Structure): Coloring {
  const degrees = new Uint32Array(fixed.length);
  for (const vertex of lines) ++degrees[vertex]!;
  const largest = degrees.reduce((most, degree) => Math.max(most, degree), 0);
  const all = DEGREE_LIMITS.map((least, i) => {
    const most = Math.min(largest, (DEGREE_LIMITS[i + 1] ?? Infinity) - 1);
    return { name: most > least ? `${least}–${count(most)}` : `${least}`, count: 0 };
  });
  const of_vertex = Uint8Array.from(degrees, degreeClass);
  for (const i of of_vertex) ++all[i]!.count;
  const classes = all.filter((each) => each.count > 0);
  const renumbered = all.map((each) => classes.indexOf(each));
  return { scale: "ramp", has_rest: false, classes, of_vertex: of_vertex.map((i) => renumbered[i]!) };
}

function degreeClass(degree: number): number {
  let i = DEGREE_LIMITS.length - 1;
  while (degree < DEGREE_LIMITS[i]!) --i;
  return i;
}

/** The largest connected components, and all others as one class. */
function componentColoring(structure: Structure): Coloring {
  const roots = componentRoots(structure);
  const sizes = new Map<number, number>();
  for (const root of roots) sizes.set(root, (sizes.get(root) ?? 0) + 1);
  const by_size = [...sizes].sort((a, b) => b[1] - a[1]);
  const named = by_size.length <= MOST_CLASSES ? by_size : by_size.slice(0, MOST_CLASSES - 1);
  const rest = by_size.slice(named.length);
  const classes = named.map(([, size], i) => ({ name: `Component ${i + 1}`, count: size }));
  if (rest.length > 0)
    classes.push({ name: `${count(rest.length)} others`, count: rest.reduce((sum, [, size]) => sum + size, 0) });
  const class_of = new Map(named.map(([root], i) => [root, i]));
  return { scale: "distinct", has_rest: false, classes, of_vertex: Uint8Array.from(roots, (root) => class_of.get(root) ?? MOST_CLASSES - 1) };
}

/** Returns a vertex of its component for each vertex, the same one for all of the component. */
function componentRoots({ lines, fixed }: Structure): Uint32Array {
  const parents = Uint32Array.from(fixed, (_, vertex) => vertex);
  const rootOf = (vertex: number): number => {
    // Each visited vertex skips its parent, so that paths stay short.
    while (parents[vertex] !== vertex) vertex = parents[vertex] = parents[parents[vertex]!]!;
    return vertex;
  };
  for (let i = 0; i < lines.length; i += 2) {
    const a = rootOf(lines[i]!), b = rootOf(lines[i + 1]!);
    parents[Math.max(a, b)] = Math.min(a, b);
  }
  return parents.map((_, vertex) => rootOf(vertex));
}

/**
 * Vertices by the standard deviation of their position: the root of the trace of its covariance. The classes divide the range of the
 * logarithms, without the smallest and the largest IGNORED of them, which are in the first and in the last class. Vertices of which
 * it is not known are the rest.
 */
function uncertaintyColoring(vertices: number, uncertainty: Uncertainty | null): Coloring {
  const { covariances = new Float32Array(0), vertices: numbers = new Uint32Array(0) } = uncertainty ?? {};
  const sigmas = new Float64Array(vertices).fill(NaN);
  numbers.forEach((vertex, i) => {
    const [xx, , , yy, , zz] = covariances.subarray(6 * i, 6 * i + 6);
    sigmas[vertex] = Math.sqrt(xx! + yy! + zz!);
  });
  const known = sigmas.filter((sigma) => sigma > 0 && sigma < Infinity).sort();
  const [least, most] = commonRange(known);
  const is_range = most > LEAST_RANGE * least;
  const steps = known.length === 0 ? 0 : is_range ? SIGMA_CLASSES : 1;
  // The first and the last class contain all that is beyond the range.
  const limit = (i: number) =>
    shortNumber(i === 0 ? known[0]! : i === steps ? known[known.length - 1]! : least * (most / least) ** (i / steps));
  const all = Array.from({ length: steps }, (_, i) => ({ name: is_range ? `${limit(i)}–${limit(i + 1)}` : limit(i), count: 0 }));
  all.push({ name: "fixed, or not known", count: 0 });
  const of_vertex = Uint8Array.from(sigmas, (sigma) => {
    if (!(sigma > 0 && sigma < Infinity)) return steps;
    const place = is_range ? Math.floor((steps * Math.log(sigma / least)) / Math.log(most / least)) : 0;
    return Math.max(0, Math.min(steps - 1, place));
  });
  for (const i of of_vertex) ++all[i]!.count;
  const has_rest = all[steps]!.count > 0;
  return { scale: "ramp", has_rest, classes: has_rest ? all : all.slice(0, steps), of_vertex };
}

/** The range of sorted numbers without the ends that are ignored, unless all others are the same. */
function commonRange(sorted: Float64Array): [number, number] {
  const at = (part: number) => sorted[Math.min(sorted.length - 1, Math.floor(part * sorted.length))] ?? 0;
  const least = at(IGNORED), most = at(1 - IGNORED);
  return most > LEAST_RANGE * least ? [least, most] : [at(0), at(1)];
}

/** Two digits, or all that are before the point. */
function shortNumber(value: number): string {
  return value >= 100 && value < 1e5 ? count(Math.round(value)) : general(value, 2);
}
