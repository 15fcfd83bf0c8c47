// SPDX-License-Identifier: BSD-3-Clause
// How uncertain positions are: ellipses in the plane, ellipsoids in space. Their surface is two standard deviations away from the
// position. Transparent areas that cover the whole picture many times take seconds without a graphics card and hide the graph, so
// of the regions that are large relative to the graph, only some are drawn, and without filling; huge ones are drawn smaller. Many
// regions have fewer corners.
import {
  BufferAttribute, type Color, InstancedBufferAttribute, InstancedBufferGeometry, LineSegments, Mesh, type ShaderMaterial,
} from "three";
import type { Frame, VertexGroup } from "../protocol/messages";
import { ellipseMaterial } from "./materials";
import { spreadOrder } from "./spread";
import type { Vertices } from "./vertices";

const SIGMAS = 2;
/** Sizes relative to the extent of the graph; the size of a region is the root of the sum of its squared semi-axes. */
export const LARGE = 0.05, HUGE = 0.1;
/** The number of regions that are drawn of those that are large or huge. */
const MOST_LARGE = 80;
/** The sum of the squared sizes of all filled regions, in the same unit: about how often they cover the picture. */
const MOST_FILLED = 0.8;
/** Of all outlines together, and of each of them. The server sends at most 2000 regions. */
const MOST_LINES = 18_000, MOST_CORNERS = 48;
const FILL_OPACITY = 0.16, OUTLINE_OPACITY = 0.7;
/** Over edges; in the plane, also under poses and points. */
const RENDER_ORDER = 0.5;

type Part = (Mesh | LineSegments) & { geometry: InstancedBufferGeometry; material: ShaderMaterial };

/** A vertex and the columns of the matrix that maps the unit ball to its region. */
interface Region {
  vertex: number;
  columns: number[];
}

/** The number of regions that are large or huge, of those of them that are drawn, and of huge ones. */
export interface Limited {
  large: number;
  drawn: number;
  huge: number;
}

export class Ellipses {
  /** The filled shapes and their outlines. */
  readonly parts: [Part, Part];
  /** What the parts draw, in this order. */
  private regions: [Region[], Region[]] = [[], []];
  private hidden: VertexGroup[] = [];
  limited: Limited = { large: 0, drawn: 0, huge: 0 };

  constructor() {
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
    this.build(new Float32Array(0));
  }

  /** `extent` returns the size of the graph. */
  update({ uncertainty, positions }: Frame, vertices: Vertices, extent: () => number): void {
    const count = uncertainty?.vertices.length ?? 0;
    if (count === 0 && this.regions[1].length === 0) return;
    const regions = [...spreadOrder(count)].map((i) => ({
      vertex: uncertainty!.vertices[i]!,
      columns: unitBallMap(uncertainty!.covariances.subarray(6 * i, 6 * i + 6)),
    }));
    const { outlined, filled, limited } = limitRegions(regions, count > 0 ? extent() : 0);
    this.regions = [filled, outlined];
    this.limited = limited;
    this.build(positions);
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
    this.parts.forEach(({ geometry }, i) => {
      const attribute = geometry.getAttribute("instance_visible");
      this.regions[i]!.forEach(({ vertex }, k) => attribute.setX(k, visible[vertex] === 1 && !isHidden(vertex) ? 1 : 0));
      attribute.needsUpdate = true;
    });
  }

  set shown(shown: boolean) {
    for (const part of this.parts) part.visible = shown;
  }

  setColor(color: Color): void {
    for (const part of this.parts) part.material.uniforms["color"]!.value.copy(color);
  }

  /** The number of lines of the outlines that are drawn if the budget allows it. */
  get drawableCount(): number {
    return this.parts[0].visible ? this.regions[1].length * this.corners : 0;
  }

  /** Draws only a part (0 to 1) of the ellipses. */
  drawPart(part: number): void {
    this.parts.forEach(({ geometry }, i) => (geometry.instanceCount = Math.ceil(this.regions[i]!.length * part)));
  }

