// SPDX-License-Identifier: BSD-3-Clause
// Vertices that are drawn as one cloud: the points of one type, or the rings around fixed vertices.
import { BufferAttribute, BufferGeometry, type Color, DynamicDrawUsage, Points } from "three";
import { pointMaterial } from "./materials";
import { spreadOrder } from "./spread";
import type { Vertices } from "./vertices";

export class PointCloud {
  readonly object: Points<BufferGeometry, ReturnType<typeof pointMaterial>>;
  private readonly index: BufferAttribute;
  private readonly members: Uint32Array;
  private drawable = 0;

  /** `members` are the numbers of the vertices. */
  constructor(members: Uint32Array, vertices: Vertices, is_ring = false) {
    this.members = spreadOrder(members.length).map((i) => members[i]!);
    const geometry = new BufferGeometry();
    this.index = new BufferAttribute(new Uint32Array(members.length), 1).setUsage(DynamicDrawUsage);
    geometry.setAttribute("position", vertices.positions);
    geometry.setAttribute("vertex_class", vertices.classes);
    geometry.setIndex(this.index);
    this.object = new Points(geometry, pointMaterial(is_ring));
    this.object.frustumCulled = false;
    this.object.renderOrder = is_ring ? 3 : 1;
  }

  updateVisible(vertices: Vertices): void {
    const index = this.index.array as Uint32Array;
    this.drawable = 0;
    for (const vertex of this.members) {
      if (vertices.visible[vertex]) index[this.drawable++] = vertex;
    }
    this.index.needsUpdate = true;
  }

  /** The number of points that are drawn if the budget allows it. */
  get drawableCount(): number {
    return this.object.visible ? this.drawable : 0;
  }

  /** Draws only a part (0 to 1) of the points. */
  drawPart(part: number): void {
    this.object.geometry.setDrawRange(0, Math.ceil(this.drawable * part));
  }

  setSize(pixels: number): void {
    this.object.material.uniforms["size"]!.value = pixels;
  }

  /** If it uses classes, vertices have the colors of their classes instead. */
  setColor(color: Color, uses_classes = false): void {
    this.object.material.uniforms["color"]!.value.copy(color);
    this.object.material.uniforms["uses_classes"]!.value = Number(uses_classes);
  }

  dispose(): void {
    this.object.geometry.dispose();
    this.object.material.dispose();
  }
}
