// SPDX-License-Identifier: BSD-3-Clause
// Describes a vertex or an edge, as elements of the page.
import { count, counted, general } from "../format";
import type { EdgeEnd, EdgeFacts, ElementFacts, ElementName, VertexFacts } from "../protocol/element";
import { create } from "./dom";

/** chi2 per row of an outlier, as in the legend of edge colors. */
const OUTLIER = 10;

type Choose = (name: ElementName) => void;

/** `choose` is called with another element that the user wants to see. */
export function factsOf(facts: ElementFacts, choose: Choose): HTMLElement[] {
  return facts.kind === "vertex" ? vertexFacts(facts, choose) : edgeFacts(facts, choose);
}

function vertexFacts(facts: VertexFacts, choose: Choose): HTMLElement[] {
  const { id, type, tag, estimate, is_fixed, fixed_directions, edge_count, edges } = facts;
  const rows: [string, Node | string][] = [["Type", typeText(type, tag)]];
  if (estimate !== "") rows.push(["Estimate", numbers(estimate)]);
  const directions = fixed_directions.length > 0 ? `directions ${fixed_directions.join(", ")}` : "no";
  rows.push(["Fixed", is_fixed ? "yes" : directions]);
  const more = edge_count > edges.length ? `, the worst ${edges.length} of them:` : "";
  rows.push(["Edges", `${count(edge_count)}${more}`]);
  return [create("h2", {}, `Vertex ${id}`), list(rows), ...(edges.length > 0 ? [edgeTable(id, edges, choose)] : [])];
}

function edgeTable(id: string, edges: EdgeFacts[], choose: Choose): HTMLElement {
  const head = ["To", "chi2 / row", "Weight"].map((text) => create("th", { scope: "col" }, text));
  const rows = edges.map((edge) => {
    const others = edge.vertices.filter((end) => end.is_parameter || end.id !== id).map(endText);
    const go = create("button", { className: "link", title: typeText(edge.type, edge.tag) }, others.join(", ") || "prior");
    go.addEventListener("click", () => choose({ key: "edge", number: String(edge.edge) }));
    return create("tr", {}, create("td", {}, go),
      create("td", { className: isOutlier(edge) ? "outlier" : "" }, general(edge.chi2_per_row, 3)),
      create("td", {}, weightText(edge)));
  });
  return create("table", { id: "element-edges" },
    create("thead", {}, create("tr", {}, ...head)), create("tbody", {}, ...rows));
}

function edgeFacts(facts: EdgeFacts, choose: Choose): HTMLElement[] {
  const { type, tag, fields, vertices, vertex_count, rows: row_count, error, level } = facts;
  const rest = vertex_count > vertices.length ? [`and ${count(vertex_count - vertices.length)} more`] : [];
  const rows: [string, Node | string][] = [["Type", typeText(type, tag)]];
  rows.push(["Vertices", create("span", { id: "element-vertices" }, ...vertices.map((end) => endLink(end, choose)), ...rest)]);
  const more = row_count > error.length ? " …" : "";
  rows.push(["Error", numbers(error.map((value) => general(value, 5)).join("  ") + more)]);
  const chi2 = `${general(facts.chi2, 6)} (${general(facts.chi2_per_row, 3)} per row, ${counted(row_count, "row", "rows")})`;
  rows.push(["chi2", create("span", { className: isOutlier(facts) ? "outlier" : "" }, chi2)]);
  rows.push(["Weight", weightText(facts)]);
  if (facts.verdict) rows.push(["Verdict", create("span", { className: facts.verdict }, facts.verdict)]);
  if (level !== 0) rows.push(["Level", String(level)]);
  if (fields !== "") rows.push(["Measured, Ω", numbers(fields)]);
  return [create("h2", {}, `Edge ${vertices.map(endText).join(" – ")}`), list(rows)];
}

function endLink(end: EdgeEnd, choose: Choose): HTMLElement {
  if (end.is_parameter) return create("span", { title: end.type }, `${endText(end)} `);
  const link = create("button", { className: "link", title: end.type }, end.id);
  link.addEventListener("click", () => choose({ key: "id", number: end.id }));
  return create("span", {}, link, " ");
}

function endText({ id, is_parameter }: EdgeEnd): string {
  return is_parameter ? `parameter ${id}` : id;
}

function typeText(type: string, tag: string): string {
  return tag === "" ? type : `${type} · ${tag}`;
}

function weightText({ weight, kernel, is_enabled }: EdgeFacts): string {
  if (!is_enabled) return "disabled";
  return kernel === "" ? general(weight, 3) : `${general(weight, 3)} (${kernel})`;
}

/** A chi2 that is not finite is null. */
function isOutlier({ chi2_per_row }: EdgeFacts): boolean {
  return chi2_per_row === null || chi2_per_row >= OUTLIER;
}

function numbers(text: string): HTMLElement {
  return create("span", { className: "numbers" }, text);
}

function list(rows: [string, Node | string][]): HTMLElement {
  return create("dl", {}, ...rows.flatMap(([name, value]) => [create("dt", {}, name), create("dd", {}, value)]));
}
