// SPDX-License-Identifier: BSD-3-Clause
// The answers to `GET /element`, as viewer/PROTOCOL.md describes them.
import type { MaybeNumber } from "./messages";

/** Names an element: a parameter of the request, and its value. */
export interface ElementName {
  key: "vertex" | "id" | "line" | "edge";
  number: string;
}

export interface EdgeEnd {
  id: string;
  type: string;
  is_parameter: boolean;
  /** The number of the vertex in the structure; null if it is not drawn. */
  vertex: number | null;
}

export interface EdgeFacts {
  kind: "edge";
  edge: number;
  line: number | null;
  type: string;
  tag: string;
  fields: string;
  vertices: EdgeEnd[];
  vertex_count: number;
  rows: number;
  level: number;
  error: MaybeNumber[];
  chi2: MaybeNumber;
  chi2_per_row: MaybeNumber;
  weight: MaybeNumber;
  kernel: string;
  is_enabled: boolean;
  /** Of the last run; null if the edge was no suspect. */
  verdict: "inlier" | "outlier" | "undecided" | null;
}

export interface VertexFacts {
  kind: "vertex";
  id: string;
  vertex: number | null;
  type: string;
  tag: string;
  estimate: string;
  is_fixed: boolean;
  fixed_directions: number[];
  edge_count: number;
  edges: EdgeFacts[];
}

export type ElementFacts = VertexFacts | EdgeFacts;

/** The name by which the element is known as long as its graph is. */
export function lastingName(facts: ElementFacts): ElementName {
  return facts.kind === "vertex" ? { key: "id", number: facts.id } : { key: "edge", number: String(facts.edge) };
}

/** Two vertices for each line of an edge: the first one is joined with all others. */
export function drawnPairs(facts: ElementFacts): number[] {
  const [first, ...others] = drawnVertices(facts);
  return others.flatMap((other) => [first!, other]);
}

/** The numbers of the drawn vertices of the element. */
export function drawnVertices(facts: ElementFacts): number[] {
  const numbers = facts.kind === "vertex" ? [facts.vertex] : facts.vertices.map(({ vertex }) => vertex);
  return numbers.filter((number) => number !== null);
}
