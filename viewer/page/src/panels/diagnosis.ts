// SPDX-License-Identifier: BSD-3-Clause
// What is wrong with the graph: the server's last diagnosis. A click on a finding marks the vertices and edges concerned.
import { count, counted } from "../format";
import type { Model } from "../model";
import type { Connection } from "../protocol/connection";
import { canMark, type Diagnosis, type Finding } from "../protocol/diagnosis";
import type { Commands } from "./commands";
import { byId, create, setTextOrHide } from "./dom";
import type { ElementPanel } from "./element";

export class DiagnosisPanel {
  private readonly button = byId<HTMLButtonElement>("diagnose");
  private readonly list = byId("findings");
  private diagnosis: Diagnosis | null = null;
  private structure = 0;

  constructor(
    private readonly model: Model, connection: Connection, commands: Commands, private readonly element: ElementPanel,
  ) {
    this.button.addEventListener("click", () => void commands.run("There is no diagnosis", () => connection.diagnose()));
    model.observe(() => this.update());
  }

  /** The numbers of vertices and lines are those of one structure. */
  setStructure(structure: number): void {
    if (structure === this.structure) return;
    this.structure = structure;
    this.build();
  }

  show(diagnosis: Diagnosis): void {
    this.diagnosis = diagnosis;
    this.build();
    this.update();
  }

  private update(): void {
    const { state, hasGraph, isBusy } = this.model;
    this.button.disabled = !hasGraph || isBusy;
    if (state?.diagnosis === null && this.diagnosis) {
      this.diagnosis = null;
      this.build();
    }
    setTextOrHide(byId("diagnosis-note"), this.note());
  }

  private note(): string {
    const age = this.model.state?.diagnosis ?? null;
    if (!this.diagnosis || age === null) return "";
    const { count: total, findings, left_out = 0 } = this.diagnosis;
    const rest = total - findings.length;
    const found = total === 0 ? "Nothing is wrong at these estimates." : `${counted(total, "finding", "findings")}.`;
    const notes = [rest > 0 ? `${found} The last ${count(rest)} are not listed.` : found];
    if (left_out > 0) notes.push(`It leaves out ${counted(left_out, "false edge", "false edges")}.`);
    if (age !== "current") {
      const what = age === "other graph" ? "graph has" : "estimates have";
      notes.push(`The ${what} changed since this diagnosis.`);
      if (total === 0) notes.shift();
    }
    return notes.join(" ");
  }

  private build(): void {
    this.list.replaceChildren(...(this.diagnosis?.findings ?? []).map((finding) => this.row(finding)));
  }

  private row(finding: Finding): HTMLElement {
    const row = create("li", {}, this.content(finding));
    row.dataset["severity"] = finding.severity;
    row.dataset["kind"] = finding.kind;
    return row;
  }

  private content(finding: Finding): HTMLElement {
    // An element keeps its name when the graph is edited; numbers do not stay.
    const is_old = finding.element === null && this.diagnosis!.structure !== this.structure;
    if (!canMark(finding)) return create("p", {}, finding.text);
    if (is_old) return create("p", { title: "The graph has changed. Diagnose again to mark it." }, finding.text);
    const button = create("button", { className: "quiet", title: "Mark it in the picture" }, finding.text);
    button.addEventListener("click", () => this.mark(finding));
    return button;
  }

  private mark(finding: Finding): void {
    if (finding.element) this.element.choose(finding.element, true);
    else this.element.markGroup(finding);
  }
}
