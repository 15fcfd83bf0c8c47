// SPDX-License-Identifier: BSD-3-Clause
// Finds what is drawn at a place of the picture, in one pass over the vertices and one over the lines.
import type { Matrix4 } from "three";

const VERTEX_PIXELS = 9, LINE_PIXELS = 6;
/** Of vertices that are this close, the one in front is meant. */
const SAME_PLACE_PIXELS = 3;

export interface Picked {
  key: "vertex" | "line";
  number: number;
}

export interface Pickable {
  /** x, y, z of each vertex. */
  positions: ArrayLike<number>;
  /** Two vertex numbers for each line. */
  lines: ArrayLike<number>;
  /** From the coordinates of the positions to those of the picture. */
  matrix: Matrix4;
  isVertexShown(vertex: number): boolean;
  isLineShown(line: number): boolean;
}

/** Where a picture of `width` × `height` pixels is asked, and the least depth that it shows. */
export interface Place {
  x: number;
  y: number;
  width: number;
  height: number;
  near: number;
}

/** A vertex is preferred to a line. Returns null if nothing is near. */
export function pick(scene: Pickable, place: Place): Picked | null {
  const projection = projected(scene, place);
  return nearestVertex(scene, projection, place) ?? nearestLine(scene, projection, place);
}

/** x w, y w and w of each vertex, with x and y in pixels from the place. */
function projected({ positions, matrix }: Pickable, { x, y, width, height }: Place): Float64Array {
  const m = matrix.elements;
  const result = new Float64Array(positions.length);
  for (let i = 0; i < positions.length; i += 3) {
    const a = positions[i]!, b = positions[i + 1]!, c = positions[i + 2]!;
    const w = m[3] * a + m[7] * b + m[11] * c + m[15];
    result[i] = 0.5 * width * (m[0] * a + m[4] * b + m[8] * c + m[12] + w) - x * w;
    result[i + 1] = 0.5 * height * (w - (m[1] * a + m[5] * b + m[9] * c + m[13])) - y * w;
    result[i + 2] = w;
  }
  return result;
}

function nearestVertex(scene: Pickable, projection: Float64Array, { near }: Place): Picked | null {
  let best = -1, best_distance = VERTEX_PIXELS, best_depth = Infinity;
  for (let vertex = 0; 3 * vertex < projection.length; ++vertex) {
    const w = projection[3 * vertex + 2]!;
    if (!(w > near)) continue;
    const distance = Math.max(SAME_PLACE_PIXELS, Math.hypot(projection[3 * vertex]! / w, projection[3 * vertex + 1]! / w));
    if (!(distance < best_distance || (distance === best_distance && w < best_depth))) continue;
    if (!scene.isVertexShown(vertex)) continue;
    best = vertex;
    best_distance = distance;
    best_depth = w;
  }
  return best < 0 ? null : { key: "vertex", number: best };
}

function nearestLine(scene: Pickable, projection: Float64Array, { near }: Place): Picked | null {
  let best = -1, best_distance = LINE_PIXELS;
  for (let line = 0; 2 * line < scene.lines.length; ++line) {
    const distance = distanceToLine(projection, scene.lines[2 * line]!, scene.lines[2 * line + 1]!, near);
    if (!(distance < best_distance) || !scene.isLineShown(line)) continue;
    best = line;
    best_distance = distance;
  }
  return best < 0 ? null : { key: "line", number: best };
}

/** In pixels; Infinity if the whole line is behind the camera. */
function distanceToLine(projection: Float64Array, from: number, to: number, near: number): number {
  let [ax, ay, aw] = [projection[3 * from]!, projection[3 * from + 1]!, projection[3 * from + 2]!];
  let [bx, by, bw] = [projection[3 * to]!, projection[3 * to + 1]!, projection[3 * to + 2]!];
  if (aw <= near && bw <= near) return Infinity;
  if (aw <= near || bw <= near) {
    const t = (near - aw) / (bw - aw);
    const [x, y] = [ax + t * (bx - ax), ay + t * (by - ay)];
    if (aw <= near) [ax, ay, aw] = [x, y, near];
    else [bx, by, bw] = [x, y, near];
  }
  const x = ax / aw, y = ay / aw;
  const dx = bx / bw - x, dy = by / bw - y;
  const squared_length = dx * dx + dy * dy;
  const along = squared_length > 0 ? Math.min(1, Math.max(0, -(x * dx + y * dy) / squared_length)) : 0;
  return Math.hypot(x + along * dx, y + along * dy);
}
