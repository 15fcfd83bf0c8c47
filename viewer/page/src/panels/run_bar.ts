// SPDX-License-Identifier: BSD-3-Clause
// The buttons that send commands, and what came of the last run.
import type { Model } from "../model";
import type { Connection } from "../protocol/connection";
import type { Command } from "../protocol/messages";
import { byId, setText } from "./dom";

export class RunBar {
  private readonly iterations = byId<HTMLInputElement>("iterations-limit");

  constructor(
    private readonly model: Model, private readonly connection: Connection,
    private readonly on_error: (text: string) => void,
  ) {
    this.onClick("optimize", () => this.optimizeCommand());
    this.onClick("step", () => ({ type: "step" }));
    this.onClick("stop", () => ({ type: "stop" }));
    this.onClick("reset", () => ({ type: "reset" }));
    byId("show-report").addEventListener("click", () => byId<HTMLDialogElement>("report").showModal());
    this.iterations.addEventListener("keydown", (event) => {
      if (event.key === "Enter") byId("optimize").click();
    });
    model.observe(() => this.update());
  }

  private optimizeCommand(): Command {
    const iterations = this.iterations.valueAsNumber;
    return Number.isFinite(iterations) ? { type: "optimize", iterations } : { type: "optimize" };
  }

  private onClick(id: string, command: () => Command): void {
    byId(id).addEventListener("click", async () => {
      this.on_error("");
      try {
        await this.connection.send(command());
      } catch (error) {
        const is_silent = error instanceof TypeError || error instanceof DOMException;
        const text = is_silent ? "boxplus does not answer" : (error as Error).message;
        this.on_error(`The command was not carried out: ${text}`);
      }
    });
  }

  private update(): void {
    const { state, run, connection, isBusy } = this.model;
    const has_graph = connection.connected && state !== null && state.file !== null && !state.error;
    const enable = (id: string, enabled: boolean) => (byId<HTMLButtonElement>(id).disabled = !enabled);
    enable("optimize", has_graph && !isBusy);
    enable("step", has_graph && !isBusy && state.can_step);
    enable("stop", connection.connected && isBusy);
    enable("reset", has_graph && !isBusy);
    setText(byId("headline"), run?.headline ?? "");
    byId("show-report").hidden = !run?.summary;
    setText(byId("summary"), run?.summary ?? "");
  }
}
