// SPDX-License-Identifier: BSD-3-Clause
// Tests of what src/scene/ draws of graphs with many edges, without a browser.
import assert from "node:assert/strict";
import test from "node:test";
import { load } from "./load.mjs";

// The module of the theme asks for that of the system.
globalThis.matchMedia = () => ({ matches: false, addEventListener() {} });
const { GraphScene } = await load("src/scene/graph_scene.ts");

/** A path of poses, with closures between its ends. */
function scene(poses, closures) {
  const lines = [];
  for (let i = 1; i < poses; ++i) lines.push(i - 1, i);
  for (let i = 0; i < closures; ++i) lines.push(0, poses - 1);
  const graph = new GraphScene({
    dimension: 2, is_bundle: false, leveling: [1, 0, 0, 0, 1, 0, 0, 0, 1], scans: null, track_lengths: null, left_out: 0,
    vertices: [{ name: "SE2", shape: "pose", first: 0, count: poses }],
    edges: [{ name: "Between<SE2>", role: "odometry", first: 0, count: poses - 1 },
      { name: "Between<SE2>", role: "loop closure", first: poses - 1, count: closures }],
    lines: Uint32Array.from(lines), fixed: new Uint8Array(poses),
  });
  show(graph, poses, 1);
  return graph;
}

/** Poses along x at this distance from each other. */
function show(graph, poses, spacing) {
  const positions = new Float32Array(3 * poses);
  for (let i = 0; i < poses; ++i) positions[3 * i] = spacing * i;
  const orientations = new Float32Array(4 * poses).fill(0.5);
  graph.update({ center: [0, 0, 0], positions, orientations, errors: null, line_values: null, uncertainty: null, truth: null });
}

function edges(graph) {
  const [odometry, closures] = graph.edges;
  return { odometry, closures };
}

function opacity({ object }) {
  return object.material.uniforms.opacity.value;
}

test("long loop closures are faint if there are many, and odometry is not", () => {
  const few = edges(scene(100, 20)), many = edges(scene(100, 4000));
  assert.ok(opacity(many.closures) < 0.1 * opacity(few.closures), `${opacity(many.closures)} of ${opacity(few.closures)}`);
  assert.ok(opacity(many.closures) > 0);
  assert.equal(opacity(many.odometry), opacity(few.odometry));
});

test("while the camera moves, the odometry stays and closures make room", () => {
  const graph = scene(100, 4000);
  graph.limit({ lines: 500, poses: Infinity, points: Infinity });
  const { odometry, closures } = edges(graph);
  assert.equal(odometry.object.geometry.drawRange.count, 2 * 99);
  assert.equal(closures.object.geometry.drawRange.count, 2 * 401);
});
