// SPDX-License-Identifier: BSD-3-Clause
// The button that computes how uncertain positions are.
import type { Model } from "../model";
import type { Connection } from "../protocol/connection";
import type { Commands } from "./commands";

export class Covariances {
  constructor(button: HTMLButtonElement, model: Model, connection: Connection, commands: Commands) {
    commands.onClick(button, () => connection.send({ type: "covariances" }));
    model.observe(() => (button.disabled = !model.hasGraph || model.isBusy));
  }
}
