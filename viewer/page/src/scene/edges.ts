// SPDX-License-Identifier: BSD-3-Clause
// The edges of one type and role, or those of one level among them: one set of lines between the vertices.
import { BufferAttribute, BufferGeometry, type Color, DynamicDrawUsage, LineSegments } from "three";
import type { EdgeGroup, EdgeRole, Structure } from "../protocol/messages";
import { LEVELS } from "./edge_levels";
import { lineMaterial } from "./materials";
import { spreadOrder } from "./spread";
import type { Vertices } from "./vertices";

/** How opaque an edge is if the slider is at 1. */
const OPACITY: Record<EdgeRole, number> = { odometry: 1, "loop closure": 0.75, observation: 0.35, other: 0.75 };
/** Observations are fainter if there are more of them than this, but not fainter than the least. */
const FEW_OBSERVATIONS = 1000, LEAST_OPACITY = 0.06;

export class Edges {
  readonly object: LineSegments<BufferGeometry, ReturnType<typeof lineMaterial>>;
  private readonly index: BufferAttribute;
  /** Vertices of each line. The first n lines are a part that is spread over all of them. */
  private readonly lines: Uint32Array;
  private drawable = 0;

  /** `lines` has two vertices for each line. `level` is null if the color is that of the group. */
  constructor(readonly group: EdgeGroup, lines: Uint32Array, vertices: Vertices, readonly level: number | null = null) {
    this.lines = spread(lines);
    const geometry = new BufferGeometry();
    this.index = new BufferAttribute(new Uint32Array(this.lines.length), 1).setUsage(DynamicDrawUsage);
    geometry.setAttribute("position", vertices.positions);
    geometry.setIndex(this.index);
    this.object = new LineSegments(geometry, lineMaterial());
    this.object.frustumCulled = false;
    this.object.renderOrder = (group.role === "observation" ? -1 : 0) + (level ?? 0) / LEVELS;
  }

  updateVisible({ visible }: Vertices): void {
    const index = this.index.array as Uint32Array;
    let size = 0;
    for (let i = 0; i < this.lines.length; i += 2) {
      const a = this.lines[i]!, b = this.lines[i + 1]!;
      if (!visible[a] || !visible[b]) continue;
      index[size++] = a;
      index[size++] = b;
    }
    this.index.needsUpdate = true;
    this.drawable = size / 2;
  }

  /** The number of lines that are drawn if the budget allows it. */
  get drawableCount(): number {
    return this.object.visible ? this.drawable : 0;
  }

  /** Draws only a part (0 to 1) of the lines. */
  drawPart(part: number): void {
    this.object.geometry.setDrawRange(0, 2 * Math.ceil(this.drawable * part));
  }

  setOpacity(opacity: number): void {
    this.object.material.uniforms["opacity"]!.value = opacity * this.fullOpacity();
  }

  setColor(color: Color): void {
    this.object.material.uniforms["color"]!.value.copy(color);
  }

  /** The positions are shared with the other objects of the graph, so they stay. */
  dispose(): void {
    this.object.geometry.deleteAttribute("position");
    this.object.geometry.dispose();
    this.object.material.dispose();
  }

  private fullOpacity(): number {
    if (this.level === LEVELS - 1) return 1;
    const full = OPACITY[this.group.role];
    if (this.group.role !== "observation") return full;
    const count = this.lines.length / 2;
    return full * Math.min(1, Math.max(LEAST_OPACITY / full, Math.sqrt(FEW_OBSERVATIONS / count)));
  }
}

/** The lines of a type and role: two vertex numbers each. */
export function linesOf({ first, count }: EdgeGroup, { lines }: Structure): Uint32Array {
  return lines.subarray(2 * first, 2 * (first + count));
}

function spread(lines: Uint32Array): Uint32Array {
  const ordered = new Uint32Array(lines.length);
  spreadOrder(lines.length / 2).forEach((from, to) => {
    ordered[2 * to] = lines[2 * from]!;
    ordered[2 * to + 1] = lines[2 * from + 1]!;
  });
  return ordered;
}
