// SPDX-License-Identifier: BSD-3-Clause
// Tests of src/protocol and src/model.ts without a browser.
import assert from "node:assert/strict";
import test from "node:test";
import { load } from "./load.mjs";

const { MessageReader } = await load("src/protocol/framing.ts");
const { decode } = await load("src/protocol/decode.ts");
const { chi2Sequence, Model } = await load("src/model.ts");
const { general } = await load("src/format.ts");

function message(kind, payload) {
  const bytes = new Uint8Array(8 + payload.length);
  const view = new DataView(bytes.buffer);
  view.setUint32(0, payload.length, true);
  view.setUint32(4, kind, true);
  bytes.set(payload, 8);
  return bytes;
}

/** A payload with arrays: its header, padded with blanks, and the bytes of the arrays. */
function arraysPayload(header, bytes) {
  let text = JSON.stringify(header);
  text = text.padEnd(4 * Math.ceil(text.length / 4));
  const payload = new Uint8Array(4 + text.length + bytes.length);
  new DataView(payload.buffer).setUint32(0, text.length, true);
  payload.set(new TextEncoder().encode(text), 4);
  payload.set(bytes, 4 + text.length);
  return payload;
}

test("messages arrive whole, however the stream is cut", () => {
  const stream = new Uint8Array([...message(0, []), ...message(3, [1, 2, 3, 4, 5]), ...message(0, []), ...message(1, [6])]);
  for (let size = 1; size <= stream.length; ++size) {
    const reader = new MessageReader();
    const found = [];
    for (let begin = 0; begin < stream.length; begin += size) found.push(...reader.push(stream.subarray(begin, begin + size)));
    assert.deepEqual(found.map(({ kind, payload }) => [kind, ...payload]), [[0], [3, 1, 2, 3, 4, 5], [0], [1, 6]]);
  }
});

test("a message that is too long is an error", () => {
  const bytes = message(2, []);
  new DataView(bytes.buffer).setUint32(0, 2 ** 31, true);
  assert.throws(() => new MessageReader().push(bytes), /2147483648 bytes/);
});

test("the arrays of a frame are views of its payload", () => {
  const numbers = new Float32Array([1, 2, NaN, 0, 0, 0, 1]);
  const header = {
    structure: 1, sequence: 2, iteration: 3, chi2: 4, center: [0, 0, 0],
    arrays: { positions: { type: "f32", offset: 0, count: 3 }, orientations: { type: "f32", offset: 12, count: 4 } },
  };
  const payload = arraysPayload(header, new Uint8Array(numbers.buffer));
  const { kind, frame } = decode({ kind: 3, payload });
  assert.equal(kind, "frame");
  assert.deepEqual([...frame.positions], [1, 2, NaN]);
  assert.deepEqual([...frame.orientations], [0, 0, 0, 1]);
  assert.equal(frame.positions.buffer, payload.buffer);
  assert.equal(frame.errors, null);
  assert.equal(frame.line_values, null);
  assert.equal(frame.uncertainty, null);
});

test("a structure may have laser scans", () => {
  const numbers = new Uint32Array([7, 2]), points = new Float32Array([1, 2, 3, 4, 5, 6]);
  const bytes = new Uint8Array([...new Uint8Array(numbers.buffer), ...new Uint8Array(points.buffer)]);
  const none = { edges: { type: "u32", offset: 0, count: 0 }, fixed: { type: "u8", offset: 0, count: 0 } };
  const scans = {
    scan_vertices: { type: "u32", offset: 0, count: 1 }, scan_counts: { type: "u32", offset: 4, count: 1 },
    scan_points: { type: "f32", offset: 8, count: 6 },
  };
  const structureOf = (arrays) => decode({ kind: 2, payload: arraysPayload({ arrays }, bytes) }).structure;
  const found = structureOf({ ...none, ...scans }).scans;
  assert.deepEqual([[...found.vertices], [...found.counts], [...found.points]], [[7], [2], [1, 2, 3, 4, 5, 6]]);
  assert.equal(structureOf(none).scans, null);
});

test("chi2 of the frame and chi2 of the lines are two things", () => {
  const numbers = new Float32Array([7, 8]);
  const none = { type: "f32", offset: 0, count: 0 };
  const arrays = { positions: none, orientations: none, chi2: { type: "f32", offset: 0, count: 2 } };
  const payload = arraysPayload({ chi2: 4, arrays }, new Uint8Array(numbers.buffer));
  const { frame } = decode({ kind: 3, payload });
  assert.equal(frame.chi2, 4);
  assert.deepEqual([...frame.line_values.chi2], [7, 8]);
  assert.equal(frame.line_values.weights, null);
});

