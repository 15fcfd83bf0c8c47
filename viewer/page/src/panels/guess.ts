// SPDX-License-Identifier: BSD-3-Clause
// The menu of initial guesses: the choices of the setting `start` that compute estimates.
import { label } from "../format";
import type { Model } from "../model";
import type { Connection } from "../protocol/connection";
import type { Commands } from "./commands";
import { byId } from "./dom";
import { Menu, type MenuItem } from "./menu";

/** Choices of a run that do not compute anything by themselves. */
const NO_GUESSES = ["automatic", "current"];

export class Guess {
  private readonly button = byId<HTMLButtonElement>("guess");

  constructor(private readonly model: Model, private readonly connection: Connection, private readonly commands: Commands) {
    new Menu(this.button, () => this.items());
    model.observe(() => {
      this.button.disabled = !model.hasGraph || model.isBusy;
      this.button.hidden = model.form !== null && this.choices().length === 0;
    });
  }

  private choices() {
    const start = this.model.form?.settings.find((setting) => setting.name === "start");
    return (start?.choices ?? []).filter(({ value }) => !NO_GUESSES.includes(value));
  }

  private items(): MenuItem[] {
    return this.choices().map(({ value, unsuitable }) => ({
      id: `guess-${value}`,
      text: label(value),
      disabled: unsuitable,
      choose: () => void this.commands.run("There is no initial guess", () =>
        this.connection.send({ type: "guess", start: value })),
    }));
  }
}
