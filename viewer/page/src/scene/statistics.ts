// SPDX-License-Identifier: BSD-3-Clause
// The center and the size of the graph, and the distances between its vertices. All of them ignore far outliers.
import { Box3, type Matrix3, type Matrix4, Quaternion, Vector3 } from "three";
import type { Frame, Structure, VertexGroup } from "../protocol/messages";

const MOST_SAMPLES = 10_000;
const MOST_NEIGHBOR_QUERIES = 100;

export interface Extent {
  box: Box3;
  /** The vertices inside the box, or a part of them. */
  sample: Vector3[];
}

export function isPoint(group: VertexGroup): boolean {
  return group.shape === "point" || group.shape === "corner";
}

/** Returns null if no vertex is drawn. `matrix` turns the positions (x, y, z of each vertex) into those of the scene. */
export function robustExtent(structure: Structure, positions: Float32Array, matrix: Matrix4): Extent | null {
  const poses = sampled(structure.vertices.filter((group) => !isPoint(group)), positions, matrix);
  const points = sampled(structure.vertices.filter(isPoint), positions, matrix);
  // A reconstruction has many points that are far off, so more of them are ignored.
  const inside = [...inliers(poses, 0.01), ...inliers(points, structure.is_bundle ? 0.08 : 0.02)];
  if (inside.length === 0) return null;
  return { box: new Box3().setFromPoints(inside), sample: inside };
}

/** The extent of both. */
export function union(a: Extent | null, b: Extent | null): Extent | null {
  if (!a || !b) return a ?? b;
  return { box: a.box.clone().union(b.box), sample: [...a.sample, ...b.sample] };
}

/**
 * Returns the median length of the odometry; otherwise that of other edges between poses; otherwise the typical distance
 * between neighbors; otherwise 0.
 */
export function typicalSpacing(structure: Structure, frame: Frame): number {
  const roles = ["odometry", "loop closure", "other"];
  const role = roles.find((candidate) => structure.edges.some((group) => group.role === candidate));
  const lengths: number[] = [];
  for (const group of structure.edges) {
    if (group.role !== role) continue;
    const stride = Math.ceil(group.count / MOST_SAMPLES);
    for (let line = group.first; line < group.first + group.count; line += stride) {
      const length = distance(frame.positions, structure.lines[2 * line]!, structure.lines[2 * line + 1]!);
      if (length > 0) lengths.push(length);
    }
  }
  return lengths.length > 0 ? median(lengths) : neighborSpacing(structure, frame);
}

/** Returns the mean direction (not normalized) in which the cameras look, in the scene. */
export function meanViewDirection(structure: Structure, frame: Frame, rotation: Matrix3): Vector3 {
  const sum = new Vector3();
  for (const group of structure.vertices) {
    if (group.shape !== "camera" && group.shape !== "camera back") continue;
    const sign = group.shape === "camera" ? 1 : -1;
    for (let vertex = group.first; vertex < group.first + group.count; ++vertex) {
      const axis = new Vector3(0, 0, 1).applyQuaternion(new Quaternion().fromArray(frame.orientations, 4 * vertex));
      if (Number.isFinite(axis.x + axis.y + axis.z)) sum.addScaledVector(axis, sign);
    }
  }
  return sum.applyMatrix3(rotation);
}

export function median(values: number[]): number {
  return quantile(values.sort((a, b) => a - b), 0.5);
}

function quantile(sorted: ArrayLike<number>, part: number): number {
  return sorted[Math.min(sorted.length - 1, Math.floor(part * sorted.length))]!;
}

function sampled(groups: VertexGroup[], positions: Float32Array, matrix: Matrix4): Vector3[] {
  const total = groups.reduce((sum, group) => sum + group.count, 0);
  const stride = Math.max(1, Math.ceil(total / MOST_SAMPLES));
  const samples: Vector3[] = [];
  for (const group of groups) {
    for (let vertex = group.first; vertex < group.first + group.count; vertex += stride) {
      const position = new Vector3().fromArray(positions, 3 * vertex);
      if (!Number.isNaN(position.x)) samples.push(position.applyMatrix4(matrix));
    }
  }
  return samples;
}

/** The points of the box that holds all but `ignored` of the points at each end of each axis, enlarged by a margin. */
function inliers(points: Vector3[], ignored: number): Vector3[] {
  if (points.length === 0) return [];
  const box = new Box3();
  for (const axis of ["x", "y", "z"] as const) {
    const sorted = Float64Array.from(points, (point) => point[axis]).sort();
    box.min[axis] = quantile(sorted, ignored);
    box.max[axis] = quantile(sorted, 1 - ignored);
  }
  const size = box.getSize(new Vector3());
  box.expandByScalar(0.4 * Math.max(size.x, size.y, size.z, 1e-9));
  return points.filter((point) => box.containsPoint(point));
}

function distance(positions: Float32Array, a: number, b: number): number {
  const x = positions[3 * a]! - positions[3 * b]!;
  const y = positions[3 * a + 1]! - positions[3 * b + 1]!;
  const z = positions[3 * a + 2]! - positions[3 * b + 2]!;
  return Math.sqrt(x * x + y * y + z * z);
}

/** Returns the median distance to the nearest neighbor among the poses, or among the points if there are no two poses. */
function neighborSpacing(structure: Structure, frame: Frame): number {
  const of = (groups: VertexGroup[]) => sampledNumbers(groups, frame);
  const poses = of(structure.vertices.filter((group) => !isPoint(group)));
  const vertices = poses.length > 1 ? poses : of(structure.vertices.filter(isPoint));
  const nearest: number[] = [];
  const stride = Math.max(1, Math.ceil(vertices.length / MOST_NEIGHBOR_QUERIES));
  for (let i = 0; i < vertices.length; i += stride) {
    let least = Infinity;
    for (const other of vertices) {
      const length = distance(frame.positions, vertices[i]!, other);
      if (length > 0 && length < least) least = length;
    }
    if (least < Infinity) nearest.push(least);
  }
  return nearest.length > 0 ? median(nearest) : 0;
}

function sampledNumbers(groups: VertexGroup[], frame: Frame): number[] {
  const total = groups.reduce((sum, group) => sum + group.count, 0);
  const stride = Math.max(1, Math.ceil(total / MOST_SAMPLES));
  const numbers: number[] = [];
  for (const group of groups) {
    for (let vertex = group.first; vertex < group.first + group.count; vertex += stride) {
      if (!Number.isNaN(frame.positions[3 * vertex])) numbers.push(vertex);
    }
  }
  return numbers;
}
