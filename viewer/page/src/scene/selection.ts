// SPDX-License-Identifier: BSD-3-Clause
// Marks selected vertices by rings, and selected edges by their lines and rings around their ends. The mark is visible through
// everything else.
import { BufferAttribute, BufferGeometry, type Color, DynamicDrawUsage, LineSegments, Points } from "three";
import { lineMaterial, pointMaterial } from "./materials";
import type { Vertices } from "./vertices";

/** The server sends at most so many of each for a finding, and the lines bring their ends. */
const MOST = 10_000, MOST_RINGS = 3 * MOST;
const VERTEX_PIXELS = 22, END_PIXELS = 13, CROWD_PIXELS = 7;
/** With more rings than this, each of them is small. */
const CROWD = 500;

export class Selection {
  readonly objects: [Points<BufferGeometry, ReturnType<typeof pointMaterial>>,
    LineSegments<BufferGeometry, ReturnType<typeof lineMaterial>>];
  private members: number[] = [];
  /** Two vertices for each line. */
  private pairs: number[] = [];

  constructor(private readonly vertices: Vertices) {
    this.objects = [
      new Points(this.geometry(MOST_RINGS), pointMaterial(true)),
      new LineSegments(this.geometry(2 * MOST), lineMaterial()),
    ];
    for (const object of this.objects) {
      object.frustumCulled = false;
      object.renderOrder = 5;
      object.material.transparent = true;
      object.material.depthTest = false;
    }
  }

  /** `vertices` are numbers; `pairs` are two of them for each line. */
  show(vertices: number[], pairs: number[]): void {
    this.pairs = pairs.slice(0, 2 * MOST);
    this.members = [...new Set([...vertices.slice(0, MOST), ...this.pairs])];
    this.updateVisible();
  }

  /** Marks only what is drawn. */
  updateVisible(): void {
    const { visible } = this.vertices;
    const shown = this.members.filter((vertex) => visible[vertex]);
    const [points, lines] = this.objects;
    setIndex(points.geometry, shown);
    const ends: number[] = [];
    for (let i = 0; i < this.pairs.length; i += 2) {
      const a = this.pairs[i]!, b = this.pairs[i + 1]!;
      if (visible[a] && visible[b]) ends.push(a, b);
    }
    setIndex(lines.geometry, ends);
    const { length } = this.members;
    points.material.uniforms["size"]!.value = length > CROWD ? CROWD_PIXELS : length > 1 ? END_PIXELS : VERTEX_PIXELS;
  }

  setColor(color: Color): void {
    for (const object of this.objects) object.material.uniforms["color"]!.value.copy(color);
  }

  dispose(): void {
    for (const object of this.objects) {
      object.geometry.dispose();
      object.material.dispose();
    }
  }

  private geometry(most: number): BufferGeometry {
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", this.vertices.positions);
    geometry.setIndex(new BufferAttribute(new Uint32Array(most), 1).setUsage(DynamicDrawUsage));
    geometry.setDrawRange(0, 0);
    return geometry;
  }
}

function setIndex(geometry: BufferGeometry, numbers: number[]): void {
  (geometry.index!.array as Uint32Array).set(numbers);
  geometry.index!.needsUpdate = true;
  geometry.setDrawRange(0, numbers.length);
}
