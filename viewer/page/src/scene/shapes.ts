// SPDX-License-Identifier: BSD-3-Clause
// The shapes of poses and cameras, about one unit long. `tint` multiplies the color of the vertex.
import { BufferAttribute, InstancedBufferGeometry } from "three";

export type ShapeName = "triangle" | "wedge" | "axes" | "camera" | "camera back";

type Triple = readonly [number, number, number];

interface Shape {
  /** Pairs of corners are lines if `is_lines`, otherwise three corners are a triangle. */
  is_lines: boolean;
  corners: Triple[];
  tints: Triple[];
}

export function shapeIsLines(name: ShapeName): boolean {
  return SHAPES[name]().is_lines;
}

export function shapeGeometry(name: ShapeName): InstancedBufferGeometry {
  const { corners, tints } = SHAPES[name]();
  const geometry = new InstancedBufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(new Float32Array(corners.flat()), 3));
  geometry.setAttribute("tint", new BufferAttribute(new Float32Array(tints.flat()), 3));
  return geometry;
}

const SHAPES: Record<ShapeName, () => Shape> = {
  triangle,
  wedge,
  axes,
  camera: () => pyramid(1),
  "camera back": () => pyramid(-1),
};

/** Points along x, in the plane z = 0. */
function triangle(): Shape {
  return {
    is_lines: false,
    corners: [[0.65, 0, 0], [-0.35, 0.36, 0], [-0.35, -0.36, 0]],
    tints: gray([1, 1, 1]),
  };
}

/** Points along x; its fin points along z. */
function wedge(): Shape {
  const nose: Triple = [0.65, 0, 0], left: Triple = [-0.35, 0.34, 0], right: Triple = [-0.35, -0.34, 0];
  const fin: Triple = [-0.35, 0, 0.28];
  return {
    is_lines: false,
    corners: [nose, left, right, nose, left, fin, nose, right, fin, left, right, fin],
    tints: [0.62, 1, 0.84, 0.72].flatMap((shade) => gray([shade, shade, shade])),
  };
}

/** x, y and z in colors that color-blind people can distinguish. */
function axes(): Shape {
  const x: Triple = [0.9, 0.38, 0.1], y: Triple = [0.1, 0.68, 0.48], z: Triple = [0.22, 0.55, 1];
  return {
    is_lines: true,
    corners: [[0, 0, 0], [0.7, 0, 0], [0, 0, 0], [0, 0.7, 0], [0, 0, 0], [0, 0, 0.7]],
    tints: [x, x, y, y, z, z],
  };
}

/** Looks along +z with y down if `sign` is 1; along −z with y up if it is −1. */
function pyramid(sign: 1 | -1): Shape {
  const corner = (x: number, y: number): Triple => [0.5 * x, -0.375 * sign * y, 0.8 * sign];
  const tip: Triple = [0, 0, 0];
  const base = [corner(-1, 1), corner(1, 1), corner(1, -1), corner(-1, -1)];
  const roof = [corner(-0.5, 1.12), corner(0, 1.7), corner(0.5, 1.12)];
  const corners = [
    ...base.flatMap((from) => [tip, from]),
    ...loop(base),
    ...loop(roof),
  ];
  return { is_lines: true, corners, tints: gray(corners.map(() => 1)) };
}

function loop(corners: Triple[]): Triple[] {
  return corners.flatMap((from, i) => [from, corners[(i + 1) % corners.length]!]);
}

function gray(shades: number[]): Triple[] {
  return shades.map((shade) => [shade, shade, shade]);
}
