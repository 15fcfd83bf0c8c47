// SPDX-License-Identifier: BSD-3-Clause
// The controls that forms are made of.
import { count } from "../format";
import { create, setText } from "./dom";

export interface Range {
  min: number;
  max: number;
  step: number;
  value: number;
}

/** `take` stores the value, and returns its text. */
export function slider(id: string, name: string, range: Range, take: (value: number) => string): HTMLElement {
  const input = create("input", { type: "range", id });
  // The limits come first, because they limit the value.
  for (const key of ["min", "max", "step", "value"] as const) input[key] = String(Math.min(range[key], range.max));
  const output = create("output", {}, take(input.valueAsNumber));
  input.addEventListener("input", () => setText(output, take(input.valueAsNumber)));
  return create("label", { className: "slider" }, name, input, output);
}

/** A check box with a name, and details in a fainter color. */
export function checkBox(
  id: string, checked: boolean, label: (Node | string)[], details: string, take: (checked: boolean) => void,
): HTMLElement {
  const box = create("input", { type: "checkbox", id, checked });
  box.addEventListener("input", () => take(box.checked));
  return create("label", { className: "check", title: details }, box, ...label,
    create("span", { className: "type" }, details));
}

/** A list of which one value is chosen; `names` are what the user reads. */
export function choice<T extends string>(
  id: string, label: string, value: T, names: Record<T, string>, take: (value: T) => void,
): HTMLElement {
  const options = (Object.keys(names) as T[]).map((each) => create("option", { value: each }, names[each]));
  const list = create("select", { id }, ...options);
  list.setAttribute("aria-label", label);
  list.value = value;
  list.addEventListener("input", () => take(list.value as T));
  return list;
}

/**
 * A field for a color, with a button that goes back to the default. `take` gets null for the
 * default.
 */
export function colorField(
  id: string, name: string, color: string | null, default_color: string, take: (color: string | null) => void,
): HTMLElement {
  const input = create("input", { type: "color", id, title: `Color: ${name}`, value: color ?? default_color });
  input.setAttribute("aria-label", `Color: ${name}`);
  const back = create("button", { type: "button", className: "quiet back", title: `Default color: ${name}` }, "↺");
  back.setAttribute("aria-label", `Default color: ${name}`);
  const showBack = (is_chosen: boolean) => (back.disabled = !is_chosen);
  showBack(color !== null);
  input.addEventListener("input", () => {
    showBack(true);
    take(input.value);
  });
  back.addEventListener("click", () => {
    input.value = default_color;
    showBack(false);
    take(null);
    input.focus();
    // Forms listen to this event of all their controls.
    input.parentElement!.dispatchEvent(new Event("input", { bubbles: true }));
  });
  return create("span", { className: "color" }, input, back);
}

/** The sign of a type in the picture; `kind` is the name of its color and shape in style.css. */
export function swatch(kind: string): HTMLElement {
  return create("span", { className: `swatch ${kind}` });
}

/** A number at the end of a line. */
export function lineNumber(value: number): HTMLElement {
  return create("span", { className: "number" }, count(value));
}

export function fieldset(title: string, children: HTMLElement[]): HTMLElement {
  return create("fieldset", {}, create("legend", {}, title), ...children);
}