test("a frame may tell the uncertainty of positions, or why it is not known", () => {
  const numbers = new Uint32Array([7, 9]), covariances = new Float32Array([1, 0, 0, 4, 0, 9, 1, 2, 3, 4, 5, 6]);
  const bytes = new Uint8Array([...new Uint8Array(numbers.buffer), ...new Uint8Array(covariances.buffer)]);
  const none = { positions: { type: "f32", offset: 0, count: 0 }, orientations: { type: "f32", offset: 0, count: 0 } };
  const arrays = { ...none, uncertain: { type: "u32", offset: 0, count: 2 }, covariances: { type: "f32", offset: 8, count: 12 } };
  const known = decode({ kind: 3, payload: arraysPayload({ uncertainty: "all", arrays }, bytes) }).frame.uncertainty;
  assert.deepEqual([known.note, [...known.vertices], [...known.covariances]], ["all", [7, 9], [...covariances]]);
  const unknown = decode({ kind: 3, payload: arraysPayload({ uncertainty: "why", arrays: none }, bytes) }).frame.uncertainty;
  assert.deepEqual([unknown.note, unknown.vertices.length], ["why", 0]);
  const not_wanted = decode({ kind: 3, payload: arraysPayload({ uncertainty: "", arrays: none }, bytes) }).frame.uncertainty;
  assert.equal(not_wanted, null);
});

test("a frame without positions, or with positions that are not floats, is an error", () => {
  const frame = (arrays) => ({ kind: 3, payload: arraysPayload({ arrays }, new Uint8Array(8)) });
  assert.throws(() => decode(frame({})), /positions is missing/);
  assert.throws(() => decode(frame({ positions: { type: "u32", offset: 0, count: 1 } })), /unexpected type/);
});

test("the truth has places, and a frame has the motion onto its estimates", () => {
  const header = { structure: 3, name: "t.g2o", matched: 1, arrays: { positions: { type: "f32", offset: 0, count: 3 } } };
  const { kind, truth } = decode({ kind: 6, payload: arraysPayload(header, new Uint8Array(new Float32Array([1, 2, 3]).buffer)) });
  assert.deepEqual([kind, truth.structure, truth.name, ...truth.positions], ["truth", 3, "t.g2o", 1, 2, 3]);
  const none = { positions: { type: "f32", offset: 0, count: 0 }, orientations: { type: "f32", offset: 0, count: 0 } };
  const fit = { rotation: [1, 0, 0, 0, 1, 0, 0, 0, 1], translation: [1, 2, 3], ate_m: 4, rpe_m: null, rpe_rad: null };
  assert.deepEqual(decode({ kind: 3, payload: arraysPayload({ truth: fit, arrays: none }, new Uint8Array(0)) }).frame.truth, fit);
});

test("messages of an unknown kind have no meaning", () => {
  assert.equal(decode({ kind: 99, payload: new Uint8Array(0) }), null);
});

const row = (iteration, chi2, chi2_decrease) => ({ iteration, chi2, chi2_decrease });
const state = (run, log = { first: 0, lines: [] }) => ({ busy: false, activity: "", run, log });

test("rows replace those from first_row on, and a new number begins a new table", () => {
  const model = new Model();
  const iterations = () => model.run.rows.map((each) => each.iteration);
  model.apply(state({ number: 1, first_row: 0, rows: [row(0), row(1)] }));
  model.apply(state({ number: 1, first_row: 2, rows: [row(2)] }));
  assert.deepEqual(iterations(), [0, 1, 2]);
  model.apply(state({ number: 1, first_row: 1, rows: [row(7)] }));
  assert.deepEqual(iterations(), [0, 7]);
  model.apply(state({ number: 2, first_row: 0, rows: [row(0)] }));
  assert.deepEqual(iterations(), [0]);
  model.apply(state(null));
  assert.equal(model.run, null);
});

test("the log grows, and a new stream begins it anew", () => {
  const model = new Model();
  const lines = (...texts) => texts.map((text) => ({ level: "info", text }));
  const texts = () => model.log.map((line) => line.text);
  model.apply(state(null, { first: 0, lines: lines("a", "b") }));
  model.apply(state(null, { first: 2, lines: lines("c") }));
  assert.deepEqual(texts(), ["a", "b", "c"]);
  model.apply(state(null, { first: 0, lines: lines("d") }));
  assert.deepEqual(texts(), ["d"]);
});

test("the sequence of chi2 begins before the first iteration", () => {
  assert.deepEqual(chi2Sequence({ rows: [row(0, 3, 4), row(1, 2, 1)] }, 9), [7, 3, 2]);
  assert.deepEqual(chi2Sequence({ rows: [] }, 9), [9]);
});

test("numbers have the asked number of digits, and no zeros at the end", () => {
  assert.equal(general(45.00469581, 9), "45.0046958");
  assert.equal(general(36067.807, 9), "36067.807");
  assert.equal(general(2546812345.6, 4), "2.547e9");
  assert.equal(general(0.0000627, 3), "6.27e-5");
  assert.equal(general(0, 9), "0");
  assert.equal(general(100, 3), "100");
  assert.equal(general(null, 9), "–");
});
