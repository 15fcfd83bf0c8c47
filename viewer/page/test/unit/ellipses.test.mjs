// SPDX-License-Identifier: BSD-3-Clause
// Tests of src/scene/ellipses.ts without a browser.
import assert from "node:assert/strict";
import test from "node:test";
import { load } from "./load.mjs";

const { HUGE, LARGE, limitRegions, unitBallMap } = await load("src/scene/ellipses.ts");

/** M Mᵀ of a matrix with these columns: xx, xy, xz, yy, yz, zz. */
function squared(columns) {
  const entry = (i, k) => [0, 3, 6].reduce((sum, column) => sum + columns[column + i] * columns[column + k], 0);
  return [[0, 0], [0, 1], [0, 2], [1, 1], [1, 2], [2, 2]].map(([i, k]) => entry(i, k));
}

function assertNear(found, wanted) {
  found.forEach((value, i) => assert.ok(Math.abs(value - wanted[i]) < 1e-9, `found ${found}, expected ${wanted}`));
}

test("the unit ball becomes the ellipsoid of two standard deviations", () => {
  const covariance = [4, 1, -1, 3, 0.5, 2];
  assertNear(squared(unitBallMap(covariance)), covariance.map((x) => 4 * x));
});

test("covariances of the plane, of lines, and of fixed vertices have flat ellipsoids", () => {
  for (const covariance of [[4, 1, 0, 3, 0, 0], [1, 2, 3, 4, 6, 9], [0, 0, 0, 1, 0, 0], [0, 0, 0, 0, 0, 0]]) {
    assertNear(squared(unitBallMap(covariance)), covariance.map((x) => 4 * x));
  }
});

test("a covariance that is not finite has no ellipsoid", () => {
  for (const wrong of [NaN, Infinity]) assert.deepEqual(unitBallMap([wrong, 0, 0, 1, 0, 1]), new Array(9).fill(0));
});

/** A ball with this size (the root of the sum of its squared semi-axes). */
function ball(vertex, size) {
  const axis = size / Math.sqrt(3);
  return { vertex, columns: [axis, 0, 0, 0, axis, 0, 0, 0, axis] };
}

function sizeOf({ columns }) {
  return Math.hypot(...columns);
}

test("large regions are outlines, huge ones are drawn smaller, and both are counted", () => {
  const extent = 50, large = 1.01 * LARGE * extent;
  const { outlined, filled, limited } = limitRegions([ball(4, 1), ball(5, 1e6), ball(6, 2), ball(7, large)], extent);
  assert.deepEqual(limited, { large: 2, drawn: 2, huge: 1 });
  assert.deepEqual(outlined.map(({ vertex }) => vertex), [4, 5, 6, 7]);
  assertNear(outlined.map(sizeOf), [1, HUGE * extent, 2, large]);
  assert.deepEqual(filled.map(({ vertex }) => vertex), [4, 6]);
  assertNear(filled.map(sizeOf), [1, 2]);
});

test("what is filled covers the graph only a few times, and small regions are filled first", () => {
  const regions = Array.from({ length: 2000 }, (_, i) => ball(i, i % 2 === 0 ? 0.001 : 0.049));
  const { filled, limited } = limitRegions(regions, 1);
  assert.equal(limited.large, 0);
  assert.ok(filled.reduce((sum, region) => sum + sizeOf(region) ** 2, 0) < 2);
  assert.equal(filled.filter(({ vertex }) => vertex % 2 === 0).length, 1000);
});

test("only some of many large regions are drawn, and all of them are counted", () => {
  const { outlined, filled, limited } = limitRegions(Array.from({ length: 2000 }, (_, i) => ball(i, i < 3 ? 0.01 : 7)), 1);
  assert.deepEqual(limited, { large: 1997, drawn: 80, huge: 1997 });
  assert.deepEqual([outlined.length, filled.length], [83, 3]);
});

test("a graph without an extent limits nothing", () => {
  const { filled, limited } = limitRegions([ball(0, 3)], 0);
  assert.deepEqual([filled.length, limited.large], [1, 0]);
});
