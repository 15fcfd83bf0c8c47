// SPDX-License-Identifier: BSD-3-Clause
// The frames of the current run, from the estimates before it to the newest ones, in a bounded amount of memory.
import type { Frame, IterationRow, MaybeNumber } from "./protocol/messages";

const MOST_BYTES = 2 ** 28;

export interface Moment {
  /** 0 before the run. */
  iteration: number;
  frame: Frame;
}

/** A moment and how many others of its run came before it. */
type Entry = Moment & { number: number };

export class TimeLine {
  private entries: Entry[] = [];
  private bytes = 0;
  private next_number = 0;
  /** Of the frames between the first and the last one, only each such one is kept. */
  private stride = 1;

  constructor(private readonly most_bytes = MOST_BYTES) {}

  /** By ascending iterations. */
  get moments(): readonly Moment[] {
    return this.entries;
  }

  get newest(): Moment | null {
    return this.entries.at(-1) ?? null;
  }

  clear(): void {
    this.restart([]);
  }

  /** A run begins from the newest estimates. */
  beginRun(): void {
    this.restart(this.entries.slice(-1));
  }

  /** `rows` is the number of rows of the run: a later iteration belongs to an earlier run, so it is where this one begins. */
  add(frame: Frame, rows: number): void {
    const iteration = frame.iteration > rows ? 0 : frame.iteration;
    if (iteration === 0) this.restart([]);
    this.keep((entry) => entry.iteration < iteration && entry.number % this.stride === 0);
    this.entries.push({ iteration, frame, number: this.next_number++ });
    this.bytes += size(frame);
    while (this.bytes > this.most_bytes && this.entries.length > 2) this.thinOut();
  }

  /** Forgets the frames of attempts that the run gave up: those whose chi2 is not that of its rows. */
  settle(rows: IterationRow[]): void {
    const last = this.entries.at(-1);
    const chi2 = (iteration: number): MaybeNumber | undefined => rows[iteration - 1]?.chi2;
    this.keep((entry) => entry.iteration === 0 || entry === last || entry.frame.chi2 === chi2(entry.iteration));
  }

  private restart(entries: Entry[]): void {
    this.entries = entries.map((entry, i) => ({ ...entry, iteration: 0, number: i }));
    this.next_number = entries.length;
    this.stride = 1;
    this.bytes = entries.reduce((sum, { frame }) => sum + size(frame), 0);
  }

  /** Halves the number of frames between the first and the last one. */
  private thinOut(): void {
    this.stride *= 2;
    const last = this.entries.at(-1);
    this.keep((entry) => entry.number % this.stride === 0 || entry === last);
  }

  private keep(isKept: (entry: Entry) => boolean): void {
    this.entries = this.entries.filter(isKept);
    this.bytes = this.entries.reduce((sum, { frame }) => sum + size(frame), 0);
  }
}

/** All arrays of a frame are views of one buffer. */
function size({ positions }: Frame): number {
  return positions.buffer.byteLength;
}
