// SPDX-License-Identifier: BSD-3-Clause
// The control of one setting. It is made from the form of the server; nothing here knows a name of a setting.
import { label } from "../format";
import { create, setText } from "../panels/dom";
import type { Choice, Setting } from "../protocol/messages";
import { kernelControl } from "./kernel_control";
import type { SettingValues } from "./setting_values";

/** What a field consists of: elements, and how they show a value. */
export interface Control {
  elements: HTMLElement[];
  show(value: string): void;
  enable(enabled: boolean): void;
}

export interface Field {
  element: HTMLElement;
  /** Shows the current value. */
  update(): void;
}

/** A line with the name of the setting and its control. */
export function settingField(setting: Setting, values: SettingValues): Field {
  const id = settingId(setting);
  const control = settingControl(setting, values);
  const note = create("p", { id: `${id}-note`, className: "dim note" });
  const help = create("span", { id: `${id}-help`, className: "for-readers" }, `${setting.help}.`);
  const name = create("label", { htmlFor: id }, label(setting.name));
  const element = create("div", { className: "setting", title: setting.help },
    name, create("div", { className: "control" }, ...control.elements), help, note);
  control.elements[0]!.setAttribute("aria-describedby", `${help.id} ${note.id}`);
  const update = () => {
    const why_disabled = values.whyDisabled(setting);
    const value = values.value(setting);
    control.show(value);
    control.enable(why_disabled === "");
    setText(note, why_disabled);
    note.hidden = why_disabled === "";
    element.classList.toggle("changed", why_disabled === "" && value !== setting.default);
    element.classList.toggle("disabled", why_disabled !== "");
  };
  update();
  return { element, update };
}

/** Only the control, for another place than the form. */
export function settingControl(setting: Setting, values: SettingValues): Control {
  const id = settingId(setting);
  const take = (value: string) => values.choose(setting.name, value);
  if (setting.kind === "choice") return choiceControl(id, setting.choices ?? [], take);
  if (setting.kind === "kernel") return kernelControl(id, setting.choices ?? [], take);
  return numberControl(id, setting, take);
}

export function settingId(setting: Setting): string {
  return `setting-${setting.name}`;
}

function choiceControl(id: string, choices: Choice[], take: (value: string) => void): Control {
  const select = create("select", { id }, ...choices.map(choiceOption));
  select.addEventListener("change", () => take(select.value));
  return { elements: [select], show: (value) => (select.value = value), enable: (enabled) => (select.disabled = !enabled) };
}

/** An unsuitable choice is disabled, and says why. */
export function choiceOption({ value, unsuitable }: Choice): HTMLOptionElement {
  const text = unsuitable ? `${value} (${unsuitable})` : value;
  return create("option", { value, disabled: unsuitable !== null, title: unsuitable ?? "" }, text);
}

function numberControl(id: string, setting: Setting, take: (value: string) => void): Control {
  const is_whole = setting.kind === "whole number";
  const input = create("input", { id, type: is_whole ? "number" : "text", autocomplete: "off" });
  input.placeholder = setting.default || "default";
  if (is_whole) Object.assign(input, { min: "0", step: "1", inputMode: "numeric" });
  else input.inputMode = "decimal";
  input.addEventListener("input", () => take(input.value.trim()));
  const elements: HTMLElement[] = [input];
  // "N" and "X" only say that it is a number.
  const { unit } = setting;
  if (unit && unit.length > 1) elements.push(create("span", { className: "dim" }, unit.toLowerCase()));
  return {
    elements,
    // An empty field is the default; its placeholder says so.
    show: (value) => {
      if (document.activeElement !== input) input.value = value;
    },
    enable: (enabled) => (input.disabled = !enabled),
  };
}
