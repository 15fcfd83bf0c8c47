// SPDX-License-Identifier: BSD-3-Clause
// The form of all settings, by groups. The number of iterations stands beside the buttons of a run.
import type { Model } from "../model";
import { fieldset } from "../panels/controls";
import { byId, create, setText } from "../panels/dom";
import type { Form } from "../protocol/messages";
import { type Field, settingControl, settingField } from "./setting_field";
import type { SettingValues } from "./setting_values";

const IN_RUN_BAR = "iterations";
/** Groups whose names would be confused with each other. */
const TITLES: Record<string, string> = { Outliers: "Robust kernel", "False edges": "Search for false edges" };

export class SettingsForm {
  private shown: Form | null = null;
  private updates: (() => void)[] = [];
  private readonly reset = create("button", { id: "reset-settings", type: "button" }, "Reset to defaults");

  constructor(private readonly model: Model, private readonly values: SettingValues) {
    this.reset.addEventListener("click", () => values.reset());
    for (const place of [byId("settings"), byId("iterations-limit")]) {
      place.addEventListener("keydown", (event) => {
        if (event.key === "Enter" && event.target instanceof HTMLInputElement) byId("optimize").click();
      });
    }
    model.observe(() => this.showForm());
    values.observe(() => this.update());
  }

  /** Builds the form anew if another file was opened. */
  private showForm(): void {
    const { form } = this.model;
    if (!form || form === this.shown) return;
    const is_same = JSON.stringify(form) === JSON.stringify(this.shown);
    this.shown = form;
    if (!is_same) this.build(form);
    this.values.setForm(form);
  }

  private build(form: Form): void {
    const groups = new Map<string, Field[]>();
    this.values.setForm(form);
    this.updates = [];
    byId("iterations-limit").hidden = true;
    for (const setting of form.settings) {
      if (setting.name === IN_RUN_BAR) {
        const control = settingControl(setting, this.values);
        byId("iterations-limit").hidden = false;
        byId("iterations-limit").title = setting.help;
        byId("iterations-limit").replaceChildren("At most", ...control.elements, create("span", { className: "dim" }, "iterations"));
        this.updates.push(() => control.show(this.values.value(setting)));
        continue;
      }
      const field = settingField(setting, this.values);
      this.updates.push(field.update);
      groups.set(setting.group, [...(groups.get(setting.group) ?? []), field]);
    }
    const sets = [...groups].map(([title, fields]) => fieldset(TITLES[title] ?? title, fields.map((field) => field.element)));
    byId("settings").replaceChildren(...sets, this.reset);
  }

  private update(): void {
    for (const update of this.updates) update();
    const changed = Object.keys(this.values.toSend([IN_RUN_BAR])).length;
    setText(byId("tab-settings"), changed > 0 ? `Settings (${changed})` : "Settings");
    this.reset.disabled = Object.keys(this.values.toSend()).length === 0;
  }
}
