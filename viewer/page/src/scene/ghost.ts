// SPDX-License-Identifier: BSD-3-Clause
// Other estimates of the same graph, faintly under the current ones: vertices as points, edges as lines.
import { Group } from "three";
import type { EdgeGroup, Frame, Structure, VertexGroup } from "../protocol/messages";
import type { Theme } from "../theme";
import { Edges, linesOf } from "./edges";
import { PointCloud } from "./points";
import { membersOf, Vertices } from "./vertices";

const POINT_PIXELS = 2;
/** How much of their color lines lose. */
const FAINTNESS = 0.4;

export class Ghost {
  readonly root = new Group();
  /** The members of `structure.vertices` and `structure.edges`, in the same order. */
  readonly points: PointCloud[];
  readonly edges: Edges[];
  private readonly vertices: Vertices;

  constructor(private readonly structure: Structure, readonly frame: Frame) {
    this.root.matrixAutoUpdate = false;
    this.vertices = new Vertices(structure);
    this.vertices.update(frame);
    this.points = structure.vertices.map((group) => new PointCloud(membersOf(group), this.vertices));
    this.edges = structure.edges.map((group) => new Edges(group, linesOf(group, structure), this.vertices));
    for (const points of this.points) points.setSize(POINT_PIXELS);
    for (const part of this.parts) {
      // It is drawn before all else, and all else is drawn over it.
      part.object.renderOrder = -1;
      part.object.material.transparent = part.object.material.depthTest = part.object.material.depthWrite = false;
      this.root.add(part.object);
    }
  }

  /** Shows the types that `isShown` tells. */
  applyOptions({ before, background }: Theme, isShown: (group: VertexGroup | EdgeGroup) => boolean): void {
    for (const points of this.points) points.setColor(before);
    for (const edges of this.edges) edges.setColor(before.clone().lerp(background, FAINTNESS));
    this.structure.vertices.forEach((group, i) => (this.points[i]!.object.visible = isShown(group)));
    this.structure.edges.forEach((group, i) => (this.edges[i]!.object.visible = isShown(group)));
  }

  /** Must be called once before the first picture. `mask` is as in Vertices.filter(). */
  filter(first: number, mask: Uint8Array): void {
    this.vertices.filter(first, mask);
    for (const part of this.parts) part.updateVisible(this.vertices);
  }

  dispose(): void {
    for (const part of this.parts) part.dispose();
  }

  private get parts(): (PointCloud | Edges)[] {
    return [...this.points, ...this.edges];
  }
}