  dispose(): void {
    for (const { geometry, material } of this.parts) {
      geometry.dispose();
      material.dispose();
    }
  }

  private get corners(): number {
    return Math.min(MOST_CORNERS, Math.floor(MOST_LINES / Math.max(1, this.regions[1].length)));
  }

  private build(positions: Float32Array): void {
    const { corners } = this;
    const shapes = [disc(corners), circle(corners)];
    this.parts.forEach((part, i) => {
      const regions = this.regions[i]!;
      const attribute = (items: number, values: (region: Region) => ArrayLike<number>) => {
        const array = new Float32Array(items * regions.length);
        regions.forEach((region, k) => array.set(values(region), items * k));
        return new InstancedBufferAttribute(array, items);
      };
      part.geometry.dispose();
      part.geometry = shapes[i]!;
      part.geometry.instanceCount = regions.length;
      part.geometry.setAttribute("instance_position", attribute(3, ({ vertex }) =>
        positions.subarray(3 * vertex, 3 * vertex + 3).map((x) => (Number.isNaN(x) ? 0 : x))));
      ["instance_x", "instance_y", "instance_z"].forEach((name, k) =>
        part.geometry.setAttribute(name, attribute(3, ({ columns }) => columns.slice(3 * k, 3 * k + 3))));
      part.geometry.setAttribute("instance_visible", attribute(1, () => [0]));
    });
  }
}

/**
 * Of the regions that are large or huge for the extent of the graph (if it is not 0), the first ones are not filled, and the others
 * are left out. Huge regions become smaller without a change of their shape. Of all that are not large, as many are filled as cover
 * the picture a few times, the smallest first.
 */
export function limitRegions(regions: Region[], extent: number): { outlined: Region[]; filled: Region[]; limited: Limited } {
  const sizes = regions.map(({ columns }) => (extent > 0 ? Math.hypot(...columns) / extent : 0));
  const is_filled = new Uint8Array(regions.length);
  let area = 0;
  for (const i of Uint32Array.from(regions, (_, k) => k).sort((a, b) => sizes[a]! - sizes[b]!)) {
    area += sizes[i]! ** 2;
    if (sizes[i]! > LARGE || area > MOST_FILLED) break;
    is_filled[i] = 1;
  }
  const outlined: Region[] = [];
  const limited = { large: 0, drawn: 0, huge: sizes.filter((size) => size > HUGE).length };
  regions.forEach((region, i) => {
    const size = sizes[i]!;
    if (size <= LARGE || ++limited.large <= MOST_LARGE) outlined.push(size > HUGE ? scaled(region, HUGE / size) : region);
  });
  limited.drawn = Math.min(limited.large, MOST_LARGE);
  return { outlined, filled: regions.filter((_, i) => is_filled[i] === 1), limited };
}

function scaled({ vertex, columns }: Region, factor: number): Region {
  return { vertex, columns: columns.map((value) => factor * value) };
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

/** The unit circle with its center, as triangles. */
function disc(corners: number): InstancedBufferGeometry {
  return geometryOf(corners, (a, b) => [a, b, corners]);
}

function circle(corners: number): InstancedBufferGeometry {
  return geometryOf(corners, (a, b) => [a, b]);
}

/** `join` returns the numbers for two neighboring corners; the center has the number `corners`. */
function geometryOf(corners: number, join: (a: number, b: number) => number[]): InstancedBufferGeometry {
  const places = new Float32Array(3 * (corners + 1));
  const index: number[] = [];
  for (let i = 0; i < corners; ++i) {
    const angle = (2 * Math.PI * i) / corners;
    places.set([Math.cos(angle), Math.sin(angle)], 3 * i);
    index.push(...join(i, (i + 1) % corners));
  }
  const geometry = new InstancedBufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(places, 3));
  geometry.setIndex(index);
  return geometry;
}
