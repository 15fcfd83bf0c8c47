// SPDX-License-Identifier: BSD-3-Clause
// Tests of src/time_line.ts, and of the runs that src/model.ts tells apart, without a browser.
import assert from "node:assert/strict";
import test from "node:test";
import { load } from "./load.mjs";

const { TimeLine } = await load("src/time_line.ts");
const { iterationAt, Model, placeOf } = await load("src/model.ts");

const BYTES = 12;

/** A frame of one vertex. */
function frame(iteration, chi2 = 100 - iteration) {
  return { iteration, chi2, positions: new Float32Array(BYTES / 4) };
}

function iterations(line) {
  return line.moments.map(({ iteration }) => iteration);
}

function lineOf(...frames) {
  const line = new TimeLine();
  for (const each of frames) line.add(each, each.iteration);
  return line;
}

test("a run has the frame before it and those of its iterations", () => {
  const line = lineOf(frame(0), frame(1), frame(3));
  assert.deepEqual(iterations(line), [0, 1, 3]);
  assert.equal(line.newest.frame.chi2, 97);
});

test("the last frame of a run replaces that of the same iteration", () => {
  const line = lineOf(frame(0), frame(1), frame(2, 50), frame(2, 49));
  assert.deepEqual(iterations(line), [0, 1, 2]);
  assert.equal(line.newest.frame.chi2, 49);
});

test("a run begins with the newest frame of the run before", () => {
  const line = lineOf(frame(0), frame(1), frame(2, 49));
  line.beginRun();
  line.add(frame(1, 48), 1);
  assert.deepEqual(line.moments.map(({ iteration, frame: { chi2 } }) => [iteration, chi2]), [[0, 49], [1, 48]]);
});

test("a frame of iteration 0, as after a reset, begins anew", () => {
  assert.deepEqual(iterations(lineOf(frame(0), frame(1), frame(0))), [0]);
});

test("a frame of the run before that comes late is where the run begins", () => {
  const line = lineOf(frame(0), frame(1));
  line.beginRun();
  line.add(frame(5), 0);
  line.add(frame(1), 1);
  assert.deepEqual(line.moments.map(({ iteration, frame: { chi2 } }) => [iteration, chi2]), [[0, 95], [1, 99]]);
});

test("when the memory is full, every other frame goes, but neither the first nor the last one", () => {
  const line = new TimeLine(10 * BYTES);
  for (let iteration = 0; iteration <= 37; ++iteration) {
    line.add(frame(iteration), iteration);
    assert.ok(line.moments.length <= 10);
    assert.equal(iterations(line).at(0), 0);
    assert.equal(iterations(line).at(-1), iteration);
  }
  assert.deepEqual(iterations(line), [0, 8, 16, 24, 32, 37]);
});

test("two frames are kept even if they are too large", () => {
  const line = new TimeLine(1);
  for (const iteration of [0, 1, 2]) line.add(frame(iteration), iteration);
  assert.deepEqual(iterations(line), [0, 2]);
});

test("frames of attempts that the run gave up are forgotten", () => {
  const line = lineOf(frame(0), frame(1, 70), frame(2, 60), frame(3, 50));
  line.settle([{ chi2: 80 }, { chi2: 60 }, { chi2: 50 }]);
  assert.deepEqual(iterations(line), [0, 2, 3]);
});

test("an iteration is where it came last, after those of attempts that were given up", () => {
  const rows = [1, 2, 1, 2, 3].map((iteration) => ({ iteration }));
  assert.deepEqual([0, 1, 2, 3].map((iteration) => placeOf(iteration, rows)), [0, 3, 4, 5]);
  assert.deepEqual([0, 1, 2, 3, 4, 5].map((place) => iterationAt(place, rows)), [0, 1, 2, 1, 2, 3]);
});

/** The ids of the runs after messages with these numbers and statuses; null is a state without a run. */
function runIds(...messages) {
  const model = new Model();
  return messages.map((message) => {
    const run = message && { number: message[0], status: message[1], first_row: 0, rows: [], headline: "", summary: "" };
    model.apply({ run, log: { first: 0, lines: [] } });
    return model.run?.id ?? null;
  });
}

test("the end of a run belongs to it, though the number of its table changes", () => {
  assert.deepEqual(runIds([1, "running"], [1, "running"], [2, "converged"]), [1, 1, 1]);
});

test("a run that ended before the page saw it run is another one", () => {
  assert.deepEqual(runIds([2, "converged"], [4, "converged"], [7, "running"]), [1, 2, 3]);
});

test("a run after a reset is another one", () => {
  assert.deepEqual(runIds([2, "converged"], null, [4, "running"]), [1, null, 2]);
});
