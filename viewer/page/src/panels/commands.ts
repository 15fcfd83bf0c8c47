// SPDX-License-Identifier: BSD-3-Clause
// Carries out what asks something of the server, and shows why it was refused.
import type { Banners } from "./banners";

export class Commands {
  constructor(private readonly banners: Banners) {}

  /** Shows the error of the action, if any, after the words `what`. */
  async run(what: string, action: () => Promise<void>): Promise<void> {
    this.banners.showCommandError("");
    try {
      await action();
    } catch (error) {
      const is_silent = error instanceof TypeError || error instanceof DOMException;
      this.banners.showCommandError(`${what}: ${is_silent ? "boxplus does not answer" : (error as Error).message}`);
    }
  }

  /** Calls the action at each click. */
  onClick(button: HTMLElement, action: () => Promise<void>): void {
    button.addEventListener("click", () => void this.run("The command was not carried out", action));
  }
}
