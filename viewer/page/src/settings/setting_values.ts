// SPDX-License-Identifier: BSD-3-Clause
// The values of the settings that the user chose: texts, by the names of the settings. They survive a reload, and stay if another
// graph makes other choices unsuitable.
import type { Form, Setting, SettingTexts } from "../protocol/messages";
import { asRecord, store, stored } from "../stored";

export class SettingValues {
  private chosen = new Map<string, string>();
  private form: Form = { formats: [], settings: [] };
  private readonly observers: (() => void)[] = [];

  constructor() {
    for (const [name, text] of Object.entries(asRecord(stored("settings")))) {
      if (typeof text === "string") this.chosen.set(name, text);
    }
  }

  /** Calls the observer after each change of a value or of the form. */
  observe(observer: () => void): void {
    this.observers.push(observer);
  }

  setForm(form: Form): void {
    this.form = form;
    this.notify();
  }

  choose(name: string, text: string): void {
    const setting = this.setting(name);
    if (setting && text === setting.default) this.chosen.delete(name);
    else this.chosen.set(name, text);
    this.changed();
  }

  reset(): void {
    this.chosen.clear();
    this.changed();
  }

  /** The default if nothing else is chosen, or if the choice is unsuitable. */
  value(setting: Setting): string {
    const text = this.chosen.get(setting.name);
    if (text === undefined || text === "") return setting.default;
    const is_suitable = setting.kind !== "choice" || setting.choices?.some((each) => each.value === text && !each.unsuitable);
    return is_suitable ? text : setting.default;
  }

  /** The sentence why the setting has no meaning, or "". */
  whyDisabled(setting: Setting): string {
    if (!setting.needs) return "";
    const other = this.setting(setting.needs.setting);
    if (!other) return "";
    const { value } = setting.needs;
    const is_met = this.whyDisabled(other) === "" && (value === "" ? this.value(other) !== "" : this.value(other) === value);
    return is_met ? "" : `Needs ${value === "" ? `a ${other.name}` : value}`;
  }

  /** The settings that are not at their default and have a meaning. */
  toSend(except: string[] = []): SettingTexts {
    const texts: SettingTexts = {};
    for (const setting of this.form.settings) {
      const text = this.value(setting);
      if (text !== setting.default && !except.includes(setting.name) && this.whyDisabled(setting) === "")
        texts[setting.name] = text;
    }
    return texts;
  }

  private setting(name: string): Setting | undefined {
    return this.form.settings.find((each) => each.name === name);
  }

  private changed(): void {
    store("settings", Object.fromEntries(this.chosen));
    this.notify();
  }

  private notify(): void {
    for (const observer of this.observers) observer();
  }
}
