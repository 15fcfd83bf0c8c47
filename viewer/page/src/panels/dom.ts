// SPDX-License-Identifier: BSD-3-Clause
// Elements of the page. Text becomes text, never markup.

/** Returns the element of index.html with this id. */
export function byId<T extends HTMLElement = HTMLElement>(id: string): T {
  const element = document.getElementById(id);
  if (!element) throw new Error(`the page has no element "${id}"`);
  return element as T;
}

export function create<K extends keyof HTMLElementTagNameMap>(
  tag: K, properties: Partial<HTMLElementTagNameMap[K]> = {}, ...children: (Node | string)[]
): HTMLElementTagNameMap[K] {
  const element = Object.assign(document.createElement(tag), properties);
  element.append(...children);
  return element;
}

/** Changes the text only if it differs, so that a selection stays. */
export function setText(element: HTMLElement, text: string): void {
  if (element.textContent !== text) element.textContent = text;
}

/** Shows the text; hides the element if the text is empty. */
export function setTextOrHide(element: HTMLElement, text: string): void {
  setText(element, text);
  element.hidden = text === "";
}

/** Replaces what is in the place. What is `kept` does not move, so that focus, selection, and a press of a button stay. */
export function replaceAround(place: HTMLElement, before: Node[], kept: HTMLElement, after: Node[]): void {
  if (kept.parentElement !== place) place.replaceChildren(kept);
  for (const child of [...place.childNodes]) if (child !== kept) child.remove();
  kept.before(...before);
  kept.after(...after);
}

/** Calls `change`, and then scrolls to the end if the end was visible before. */
export function keepAtEnd(scroller: HTMLElement, change: () => void): void {
  const was_at_end = scroller.scrollTop + scroller.clientHeight >= scroller.scrollHeight - 4;
  change();
  if (was_at_end) scroller.scrollTop = scroller.scrollHeight;
}
