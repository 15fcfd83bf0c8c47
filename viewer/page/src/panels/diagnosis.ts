// SPDX-License-Identifier: BSD-3-Clause
// What is wrong with the graph. A click on a finding marks the vertices and edges concerned.
import { counted } from "../format";
import type { Model } from "../model";
import type { Connection } from "../protocol/connection";
import type { Diagnosis, Finding } from "../protocol/diagnosis";
import type { Commands } from "./commands";
import { byId, create, setTextOrHide } from "./dom";
import type { ElementPanel } from "./element";

export class DiagnosisPanel {
  private readonly note = byId("diagnosis-note");
  private readonly list = byId("findings");
  private structure = 0;

  constructor(
    model: Model, private readonly connection: Connection, commands: Commands, private readonly element: ElementPanel,
  ) {
    const button = byId<HTMLButtonElement>("diagnose");
    button.addEventListener("click", () => void commands.run("There is no diagnosis", async () => {
      this.show(await this.connection.diagnosis());
    }));
    model.observe(() => (button.disabled = !model.hasGraph || model.isBusy));
  }

  /** The numbers of vertices are those of one structure. */
  setStructure(structure: number): void {
    if (structure !== this.structure) this.clear("");
    this.structure = structure;
  }

  /** The estimates have changed. */
  setFrame(): void {
    if (this.list.childElementCount > 0) setTextOrHide(this.note, "The estimates have changed since the diagnosis.");
    else this.clear("");
  }

  private clear(note: string): void {
    this.list.replaceChildren();
    setTextOrHide(this.note, note);
  }

  private show({ structure, count, findings }: Diagnosis): void {
    if (structure !== this.structure) return;
    const rest = count - findings.length;
    const found = count === 0 ? "Nothing is wrong at these estimates." : `${counted(count, "finding", "findings")}.`;
    this.clear(rest > 0 ? `${found} The last ${rest} are not listed.` : found);
    this.list.append(...findings.map((finding) => this.row(finding)));
  }

  private row(finding: Finding): HTMLElement {
    const button = create("button", { className: "quiet", title: "Mark it in the picture" }, finding.text);
    button.addEventListener("click", () => this.mark(finding));
    const row = create("li", {}, button);
    row.dataset["severity"] = finding.severity;
    row.dataset["kind"] = finding.kind;
    return row;
  }

  private mark({ element, marked }: Finding): void {
    if (element) this.element.choose(element, true);
    else this.element.markGroup(marked);
  }
}
