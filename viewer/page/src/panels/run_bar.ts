// SPDX-License-Identifier: BSD-3-Clause
// The buttons that send commands, and what came of the last run.
import { counted, general } from "../format";
import { fitsPoorly, type Model, type Run } from "../model";
import type { Connection } from "../protocol/connection";
import type { Command } from "../protocol/messages";
import type { SettingValues } from "../settings/setting_values";
import type { Commands } from "./commands";
import { byId, setText } from "./dom";

/** The id of the setting that chooses the suspects. */
const SEARCH_SETTING = "setting-outliers";

export class RunBar {
  constructor(private readonly model: Model, connection: Connection, values: SettingValues, commands: Commands) {
    const onClick = (id: string, command: () => Command) =>
      commands.onClick(byId(id), () => connection.send(command()));
    onClick("optimize", () => ({ type: "optimize", settings: values.toSend() }));
    onClick("step", () => ({ type: "step", settings: values.toSend(["iterations", "start"]) }));
    onClick("stop", () => ({ type: "stop" }));
    onClick("reset", () => ({ type: "reset" }));
    onClick("remove-false-edges", () => ({ type: "remove_false_edges" }));
    byId("seek-false-edges").addEventListener("click", () => {
      byId("tab-settings").click();
      document.getElementById(SEARCH_SETTING)?.focus();
    });
    byId("show-report").addEventListener("click", () => byId<HTMLDialogElement>("report").showModal());
    model.observe(() => this.update());
  }

  private update(): void {
    const { state, run, connection, isBusy, hasGraph } = this.model;
    const enable = (id: string, enabled: boolean) => (byId<HTMLButtonElement>(id).disabled = !enabled);
    enable("optimize", hasGraph && !isBusy);
    enable("step", hasGraph && !isBusy && state!.can_step);
    enable("stop", connection.connected && isBusy);
    enable("reset", hasGraph && !isBusy);
    // A unit stays on the line of its number.
    setText(byId("headline"), (run?.headline ?? "").replace(/ s$/, "\u00a0s"));
    byId("outcome").hidden = !run?.headline && !run?.summary;
    byId("show-report").hidden = !run?.summary;
    setText(byId("summary"), run?.summary ?? "");
    this.showQuality(run);
    this.showFalseEdges(run);
    enable("remove-false-edges", hasGraph && !isBusy);
  }

  private showQuality(run: Run | null): void {
    const ratio = run?.chi2_per_degree ?? null;
    const is_poor = run !== null && fitsPoorly(run);
    byId("fit-quality").hidden = ratio === null;
    setText(byId("per-degree"), ratio === null ? "" : `chi2 per degree of freedom: ${general(ratio, 3)}`);
    byId("per-degree").classList.toggle("poor", is_poor);
    const can_seek = this.model.form?.settings.some(({ name }) => name === "outliers") ?? false;
    byId("seek-false-edges").hidden = !is_poor || !can_seek;
  }

  private showFalseEdges(run: Run | null): void {
    const number = run?.false_edges ?? 0;
    byId("false-edges").hidden = number === 0;
    const are = number === 1 ? "is" : "are";
    setText(byId("false-edges-note"), `${counted(number, "false edge", "false edges")} ${are} still in the graph. Save writes ${number === 1 ? "it" : "them"}, too.`);
    setText(byId("remove-false-edges"), number === 1 ? "Remove it" : "Remove them");
    // A page cannot edit the graph of a program.
    byId("remove-false-edges").hidden = this.model.state?.opens_no_files !== null;
  }
}
