// SPDX-License-Identifier: BSD-3-Clause
// How much of the graph is drawn while the camera moves. It adapts to the speed of the machine.

/** The number of lines. Poses cost more, points cost less. */
const LEAST = 4_000, FIRST = 100_000, MOST = 4_000_000;
const LINES_PER_POSE = 4, LINES_PER_POINT = 0.5;
/** The time from one picture to the next. */
const SLOW_MS = 50, FAST_MS = 22;
/** A picture at rest may be as many times as large, and still has smooth edges. */
const PATIENCE = 7;

export interface Budget {
  lines: number;
  poses: number;
  points: number;
}

export const UNLIMITED: Budget = { lines: Infinity, poses: Infinity, points: Infinity };

export class AdaptiveBudget {
  private lines = FIRST;
  private last = 0;

  get current(): Budget {
    return { lines: this.lines, poses: this.lines / LINES_PER_POSE, points: this.lines / LINES_PER_POINT };
  }

  /** Whether a picture with so much has smooth edges, which take about three times as long. */
  isSmooth({ lines, poses, points }: Budget, is_moving: boolean): boolean {
    const size = lines + LINES_PER_POSE * poses + LINES_PER_POINT * points;
    return size <= this.lines * (is_moving ? 1 / PATIENCE : PATIENCE);
  }

  /** Takes the time at which a picture begins, in ms. */
  tick(time: number, is_moving: boolean): void {
    if (is_moving && this.last > 0) this.adapt(time - this.last);
    this.last = is_moving ? time : 0;
  }

  private adapt(interval: number): void {
    if (interval > SLOW_MS) this.lines = Math.max(LEAST, this.lines * Math.max(0.1, SLOW_MS / interval));
    if (interval < FAST_MS) this.lines = Math.min(MOST, this.lines * 1.1);
  }
}
