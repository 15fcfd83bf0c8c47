// SPDX-License-Identifier: BSD-3-Clause
// Other estimates of the same graph, under the current ones: vertices as points, edges as lines. They are those of the file,
// or the truth.
import { Group } from "three";
import type { EdgeGroup, Structure, VertexGroup } from "../protocol/messages";
import type { Theme } from "../theme";
import { defaultSize } from "./display_options";
import { Edges, linesOf } from "./edges";
import { PointCloud } from "./points";
import { isPoint } from "./statistics";
import { membersOf, Vertices } from "./vertices";

/** Also the names of their colors in the theme. */
export type GhostKind = "before" | "truth";

interface Looks {
  /** The size of points, but at most that of the same points in the current estimates. */
  point_pixels: number;
  /** How much of their color lines lose. */
  faintness: number;
  /** Draws only odometry, if there is any: the path is what can be compared. */
  only_path: boolean;
  /** Other estimates are drawn before all else, and all else is drawn over them. */
  order: number;
}

/** The points of the truth are as dense as a band where it differs little from the estimates. */
const LOOKS: Record<GhostKind, Looks> = {
  before: { point_pixels: 2, faintness: 0.4, only_path: false, order: -3 },
  truth: { point_pixels: 4, faintness: 0, only_path: true, order: -2 },
};

/** x, y, z of each vertex; NaN if the vertex is not drawn. */
export interface Estimates {
  positions: Float32Array;
}

export class Ghost {
  readonly root = new Group();
  /** The members of `structure.vertices` and `structure.edges`, in the same order. */
  readonly points: PointCloud[];
  readonly edges: Edges[];
  private readonly vertices: Vertices;
  private readonly looks: Looks;

  constructor(private readonly kind: GhostKind, private readonly structure: Structure, readonly estimates: Estimates) {
    this.looks = LOOKS[kind];
    this.root.matrixAutoUpdate = false;
    this.vertices = new Vertices(structure);
    this.vertices.update(estimates);
    this.points = structure.vertices.map((group) => new PointCloud(membersOf(group), this.vertices));
    this.edges = structure.edges.map((group) => new Edges(group, linesOf(group, structure), this.vertices));
    const sizeOf = (group: VertexGroup) => Math.min(this.looks.point_pixels, isPoint(group) ? defaultSize(structure, group) : Infinity);
    structure.vertices.forEach((group, i) => this.points[i]!.setSize(sizeOf(group)));
    for (const part of this.parts) {
      part.object.renderOrder = this.looks.order;
      part.object.material.transparent = part.object.material.depthTest = part.object.material.depthWrite = false;
      this.root.add(part.object);
    }
  }

  /** Shows the types that `isShown` tells. */
  applyOptions(theme: Theme, isShown: (group: VertexGroup | EdgeGroup) => boolean): void {
    const color = theme[this.kind], { background } = theme;
    const only_odometry = this.looks.only_path && this.structure.edges.some(({ role }) => role === "odometry");
    for (const points of this.points) points.setColor(color);
    for (const edges of this.edges) edges.setColor(color.clone().lerp(background, this.looks.faintness));
    this.structure.vertices.forEach((group, i) => (this.points[i]!.object.visible = isShown(group)));
    this.structure.edges.forEach((group, i) =>
      (this.edges[i]!.object.visible = isShown(group) && (!only_odometry || group.role === "odometry")));
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
