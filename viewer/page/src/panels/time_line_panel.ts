// SPDX-License-Identifier: BSD-3-Clause
// The bar under the picture: chooses which iteration of the run is in the picture, and plays all of them. At its right end,
// the picture follows the run.
import { general } from "../format";
import { iterationAt, type Model, placeOf } from "../model";
import { type Frame, isSameStructure, type IterationRow, type Structure } from "../protocol/messages";
import type { SceneView } from "../scene/scene_view";
import { type Moment, TimeLine } from "../time_line";
import type { Chart } from "./chart";
import { byId, setText } from "./dom";
import type { TruthErrors } from "./truth_errors";

const CHI2_DIGITS = 9;
/** Playing a run takes about this time, unless its pictures would be too fast or too slow. */
const PLAY_MS = 5000, SHORTEST_MS = 40, LONGEST_MS = 500;

export class TimeLinePanel {
  private readonly line = new TimeLine();
  private readonly slider = byId<HTMLInputElement>("time");
  private readonly play_button = byId<HTMLButtonElement>("play");
  private structure: Structure | null = null;
  private run_id = 0;
  /** What the user chose; null if the picture follows the run. */
  private chosen: Moment | null = null;
  private play_timer = 0;

  constructor(
    private readonly model: Model, private readonly view: SceneView, private readonly chart: Chart,
    private readonly truth_errors: TruthErrors,
  ) {
    this.slider.addEventListener("input", () => {
      this.pause();
      this.goTo(this.slider.valueAsNumber);
    });
    this.play_button.addEventListener("click", () => this.togglePlay());
    chart.on_choose = (place) => {
      this.pause();
      this.goTo(this.indexOf(iterationAt(place, this.rows)));
    };
    model.observe(() => this.update());
  }

  /** The frames are kept if the structure is the one before, as after a lost connection. */
  setStructure(structure: Structure): void {
    if (!isSameStructure(structure, this.structure)) this.line.clear();
    this.structure = structure;
  }

  add(frame: Frame): void {
    this.line.add(frame, this.rows.length);
    // A page that was reloaded gets the frames of all attempts at once.
    if (!this.model.isBusy) this.line.settle(this.rows);
    this.show();
  }

  /** Moves by a number of frames; infinite ones move to an end. */
  move(frames: number): void {
    this.pause();
    this.goTo(this.index + frames);
  }

  togglePlay(): void {
    if (this.play_timer !== 0) {
      this.pause();
    } else if (this.last > 0) {
      if (this.index === this.last) this.goTo(0);
      const interval = Math.min(LONGEST_MS, Math.max(SHORTEST_MS, PLAY_MS / this.last));
      this.play_timer = window.setInterval(() => this.playOn(), interval);
    }
    this.show();
  }

  private get rows(): IterationRow[] {
    return this.model.run?.rows ?? [];
  }

  private get last(): number {
    return this.line.moments.length - 1;
  }

  private get index(): number {
    return this.chosen ? this.indexOf(this.chosen.iteration) : this.last;
  }

  /** The first frame that is not before the iteration. */
  private indexOf(iteration: number): number {
    const index = this.line.moments.findIndex((moment) => moment.iteration >= iteration);
    return index < 0 ? this.last : index;
  }

  private goTo(index: number): void {
    this.choose(index);
    this.show();
  }

  private choose(index: number): void {
    this.chosen = index >= this.last ? null : this.line.moments[Math.max(0, index)]!;
  }

  private playOn(): void {
    this.choose(this.index + 1);
    if (this.index === this.last && !this.model.isBusy) this.pause();
    this.show();
  }

  private pause(): void {
    clearInterval(this.play_timer);
    this.play_timer = 0;
  }

  private update(): void {
    const { run, state, isBusy } = this.model;
    if (run && run.id !== this.run_id) {
      this.run_id = run.id;
      this.line.beginRun();
      this.chosen = null;
    }
    if (run && !isBusy) this.line.settle(run.rows);
    byId("time-line").hidden = !state?.file;
    this.show();
  }

  private show(): void {
    // A time line that became thinner may not have what was chosen.
    if (this.chosen && !this.line.moments.includes(this.chosen)) this.choose(this.index);
    const moment = this.chosen ?? this.line.newest;
    if (!moment) return;
    if (this.view.shown !== moment.frame) this.view.setFrame(moment.frame);
    this.view.setNewer(this.chosen && this.line.newest!.frame);
    const { last, index } = this;
    if (last < 1) this.pause();
    this.slider.disabled = this.play_button.disabled = last < 1;
    this.slider.max = String(Math.max(1, last));
    this.slider.value = String(last < 1 ? 1 : index);
    this.showTexts(moment);
    this.truth_errors.show(moment.frame, this.chosen !== null);
    this.chart.mark(last < 1 ? null : placeOf(moment.iteration, this.rows));
  }

  private showTexts({ iteration, frame }: Moment): void {
    const stages = this.model.run?.stages ?? [], stage = stages[iteration - 1];
    const last = this.line.newest!.iteration - stages.length;
    const number = Math.max(0, iteration - stages.length);
    const place = stage ? `Stage: ${stage}` : this.last < 1 || last < 1 ? `Iteration ${number}` : `Iteration ${number} of ${last}`;
    const text = `${place}, chi2 ${general(frame.chi2, CHI2_DIGITS)}`;
    setText(byId("time-text"), text);
    byId("time-text").classList.toggle("past", this.chosen !== null);
    this.slider.setAttribute("aria-valuetext", text);
    const is_playing = this.play_timer !== 0;
    this.play_button.dataset["on"] = String(is_playing);
    this.play_button.setAttribute("aria-label", is_playing ? "Pause" : "Play");
  }
}
