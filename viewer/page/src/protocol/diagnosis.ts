// SPDX-License-Identifier: BSD-3-Clause
// What is wrong with the graph, as viewer/PROTOCOL.md describes it.
import { count as number } from "../format";
import type { ElementName } from "./element";

export interface Finding {
  severity: "error" | "warning" | "note";
  kind: string;
  text: string;
  /** null if there are several. */
  element: ElementName | null;
  /** The numbers of the drawn vertices; `count` is that of all, some of which may not be sent. */
  vertices: { count: number; marked: number[] };
  /** The numbers of the lines of `marked` of the `count` drawn edges. */
  edges: { count: number; marked: number; lines: number[] };
}

export interface Diagnosis {
  structure: number;
  /** Of all findings, some of which may not be sent. */
  count: number;
  findings: Finding[];
  /** The number of edges that were ignored, because the last run found them false. */
  left_out?: number;
}

/** True if a mark of the finding would show something. */
export function canMark({ element, vertices, edges }: Finding): boolean {
  return element !== null || vertices.count > 0 || edges.count > 0;
}

/** Says what is marked, and what is too much for that: "10,000 of 12,345 vertices and 1 edge are marked." */
export function markText({ vertices, edges }: Finding): string {
  const part = (marked: number, count: number, one: string, many: string) =>
    marked < count ? `${number(marked)} of ${number(count)} ${many}` : `${number(count)} ${count === 1 ? one : many}`;
  const parts = [
    ...(vertices.count > 0 ? [part(vertices.marked.length, vertices.count, "vertex", "vertices")] : []),
    ...(edges.count > 0 ? [part(edges.marked, edges.count, "edge", "edges")] : []),
  ];
  if (parts.length === 0) return "";
  return `${parts.join(" and ")} ${vertices.count + edges.count === 1 ? "is" : "are"} marked.`;
}
