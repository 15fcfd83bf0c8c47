// SPDX-License-Identifier: BSD-3-Clause
// Tests of what src/model.ts knows of a run, without a browser.
import assert from "node:assert/strict";
import test from "node:test";
import { load } from "./load.mjs";

const { fitsPoorly, Model } = await load("src/model.ts");

function modelOf(facts) {
  const model = new Model();
  const run = { number: 1, first_row: 0, rows: [], status: "converged", headline: "", summary: "", ...facts };
  model.apply({ busy: false, file: null, run, log: { first: 0, lines: [] } });
  return model;
}

test("a run fits poorly if chi2 per degree of freedom is above 4", () => {
  const fits = (chi2_per_degree, degrees_of_freedom) => !fitsPoorly(modelOf({ chi2_per_degree, degrees_of_freedom }).run);
  assert.equal(fits(426.6, 1854), false);
  assert.equal(fits(1.1, 1854), true);
  assert.equal(fits(426.6, 3), true);
  assert.equal(fits(null, 1854), true);
});

test("a server that says nothing about start and stages has an ordinary run", () => {
  const { stages, start, false_edges, chi2_per_degree } = modelOf({}).run;
  assert.deepEqual({ stages, start, false_edges, chi2_per_degree }, { stages: [], start: null, false_edges: 0, chi2_per_degree: null });
});

test("a run keeps its stages and the number of its false edges", () => {
  const { stages, false_edges } = modelOf({ stages: ["odometry", "search"], false_edges: 12 }).run;
  assert.deepEqual({ stages, false_edges }, { stages: ["odometry", "search"], false_edges: 12 });
});
