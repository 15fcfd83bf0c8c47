// SPDX-License-Identifier: BSD-3-Clause
// Classes of vertices that have a color each: by degree, or by connected component. Both follow from the lines of the structure.
import { count } from "../format";
import type { Structure } from "../protocol/messages";

export const COLOR_MODES = ["type", "degree", "component"] as const;
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
  classes: VertexClass[];
  /** The class of each vertex. */
  of_vertex: Uint8Array;
}

/** The least degree of each class. */
const DEGREE_LIMITS = [0, 1, 2, 3, 4, 5, 9, 17];

/** Returns null for colors by type. */
export function coloringOf(structure: Structure, mode: ColorMode): Coloring | null {
  if (mode === "type") return null;
  return mode === "degree" ? degreeColoring(structure) : componentColoring(structure);
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
  return { scale: "ramp", classes, of_vertex: of_vertex.map((i) => renumbered[i]!) };
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
  return { scale: "distinct", classes, of_vertex: Uint8Array.from(roots, (root) => class_of.get(root) ?? MOST_CLASSES - 1) };
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
