// SPDX-License-Identifier: BSD-3-Clause
// The number of lines that are drawn while the camera moves. It adapts to the speed of the machine.

const LEAST = 5_000, FIRST = 100_000, MOST = 2_000_000;
/** The time from one picture to the next. */
const SLOW_MS = 60, FAST_MS = 22;

export class LineBudget {
  lines = FIRST;
  private last = 0;

  /** Takes the time of a picture in ms. */
  tick(time: number, is_moving: boolean): void {
    const interval = time - this.last;
    if (is_moving && this.last > 0 && interval > SLOW_MS && interval < 2000) this.lines = Math.max(LEAST, this.lines / 2);
    if (is_moving && this.last > 0 && interval < FAST_MS) this.lines = Math.min(MOST, this.lines * 1.1);
    this.last = is_moving ? time : 0;
  }
}
