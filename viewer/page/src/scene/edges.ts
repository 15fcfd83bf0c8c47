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
/** Loop closures are fainter if their length is more than this many diameters of the graph together. */
const FEW_DIAMETERS = 80;
const MOST_SAMPLES = 5000;

export class Edges {
  readonly object: LineSegments<BufferGeometry, ReturnType<typeof lineMaterial>>;
  private readonly index: BufferAttribute;
  /** Vertices of each line. The first n lines are a part that is spread over all of them. */
  private readonly lines: Uint32Array;
  private drawable = 0;
  /** How much of their opacity dense lines keep. */
  private thinness = 1;
  private opacity = 1;

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
    this.opacity = opacity;
    this.object.material.uniforms["opacity"]!.value = opacity * this.fullOpacity();
  }

  /** Makes loop closures faint that would cover the graph. `positions` are those of the vertices, `diameter` is that of the graph. */
  updateDensity(positions: ArrayLike<number>, diameter: number): void {
    if (this.group.role !== "loop closure" || !(diameter > 0)) return;
    const most = FEW_DIAMETERS * diameter;
    this.thinness = Math.min(1, Math.max(LEAST_OPACITY, most / Math.max(most, totalLength(this.lines, positions))));
    this.setOpacity(this.opacity);
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
    if (this.group.role !== "observation") return full * this.thinness;
    const count = this.lines.length / 2;
    return full * Math.min(1, Math.max(LEAST_OPACITY / full, Math.sqrt(FEW_OBSERVATIONS / count)));
  }
}

/** The lines of a type and role: two vertex numbers each. */
export function linesOf({ first, count }: EdgeGroup, { lines }: Structure): Uint32Array {
  return lines.subarray(2 * first, 2 * (first + count));
}

/** An estimate from a part of the lines, which are in a spread order. Lines to vertices without a place do not count. */
function totalLength(lines: Uint32Array, positions: ArrayLike<number>): number {
  const count = lines.length / 2, sampled = Math.min(count, MOST_SAMPLES);
  let sum = 0;
  for (let line = 0; line < sampled; ++line) {
    const a = 3 * lines[2 * line]!, b = 3 * lines[2 * line + 1]!;
    const length = Math.hypot(positions[a]! - positions[b]!, positions[a + 1]! - positions[b + 1]!, positions[a + 2]! - positions[b + 2]!);
    if (Number.isFinite(length)) sum += length;
  }
  return sampled > 0 ? (sum * count) / sampled : 0;
}

function spread(lines: Uint32Array): Uint32Array {
  const ordered = new Uint32Array(lines.length);
  spreadOrder(lines.length / 2).forEach((from, to) => {
    ordered[2 * to] = lines[2 * from]!;
    ordered[2 * to + 1] = lines[2 * from + 1]!;
  });
  return ordered;
}
