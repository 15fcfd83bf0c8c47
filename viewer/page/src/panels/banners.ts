// SPDX-License-Identifier: BSD-3-Clause
// What went wrong, in plain text over the scene.
import type { Model } from "../model";
import { byId, setText, setTextOrHide } from "./dom";

export class Banners {
  private readonly command = byId("command-error");

  constructor(private readonly model: Model) {
    this.command.querySelector("button")!.addEventListener("click", () => this.showCommandError(""));
    model.observe(() => this.update());
  }

  showCommandError(text: string): void {
    setText(this.command.querySelector("span")!, text);
    this.command.hidden = text === "";
  }

  private update(): void {
    const { connection, state } = this.model;
    setTextOrHide(byId("connection-error"), connection.connected ? "" : connection.problem);
    setTextOrHide(byId("file-error"), state?.error ? `The file could not be read.\n${state.error}` : "");
    setTextOrHide(byId("empty"), state && !state.file && !state.error && !state.busy ? "No file is open." : "");
  }
}
