// SPDX-License-Identifier: BSD-3-Clause
// Turns payloads into messages. The arrays are views of the payload; nothing is copied.
import type { Diagnosis } from "./diagnosis";
import type { Form, Frame, Message, Pattern, Scans, StateMessage, Structure, Truth, Uncertainty } from "./messages";
import type { RawMessage } from "./framing";

interface ArrayEntry {
  type: "f32" | "u32" | "u8";
  offset: number;
  count: number;
}

type Numbers = Float32Array | Uint32Array | Uint8Array;

const TYPES = { f32: Float32Array, u32: Uint32Array, u8: Uint8Array };

/** Returns null if the kind has no meaning for this page. */
export function decode(message: RawMessage): Message | null {
  switch (message.kind) {
    case 1:
      return { kind: "state", state: parseJson(message.payload) as StateMessage };
    case 2:
      return { kind: "structure", structure: decodeStructure(message.payload) };
    case 3:
      return { kind: "frame", frame: decodeFrame(message.payload) };
    case 4:
      return { kind: "form", form: parseJson(message.payload) as Form };
    case 5:
      return { kind: "pattern", pattern: decodePattern(message.payload) };
    case 6:
      return { kind: "truth", truth: decodeTruth(message.payload) };
    case 7:
      return { kind: "diagnosis", diagnosis: parseJson(message.payload) as Diagnosis };
    default:
      return null;
  }
}

function decodeStructure(payload: Uint8Array<ArrayBuffer>): Structure {
  const { header, arrays } = decodeArrays(payload);
  return {
    ...(header as unknown as Structure),
    lines: required(arrays, "edges", Uint32Array),
    fixed: required(arrays, "fixed", Uint8Array),
    track_lengths: optional(arrays, "track_lengths", Uint32Array),
    scans: scansOf(arrays),
  };
}

function scansOf(arrays: Map<string, Numbers>): Scans | null {
  const vertices = optional(arrays, "scan_vertices", Uint32Array);
  if (!vertices) return null;
  const counts = required(arrays, "scan_counts", Uint32Array), points = required(arrays, "scan_points", Float32Array);
  return { vertices, counts, points };
}

function decodeFrame(payload: Uint8Array<ArrayBuffer>): Frame {
  const { header, arrays } = decodeArrays(payload);
  const chi2 = optional(arrays, "chi2", Float32Array);
  const { uncertainty: note } = header as { uncertainty?: string };
  return {
    ...(header as unknown as Frame),
    positions: required(arrays, "positions", Float32Array),
    orientations: required(arrays, "orientations", Float32Array),
    errors: optional(arrays, "errors", Float32Array),
    line_values: chi2 && {
      chi2,
      weights: optional(arrays, "weights", Float32Array),
      verdicts: optional(arrays, "verdicts", Uint8Array),
    },
    uncertainty: note ? uncertaintyOf(note, arrays) : null,
  };
}

function uncertaintyOf(note: string, arrays: Map<string, Numbers>): Uncertainty {
  return {
    note,
    vertices: optional(arrays, "uncertain", Uint32Array) ?? new Uint32Array(0),
    covariances: optional(arrays, "covariances", Float32Array) ?? new Float32Array(0),
  };
}

function decodeTruth(payload: Uint8Array<ArrayBuffer>): Truth {
  const { header, arrays } = decodeArrays(payload);
  return { ...(header as unknown as Truth), positions: required(arrays, "positions", Float32Array) };
}

function decodePattern(payload: Uint8Array<ArrayBuffer>): Pattern {
  const { header, arrays } = decodeArrays(payload);
  const pattern = header as unknown as Pattern;
  const pictures = pattern.pictures.map((each) => ({ ...each, counts: required(arrays, each.name, Uint32Array) }));
  return { ...pattern, pictures };
}

function decodeArrays(payload: Uint8Array<ArrayBuffer>) {
  const header_bytes = new DataView(payload.buffer).getUint32(0, true);
  const header = parseJson(payload.subarray(4, 4 + header_bytes)) as { arrays: Record<string, ArrayEntry> };
  const arrays = new Map<string, Numbers>();
  for (const [name, entry] of Object.entries(header.arrays)) {
    arrays.set(name, new TYPES[entry.type](payload.buffer, 4 + header_bytes + entry.offset, entry.count));
  }
  return { header, arrays };
}

function parseJson(bytes: Uint8Array): unknown {
  return JSON.parse(new TextDecoder().decode(bytes));
}

function optional<T extends Numbers>(arrays: Map<string, Numbers>, name: string, type: new () => T): T | null {
  const array = arrays.get(name);
  if (array === undefined) return null;
  if (!(array instanceof type)) throw new Error(`the array ${name} has an unexpected type of numbers`);
  return array;
}

function required<T extends Numbers>(arrays: Map<string, Numbers>, name: string, type: new () => T): T {
  const array = optional(arrays, name, type);
  if (!array) throw new Error(`the array ${name} is missing`);
  return array;
}
