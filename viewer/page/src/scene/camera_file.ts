// SPDX-License-Identifier: BSD-3-Clause
// A camera as a small JSON file.
import { asRecord } from "../stored";
import type { CameraState, Triple } from "./camera_rig";

const FORMAT = "boxplus camera 1";

export function cameraToText(camera: CameraState): string {
  return `${JSON.stringify({ format: FORMAT, ...camera }, null, 2)}\n`;
}

/** Throws an Error with the reason if the text is no camera. */
export function cameraFromText(text: string): CameraState {
  const { format, kind, position, target, height } = asRecord(parsed(text));
  if (format !== FORMAT) throw new Error("it is not a file that “Save camera” made");
  if (!isPlace(target)) throw new Error("“target” must be three numbers");
  if (kind === "orthographic") {
    if (!isNumber(height) || height <= 0) throw new Error("“height” must be a number > 0");
    return { kind, target, height };
  }
  if (kind !== "perspective") throw new Error("“kind” must be “perspective” or “orthographic”");
  if (!isPlace(position)) throw new Error("“position” must be three numbers");
  if (position.every((value, i) => value === target[i])) throw new Error("“position” must differ from “target”");
  return { kind, position, target };
}

function parsed(text: string): unknown {
  try {
    return JSON.parse(text);
  } catch {
    return null;
  }
}

function isNumber(value: unknown): value is number {
  return typeof value === "number" && Number.isFinite(value);
}

function isPlace(value: unknown): value is Triple {
  return Array.isArray(value) && value.length === 3 && value.every(isNumber);
}
