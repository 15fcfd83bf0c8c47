// SPDX-License-Identifier: BSD-3-Clause
// Tests of the parts of src/scene that need no browser.
import assert from "node:assert/strict";
import test from "node:test";
import { load } from "./load.mjs";

const { levelCounts, levelNames, levelsOf, linesOfLevel } = await load("src/scene/edge_levels.ts");

test("the levels of chi2 are logarithmic, and values that are no numbers are outliers", () => {
  const chi2 = new Float32Array([0, 0.05, 0.5, 2, 5, 10, 1e9, Infinity, NaN]);
  assert.deepEqual([...levelsOf("chi2", { chi2, weights: null, verdicts: null })], [0, 1, 2, 3, 4, 5, 5, 5, 5]);
  assert.deepEqual(levelNames("chi2").map(([level]) => level), [0, 1, 2, 3, 4, 5]);
});

test("small weights are outliers, and without weights there are none", () => {
  const chi2 = new Float32Array(4);
  const weights = new Float32Array([1, 0.5, 0.001, NaN]);
  assert.deepEqual([...levelsOf("weight", { chi2, weights, verdicts: null })], [0, 1, 5, 5]);
  assert.deepEqual([...levelsOf("weight", { chi2, weights: null, verdicts: null })], [0, 0, 0, 0]);
});

test("verdicts have levels of their own, and without verdicts there are no outliers", () => {
  const chi2 = new Float32Array(4), verdicts = Uint8Array.from([0, 1, 2, 3]);
  assert.deepEqual([...levelsOf("verdict", { chi2, weights: null, verdicts })], [0, 2, 3, 5]);
  assert.deepEqual([...levelsOf("verdict", { chi2, weights: null, verdicts: null })], [0, 0, 0, 0]);
  assert.deepEqual(levelNames("verdict").at(-1), [5, "outlier"]);
});

test("each line of a group belongs to one level", () => {
  const lines = Uint32Array.from([0, 1, 1, 2, 2, 3, 3, 4]);
  const levels = Uint8Array.from([5, 0, 5, 0]);
  assert.deepEqual([...linesOfLevel(lines, 1, 3, levels, 5)], [2, 3]);
  assert.deepEqual([...linesOfLevel(lines, 1, 3, levels, 0)], [1, 2, 3, 4]);
  assert.deepEqual(levelCounts(levels), [2, 0, 0, 0, 0, 2]);
});
