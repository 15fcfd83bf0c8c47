// SPDX-License-Identifier: BSD-3-Clause
// The positions of all vertices, which points and edges share, and which of the vertices are drawn.
import { BufferAttribute, DynamicDrawUsage } from "three";
import type { Frame, Structure, VertexGroup } from "../protocol/messages";

export class Vertices {
  readonly count: number;
  readonly positions: BufferAttribute;
  /** The class of each vertex, which determines its color if materials use classes. */
  readonly classes: BufferAttribute;
  /** 1 if the vertex has a position and no filter hides it. */
  readonly visible: Uint8Array;
  private readonly placed: Uint8Array;
  private readonly unfiltered: Uint8Array;

  constructor(structure: Structure) {
    this.count = structure.fixed.length;
    this.positions = new BufferAttribute(new Float32Array(3 * this.count), 3).setUsage(DynamicDrawUsage);
    this.classes = new BufferAttribute(new Float32Array(this.count), 1);
    this.visible = new Uint8Array(this.count);
    this.placed = new Uint8Array(this.count);
    this.unfiltered = new Uint8Array(this.count).fill(1);
  }

  /** Returns true if `visible` changed. */
  update({ positions: from }: Pick<Frame, "positions">): boolean {
    const to = this.positions.array as Float32Array;
    let changed = false;
    to.set(from);
    for (let vertex = 0; vertex < this.count; ++vertex) {
      const placed = Number.isNaN(from[3 * vertex]) ? 0 : 1;
      // Graphics cards need not know NaN.
      if (!placed) to.fill(0, 3 * vertex, 3 * vertex + 3);
      if (placed !== this.placed[vertex]) {
        this.placed[vertex] = placed;
        changed = true;
      }
    }
    this.positions.needsUpdate = true;
    if (changed) this.combine();
    return changed;
  }

  /** `mask` has a number for each vertex from `first` on: 1 if the filter lets it pass. */
  filter(first: number, mask: Uint8Array): void {
    this.unfiltered.set(mask, first);
    this.combine();
  }

  setClasses(of_vertex: Uint8Array): void {
    (this.classes.array as Float32Array).set(of_vertex);
    this.classes.needsUpdate = true;
  }

  private combine(): void {
    for (let vertex = 0; vertex < this.count; ++vertex) {
      this.visible[vertex] = this.placed[vertex]! & this.unfiltered[vertex]!;
    }
  }
}

/** The numbers of the vertices of a type. */
export function membersOf({ first, count }: VertexGroup): Uint32Array {
  return Uint32Array.from({ length: count }, (_, i) => first + i);
}
