// SPDX-License-Identifier: BSD-3-Clause
// The poses or cameras of one type: one shape, drawn once per vertex in a single call.
import {
  DynamicDrawUsage, InstancedBufferAttribute, InstancedBufferGeometry, LineSegments, Mesh, type ShaderMaterial,
} from "three";
import type { Frame, Structure, VertexGroup } from "../protocol/messages";
import type { Theme } from "../theme";
import { instanceMaterial } from "./materials";
import { shapeGeometry, shapeIsLines, type ShapeName } from "./shapes";
import type { Vertices } from "./vertices";

export class Poses {
  object: Mesh<InstancedBufferGeometry, ShaderMaterial> | LineSegments<InstancedBufferGeometry, ShaderMaterial>;
  private readonly material = instanceMaterial();
  private readonly positions: InstancedBufferAttribute;
  private readonly orientations: InstancedBufferAttribute;
  private readonly visible: InstancedBufferAttribute;
  private readonly fixed: InstancedBufferAttribute;
  private theme: Theme | null = null;

  constructor(readonly group: VertexGroup, structure: Structure, private shape: ShapeName) {
    const { first, count } = group;
    const attribute = (items: number) =>
      new InstancedBufferAttribute(new Float32Array(items * count), items).setUsage(DynamicDrawUsage);
    this.positions = attribute(3);
    this.orientations = attribute(4);
    this.visible = attribute(1);
    this.fixed = attribute(1);
    this.fixed.array.set(structure.fixed.subarray(first, first + count));
    this.object = this.build();
  }

  /** Replaces `object`, and returns the one that was there. */
  setShape(shape: ShapeName): Poses["object"] {
    const replaced = this.object;
    this.shape = shape;
    this.object = this.build();
    this.object.visible = replaced.visible;
    replaced.geometry.dispose();
    this.applyTheme();
    return replaced;
  }

  update(frame: Frame, vertices: Vertices): void {
    const { first, count } = this.group;
    this.positions.array.set((vertices.positions.array as Float32Array).subarray(3 * first, 3 * (first + count)));
    this.orientations.array.set(frame.orientations.subarray(4 * first, 4 * (first + count)));
    this.positions.needsUpdate = true;
    this.orientations.needsUpdate = true;
  }

  updateVisible(vertices: Vertices): void {
    this.visible.array.set(vertices.visible.subarray(this.group.first, this.group.first + this.group.count));
    this.visible.needsUpdate = true;
  }

  setSize(size: number): void {
    this.material.uniforms["size"]!.value = size;
  }

  setTheme(theme: Theme): void {
    this.theme = theme;
    this.applyTheme();
  }

  dispose(): void {
    this.object.geometry.dispose();
    this.material.dispose();
  }

  private applyTheme(): void {
    if (!this.theme) return;
    const { color, fixed_color } = this.material.uniforms;
    color!.value.copy(this.group.shape === "pose" ? this.theme.pose : this.theme.camera);
    fixed_color!.value.copy(this.theme.fixed);
    if (this.shape === "axes") {
      color!.value.set(1, 1, 1);
      fixed_color!.value.set(1, 1, 1);
    }
  }

  private build(): Poses["object"] {
    const geometry = shapeGeometry(this.shape);
    geometry.instanceCount = this.group.count;
    geometry.setAttribute("instance_position", this.positions);
    geometry.setAttribute("instance_orientation", this.orientations);
    geometry.setAttribute("instance_visible", this.visible);
    geometry.setAttribute("instance_fixed", this.fixed);
    const object = shapeIsLines(this.shape)
      ? new LineSegments(geometry, this.material)
      : new Mesh(geometry, this.material);
    object.frustumCulled = false;
    object.renderOrder = 2;
    return object;
  }
}
