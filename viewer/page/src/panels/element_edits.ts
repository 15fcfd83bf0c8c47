// SPDX-License-Identifier: BSD-3-Clause
// The buttons that change the selected vertex or edge.
import { type ElementFacts, lastingName } from "../protocol/element";
import type { EditKind } from "../protocol/messages";
import { create } from "./dom";

/** What the user typed last. */
let factor_text = "0.1";

/** Elements with the same state have the same buttons. */
export function editState(facts: ElementFacts): string {
  const { key, number } = lastingName(facts);
  const flags = facts.kind === "vertex" ? [facts.is_fixed, facts.fixed_directions.length > 0] : [facts.is_enabled];
  return [key, number, ...flags].join(" ");
}

/** `edit` is called with a factor if the kind is "scale". */
export function editButtons(facts: ElementFacts, edit: (kind: EditKind, factor?: string) => void): HTMLElement {
  const button = (kind: EditKind, text: string, title: string) => {
    const element = create("button", { id: `edit-${kind}`, type: "button", title }, text);
    element.addEventListener("click", () => edit(kind));
    return element;
  };
  const place = create("div", { id: "element-edits" });
  if (facts.kind === "vertex") {
    const is_free = !facts.is_fixed && facts.fixed_directions.length === 0;
    if (!facts.is_fixed) place.append(button("fix", "Fix", "The vertex keeps its estimate"));
    if (!is_free) place.append(button("free", "Free", "The vertex moves in all directions"));
    place.append(button("remove", "Remove", "Removes the vertex and its edges from the graph, not from the file"));
    return place;
  }
  place.append(
    facts.is_enabled
      ? button("disable", "Disable", "The edge has no influence")
      : button("enable", "Enable", "The edge has its influence again"),
    button("remove", "Remove", "Removes the edge from the graph, not from the file"),
    scaleForm(facts.edge, (factor) => edit("scale", factor)));
  return place;
}

function scaleForm(edge: number, scale: (factor: string) => void): HTMLElement {
  const input = create("input", { id: "edit-factor", type: "text", inputMode: "decimal", autocomplete: "off" });
  input.value = factor_text;
  input.addEventListener("input", () => (factor_text = input.value));
  input.setAttribute("aria-label", `Factor of the information of edge ${edge}`);
  const form = create("form", {}, create("button", { id: "edit-scale", title: "Multiplies the information by the factor" }, "Ω ×"), input);
  form.addEventListener("submit", (event) => {
    event.preventDefault();
    scale(input.value.trim());
  });
  return form;
}
