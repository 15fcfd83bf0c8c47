// SPDX-License-Identifier: BSD-3-Clause
// The buttons that send commands, and what came of the last run.
import type { Model } from "../model";
import type { Connection } from "../protocol/connection";
import type { Command } from "../protocol/messages";
import type { SettingValues } from "../settings/setting_values";
import type { Commands } from "./commands";
import { byId, setText } from "./dom";

export class RunBar {
  constructor(private readonly model: Model, connection: Connection, values: SettingValues, commands: Commands) {
    const onClick = (id: string, command: () => Command) =>
      commands.onClick(byId(id), () => connection.send(command()));
    onClick("optimize", () => ({ type: "optimize", settings: values.toSend() }));
    onClick("step", () => ({ type: "step", settings: values.toSend(["iterations", "start"]) }));
    onClick("stop", () => ({ type: "stop" }));
    onClick("reset", () => ({ type: "reset" }));
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
  }
}
