// SPDX-License-Identifier: BSD-3-Clause
// The choice of a kernel: "" for none, a name such as "Huber", or a name with a parameter, which is offered as "Barron:ALPHA" and
// chosen as "Barron:-2".
import { create, setText } from "../panels/dom";
import type { Choice } from "../protocol/messages";
import { type Control, choiceOption } from "./setting_field";

const FIRST_PARAMETER = "1";

export function kernelControl(id: string, choices: Choice[], take: (value: string) => void): Control {
  const none = create("option", { value: "" }, "none");
  const select = create("select", { id }, none, ...choices.map((choice) => {
    const option = choiceOption(choice);
    option.value = base(choice.value);
    setText(option, option.textContent!.replace(choice.value, option.value));
    return option;
  }));
  const input = create("input", { id: `${id}-parameter`, type: "text", inputMode: "decimal", autocomplete: "off" });
  const name = create("span", { className: "dim" });
  const parameter = create("label", { className: "parameter", hidden: true }, name, input);
  const parameterName = () => choices.find((each) => base(each.value) === select.value)?.value.split(":")[1] ?? "";
  const value = () => (parameterName() ? `${select.value}:${input.value.trim()}` : select.value);
  select.addEventListener("change", () => {
    if (input.value.trim() === "") input.value = FIRST_PARAMETER;
    take(value());
  });
  input.addEventListener("input", () => take(value()));
  return {
    elements: [select, parameter],
    show: (text) => {
      select.value = base(text);
      if (document.activeElement !== input) input.value = text.split(":")[1] ?? input.value;
      setText(name, parameterName().toLowerCase());
      parameter.hidden = parameterName() === "";
    },
    enable: (enabled) => (select.disabled = input.disabled = !enabled),
  };
}

function base(value: string): string {
  return value.split(":")[0]!;
}
