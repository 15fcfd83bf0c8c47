// SPDX-License-Identifier: BSD-3-Clause
// Marks the selected vertices by rings, and the selected edge by its lines and rings around its vertices. The mark is visible
// through everything else.
import { BufferAttribute, BufferGeometry, type Color, DynamicDrawUsage, LineSegments, Points } from "three";
import { lineMaterial, pointMaterial } from "./materials";
import type { Vertices } from "./vertices";

const MOST_VERTICES = 10_000, MOST_LINES = 100;
const VERTEX_PIXELS = 22, END_PIXELS = 13;

export class Selection {
  readonly objects: [Points<BufferGeometry, ReturnType<typeof pointMaterial>>,
    LineSegments<BufferGeometry, ReturnType<typeof lineMaterial>>];
  private members: number[] = [];
  private are_joined = false;

  constructor(private readonly vertices: Vertices) {
    this.objects = [
      new Points(this.geometry(MOST_VERTICES), pointMaterial(true)),
      new LineSegments(this.geometry(2 * MOST_LINES), lineMaterial()),
    ];
    for (const object of this.objects) {
      object.frustumCulled = false;
      object.renderOrder = 5;
      object.material.transparent = true;
      object.material.depthTest = false;
    }
  }

  /** `members` are the numbers of the vertices. */
  show(members: number[], are_joined: boolean): void {
    this.members = members.slice(0, MOST_VERTICES);
    this.are_joined = are_joined;
    this.updateVisible();
  }

  /** Marks only what is drawn. */
  updateVisible(): void {
    const shown = this.members.filter((vertex) => this.vertices.visible[vertex]);
    const [points, lines] = this.objects;
    setIndex(points.geometry, shown);
    const [first, ...others] = shown;
    setIndex(lines.geometry, this.are_joined ? others.slice(0, MOST_LINES).flatMap((other) => [first!, other]) : []);
    points.material.uniforms["size"]!.value = this.members.length > 1 ? END_PIXELS : VERTEX_PIXELS;
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
