// SPDX-License-Identifier: BSD-3-Clause
// Tests of src/protocol/diagnosis.ts without a browser.
import assert from "node:assert/strict";
import test from "node:test";
import { load } from "./load.mjs";

const { canMark, markText } = await load("src/protocol/diagnosis.ts");

function finding(vertices, edges) {
  const marked = Array.from({ length: Math.min(vertices, 10_000) }, (_, i) => i);
  return {
    element: null,
    vertices: { count: vertices, marked },
    edges: { count: edges, marked: Math.min(edges, 10_000), lines: [] },
  };
}

test("the text says what is marked", () => {
  assert.equal(markText(finding(1, 0)), "1 vertex is marked.");
  assert.equal(markText(finding(0, 1)), "1 edge is marked.");
  assert.equal(markText(finding(2, 0)), "2 vertices are marked.");
  assert.equal(markText(finding(1, 1)), "1 vertex and 1 edge are marked.");
});

test("the text says what is too much to be marked", () => {
  assert.equal(markText(finding(12_345, 0)), "10,000 of 12,345 vertices are marked.");
  assert.equal(markText(finding(0, 10_001)), "10,000 of 10,001 edges are marked.");
});

test("nothing is said of a finding without elements", () => {
  assert.equal(markText(finding(0, 0)), "");
  assert.equal(canMark(finding(0, 0)), false);
  assert.equal(canMark({ ...finding(0, 0), element: { key: "edge", number: "3" } }), true);
  assert.equal(canMark(finding(0, 1)), true);
});
