// SPDX-License-Identifier: BSD-3-Clause
// How far the estimates are from the truth: ATE and RPE of the frame in the picture.
import { general } from "../format";
import type { Frame, Truth } from "../protocol/messages";
import { byId, setText } from "./dom";

/** As in the output of `boxplus compare`. */
const ATE_DIGITS = 6;
const RPE_DIGITS = 4;

export class TruthErrors {
  private readonly element = byId("truth-errors");

  /** null if no truth is open. */
  setTruth(truth: Truth | null): void {
    this.element.hidden = truth === null;
    this.element.title = truth ? `Compared with ${truth.name}` : "";
  }

  /** `is_past` is true if newer frames are known. */
  show({ truth }: Frame, is_past: boolean): void {
    const { ate_m, rpe_m, rpe_rad } = truth ?? { ate_m: null, rpe_m: null, rpe_rad: null };
    const degrees = rpe_rad === null ? null : (rpe_rad * 180) / Math.PI;
    // A unit stays on the line of its number.
    setText(byId("ate"), `${general(ate_m, ATE_DIGITS)}\u00a0m`);
    setText(byId("rpe"), `${general(rpe_m, RPE_DIGITS)}\u00a0m, ${general(degrees, RPE_DIGITS)}°`);
    this.element.classList.toggle("past", is_past);
  }
}
