// SPDX-License-Identifier: BSD-3-Clause
// How uncertain positions are: ellipses in the plane, ellipsoids in space. Their surface is two standard deviations away from the
// position.
import {
  BufferAttribute, type Color, InstancedBufferAttribute, InstancedBufferGeometry, LineSegments, Mesh, type ShaderMaterial,
  SphereGeometry,
} from "three";
import type { Frame, VertexGroup } from "../protocol/messages";
import { ellipseMaterial } from "./materials";
import { spreadOrder } from "./spread";
import type { Vertices } from "./vertices";

const SIGMAS = 2;
const CORNERS = 48;
const FILL_OPACITY = 0.16, OUTLINE_OPACITY = 0.7;
/** Over edges; in the plane, also under poses and points. */
const RENDER_ORDER = 0.5;

type Part = (Mesh | LineSegments) & { geometry: InstancedBufferGeometry; material: ShaderMaterial };

export class Ellipses {
  /** The filled shapes and their outlines. */
  readonly parts: [Part, Part];
  /** The numbers of the vertices, in the order in which they are drawn. */
  private vertices: number[] = [];
  private hidden: VertexGroup[] = [];
  private readonly is_flat: boolean;

  constructor(dimension: number) {
    this.is_flat = dimension === 2;
    this.parts = [
      new Mesh(new InstancedBufferGeometry(), ellipseMaterial(FILL_OPACITY)),
      new LineSegments(new InstancedBufferGeometry(), ellipseMaterial(OUTLINE_OPACITY)),
    ];
    for (const part of this.parts) {
      part.frustumCulled = false;
      part.renderOrder = RENDER_ORDER;
      // Many are smaller than the shape of their pose.
      part.material.depthTest = false;
    }
    this.build([], new Float32Array(0), () => [0, 0, 0]);
  }

  update({ uncertainty, positions }: Frame, vertices: Vertices): void {
    if (!uncertainty && this.vertices.length === 0) return;
    const numbers = uncertainty?.vertices ?? new Uint32Array(0);
    const order = [...spreadOrder(numbers.length)];
    this.vertices = order.map((i) => numbers[i]!);
    this.build(order, positions, (i) => uncertainty!.covariances.subarray(6 * i, 6 * i + 6));
    this.updateVisible(vertices);
  }

  /** Hides the ellipses of these types. */
  hide(groups: VertexGroup[], vertices: Vertices): void {
    this.hidden = groups;
    this.updateVisible(vertices);
  }

  updateVisible({ visible }: Vertices): void {
    const isHidden = (vertex: number) =>
      this.hidden.some(({ first, count }) => vertex >= first && vertex < first + count);
    const attribute = this.parts[0].geometry.getAttribute("instance_visible");
    this.vertices.forEach((vertex, i) => attribute.setX(i, visible[vertex] === 1 && !isHidden(vertex) ? 1 : 0));
    attribute.needsUpdate = true;
  }

  set shown(shown: boolean) {
    for (const part of this.parts) part.visible = shown;
  }

  setColor(color: Color): void {
    for (const part of this.parts) part.material.uniforms["color"]!.value.copy(color);
  }

  /** The number of ellipses that are drawn if the budget allows it. */
  get drawableCount(): number {
    return this.parts[0].visible ? this.vertices.length : 0;
  }

  /** Draws only a part (0 to 1) of the ellipses. */
  drawPart(part: number): void {
    for (const { geometry } of this.parts) geometry.instanceCount = Math.ceil(this.vertices.length * part);
  }

  dispose(): void {
    for (const { geometry, material } of this.parts) {
      geometry.dispose();
      material.dispose();
    }
  }

  /** `order` are the numbers of the covariances. */
  private build(order: number[], positions: Float32Array, covariance: (i: number) => ArrayLike<number>): void {
    const axes = order.map((i) => unitBallMap(covariance(i)));
    const attribute = (values: number[], items: number) => new InstancedBufferAttribute(new Float32Array(values), items);
    const column = (k: number) => attribute(axes.flatMap((axis) => axis.slice(3 * k, 3 * k + 3)), 3);
    const places = this.vertices.flatMap((vertex) => [...positions.subarray(3 * vertex, 3 * vertex + 3)]);
    const attributes = {
      instance_position: attribute(places.map((x) => (Number.isNaN(x) ? 0 : x)), 3),
      instance_x: column(0),
      instance_y: column(1),
      instance_z: column(2),
      instance_visible: attribute(order.map(() => 0), 1),
    };
    const shapes = this.is_flat ? [disc(), circles(1)] : [ball(), circles(3)];
    this.parts.forEach((part, i) => {
      part.geometry.dispose();
      part.geometry = shapes[i]!;
      part.geometry.instanceCount = order.length;
      for (const [name, values] of Object.entries(attributes)) part.geometry.setAttribute(name, values);
    });
  }
}

/**
 * The columns of a matrix that maps the unit ball to the ellipsoid of a covariance (xx, xy, xz, yy, yz, zz): the Cholesky factor,
 * times SIGMAS. Zeros if a number is not finite.
 */
export function unitBallMap(covariance: ArrayLike<number>): number[] {
  const [xx, xy, xz, yy, yz, zz] = Array.from(covariance) as [number, number, number, number, number, number];
  const root = (x: number) => Math.sqrt(Math.max(0, x));
  const ratio = (a: number, b: number) => (b > 0 ? a / b : 0);
  const a = root(xx), b = ratio(xy, a), c = ratio(xz, a);
  const d = root(yy - b * b), e = ratio(yz - b * c, d);
  const f = root(zz - c * c - e * e);
  const columns = [a, b, c, 0, d, e, 0, 0, f].map((x) => SIGMAS * x);
  return columns.every(Number.isFinite) ? columns : columns.map(() => 0);
}

function disc(): InstancedBufferGeometry {
  const corners = Array.from({ length: CORNERS }, (_, i) => [...corner(i), ...corner(i + 1), 0, 0, 0]);
  return geometryOf(corners.flat());
}

function ball(): InstancedBufferGeometry {
  const sphere = new SphereGeometry(1, 16, 12);
  const geometry = geometryOf([...sphere.getAttribute("position").array]);
  geometry.setIndex(sphere.getIndex());
  return geometry;
}

/** Unit circles in the planes xy, yz and zx, or in the first of them. */
function circles(planes: 1 | 3): InstancedBufferGeometry {
  const lines = Array.from({ length: planes }, (_, plane) =>
    Array.from({ length: 2 * CORNERS }, (_, i) => {
      const [x, y, z] = corner(Math.ceil(i / 2));
      return [[x, y, z], [z, x, y], [y, z, x]][plane]!;
    }));
  return geometryOf(lines.flat(2));
}

function corner(i: number): [number, number, number] {
  const angle = (2 * Math.PI * i) / CORNERS;
  return [Math.cos(angle), Math.sin(angle), 0];
}

function geometryOf(corners: number[]): InstancedBufferGeometry {
  const geometry = new InstancedBufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(new Float32Array(corners), 3));
  return geometry;
}
