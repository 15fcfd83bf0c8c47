// SPDX-License-Identifier: BSD-3-Clause
// Tests of src/scene/ellipses.ts without a browser.
import assert from "node:assert/strict";
import test from "node:test";
import { load } from "./load.mjs";

const { unitBallMap } = await load("src/scene/ellipses.ts");

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
