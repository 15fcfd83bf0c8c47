// SPDX-License-Identifier: BSD-3-Clause
// What went wrong, in plain text over the scene, and notices of what happened.
import type { Model } from "../model";
import { byId, setText, setTextOrHide } from "./dom";

export class Banners {
  /** The error of a file that the user closed. */
  private dismissed = "";

  constructor(private readonly model: Model) {
    this.onDismiss("command-error", () => this.showCommandError(""));
    this.onDismiss("notice", () => this.showNotice(""));
    this.onDismiss("file-error", () => {
      this.dismissed = this.model.state?.error ?? "";
      this.update();
    });
    model.observe(() => this.update());
  }

  showCommandError(text: string): void {
    show("command-error", text);
  }

  showNotice(text: string): void {
    show("notice", text);
  }

  private update(): void {
    const { connection, state } = this.model;
    const error = state?.error ?? "";
    if (error === "") this.dismissed = "";
    setTextOrHide(byId("connection-error"), connection.connected ? "" : connection.problem);
    show("file-error", error === "" || error === this.dismissed ? "" : `The file was not opened.\n${error}`);
  }

  private onDismiss(id: string, dismiss: () => void): void {
    byId(id).querySelector("button")!.addEventListener("click", dismiss);
  }
}

function show(id: string, text: string): void {
  setText(byId(id).querySelector("span")!, text);
  byId(id).hidden = text === "";
}
