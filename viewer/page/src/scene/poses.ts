// SPDX-License-Identifier: BSD-3-Clause
// The poses or cameras of one type: one shape, drawn once per vertex in a single call.
import {
  Color, DynamicDrawUsage, InstancedBufferAttribute, InstancedBufferGeometry, LineSegments, Mesh, type ShaderMaterial,
} from "three";
import type { Frame, Structure, VertexGroup } from "../protocol/messages";
import { instanceMaterial } from "./materials";
import { shapeGeometry, shapeIsLines, type ShapeName } from "./shapes";
import { spreadOrder } from "./spread";
import type { Vertices } from "./vertices";

export class Poses {
  object: Mesh<InstancedBufferGeometry, ShaderMaterial> | LineSegments<InstancedBufferGeometry, ShaderMaterial>;
  private readonly material = instanceMaterial();
  private readonly positions: InstancedBufferAttribute;
  private readonly orientations: InstancedBufferAttribute;
  private readonly visible: InstancedBufferAttribute;
  private readonly fixed: InstancedBufferAttribute;
  private readonly classes: InstancedBufferAttribute;
  /** The order of the vertices in the attributes. */
  private readonly order: Uint32Array;
  private readonly color = new Color();
  private readonly fixed_color = new Color();
  private uses_classes = false;

  constructor(readonly group: VertexGroup, structure: Structure, private shape: ShapeName) {
    const { first, count } = group;
    this.order = spreadOrder(count).map((i) => first + i);
    const attribute = (items: number) =>
      new InstancedBufferAttribute(new Float32Array(items * count), items).setUsage(DynamicDrawUsage);
    this.positions = attribute(3);
    this.orientations = attribute(4);
    this.visible = attribute(1);
    this.fixed = attribute(1);
    this.classes = attribute(1);
    gather(structure.fixed, this.order, this.fixed);
    this.object = this.build();
  }

  /** Replaces `object`, and returns the one that was there. */
  setShape(shape: ShapeName): Poses["object"] {
    const replaced = this.object;
    this.shape = shape;
    this.object = this.build();
    this.object.visible = replaced.visible;
    replaced.geometry.dispose();
    this.applyColors();
    return replaced;
  }

  update(frame: Frame, vertices: Vertices): void {
    gather(vertices.positions.array, this.order, this.positions);
    gather(frame.orientations, this.order, this.orientations);
  }

  updateVisible(vertices: Vertices): void {
    gather(vertices.visible, this.order, this.visible);
  }

  updateClasses(vertices: Vertices): void {
    gather(vertices.classes.array, this.order, this.classes);
  }

  /** The number of poses that are drawn if the budget allows it. */
  get drawableCount(): number {
    return this.object.visible ? this.group.count : 0;
  }

  /** Draws only a part (0 to 1) of the poses. */
  drawPart(part: number): void {
    this.object.geometry.instanceCount = Math.ceil(this.group.count * part);
  }

  setSize(size: number): void {
    this.material.uniforms["size"]!.value = size;
  }

  /** If it uses classes, vertices have the colors of their classes instead. */
  setColors(color: Color, fixed_color: Color, uses_classes: boolean): void {
    this.color.copy(color);
    this.fixed_color.copy(fixed_color);
    this.uses_classes = uses_classes;
    this.applyColors();
  }

  dispose(): void {
    this.object.geometry.dispose();
    this.material.dispose();
  }

  /** Axes have colors of their own. */
  private applyColors(): void {
    const { color, fixed_color, uses_classes } = this.material.uniforms;
    const white = new Color(1, 1, 1);
    color!.value.copy(this.shape === "axes" ? white : this.color);
    fixed_color!.value.copy(this.shape === "axes" ? white : this.fixed_color);
    uses_classes!.value = Number(this.uses_classes && this.shape !== "axes");
  }

  private build(): Poses["object"] {
    const geometry = shapeGeometry(this.shape);
    geometry.instanceCount = this.group.count;
    geometry.setAttribute("instance_position", this.positions);
    geometry.setAttribute("instance_orientation", this.orientations);
    geometry.setAttribute("instance_visible", this.visible);
    geometry.setAttribute("instance_fixed", this.fixed);
    geometry.setAttribute("instance_class", this.classes);
    const object = shapeIsLines(this.shape)
      ? new LineSegments(geometry, this.material)
      : new Mesh(geometry, this.material);
    object.frustumCulled = false;
    object.renderOrder = 2;
    return object;
  }
}

/** Fills `to` with the items of `from` in the given order. */
function gather(from: ArrayLike<number>, order: Uint32Array, to: InstancedBufferAttribute): void {
  const { array, itemSize } = to;
  for (let i = 0; i < order.length; ++i) {
    for (let k = 0; k < itemSize; ++k) array[itemSize * i + k] = from[itemSize * order[i]! + k]!;
  }
  to.needsUpdate = true;
}
