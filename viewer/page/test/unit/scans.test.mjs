// SPDX-License-Identifier: BSD-3-Clause
// Tests of src/scene/scan_cloud.ts without a browser.
import assert from "node:assert/strict";
import test from "node:test";
import { load } from "./load.mjs";

const { placeScans } = await load("src/scene/scan_cloud.ts");

function placed(scans, positions, orientations) {
  const to = new Float32Array(scans.points.length).fill(99);
  placeScans({ ...scans, points: new Float32Array(scans.points) },
    { positions: new Float32Array(positions), orientations: new Float32Array(orientations) }, to);
  return [...to].map((x) => Math.round(1000 * x) / 1000 + 0);
}

test("points move and turn with their poses", () => {
  const half = Math.SQRT1_2;
  const scans = { vertices: [1, 0], counts: [2, 1], points: [1, 0, 0, 0, 2, 0, 0, 0, 3] };
  // Pose 1 turns x to y; pose 0 turns z to y (about x).
  const found = placed(scans, [10, 20, 30, 1, 2, 3], [-half, 0, 0, half, 0, 0, half, half]);
  assert.deepEqual(found, [1, 3, 3, -1, 2, 3, 10, 23, 30]);
});

test("points of a pose without a position are at the origin", () => {
  const scans = { vertices: [0, 1], counts: [1, 1], points: [1, 2, 3, 4, 5, 6] };
  assert.deepEqual(placed(scans, [NaN, NaN, NaN, 1, 1, 1], [0, 0, 0, 1, 0, 0, 0, 1]), [0, 0, 0, 5, 6, 7]);
});
