// SPDX-License-Identifier: BSD-3-Clause
// Hides points of a reconstruction that few cameras see, or whose reprojection error is large.
import type { Structure } from "../protocol/messages";
import { isPoint } from "./statistics";

export interface PointLimits {
  least_track_length: number;
  most_error: number;
}

export class PointFilter {
  /** The number of the first point. */
  readonly first: number;
  readonly count: number;
  hidden = 0;
  /** The last errors that the server sent; none are sent during a run. */
  errors: Float32Array | null = null;
  /** The result of the last apply(): a number for each point, 1 if it is shown. */
  readonly mask: Uint8Array;

  constructor(private readonly structure: Structure) {
    const points = structure.vertices.filter(isPoint);
    this.first = points[0]?.first ?? 0;
    this.count = points.reduce((sum, group) => sum + group.count, 0);
    this.mask = new Uint8Array(this.count).fill(1);
  }

  get longestTrack(): number {
    return this.structure.track_lengths?.reduce((most, length) => Math.max(most, length), 0) ?? 0;
  }

  /** Determines `mask`. */
  apply(limits: PointLimits): void {
    const lengths = this.structure.track_lengths;
    this.hidden = 0;
    for (let point = 0; point < this.count; ++point) {
      const is_short = lengths !== null && lengths[point]! < limits.least_track_length;
      const is_bad = this.errors !== null && limits.most_error < Infinity && !(this.errors[point]! <= limits.most_error);
      this.mask[point] = is_short || is_bad ? 0 : 1;
      this.hidden += 1 - this.mask[point]!;
    }
  }
}
