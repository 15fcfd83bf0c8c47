// SPDX-License-Identifier: BSD-3-Clause
// Keys that act wherever the focus is, except in a field in which one types, and the sheet that lists them.
import { byId, create } from "./dom";

export interface Shortcut {
  /** As keyName() gives them. */
  keys: string[];
  /** What it does. */
  text: string;
  /** The control with the same effect, which the key clicks unless there is an `action`. */
  control?: string;
  action?: () => void;
  /** Acts again and again while the key is down. */
  repeats?: boolean;
}

/** A line of the sheet: a key and what it does. */
export type Line = [string, string];

export type ShortcutGroups = Record<string, Shortcut[]>;

/** What the key of an event is called: "Shift+R", "r", "?". Null with other modifiers, which belong to the browser. */
export function keyName({ key, shiftKey, ctrlKey, metaKey, altKey }: KeyboardEvent): string | null {
  if (ctrlKey || metaKey || altKey) return null;
  // Only letters have names for both of their cases; Caps Lock must not matter.
  if (!/^[a-z]$/i.test(key)) return key;
  return shiftKey ? `Shift+${key.toUpperCase()}` : key.toLowerCase();
}

const TYPED_INPUTS = ["text", "number", "search", "email", "url", "password", "date", "time"];

/** True if letters that are typed there belong to the element. */
export function takesLetters(element: { tagName: string; type?: string; isContentEditable?: boolean }): boolean {
  if (element.tagName === "INPUT") return TYPED_INPUTS.includes(element.type ?? "text");
  return ["TEXTAREA", "SELECT"].includes(element.tagName) || element.isContentEditable === true;
}

export class Shortcuts {
  private readonly by_key = new Map<string, Shortcut>();

  /** `with_focus` are further lines of the sheet, by the names of groups. */
  constructor(groups: ShortcutGroups, with_focus: Record<string, Line[]>) {
    for (const shortcut of Object.values(groups).flat()) {
      for (const key of shortcut.keys) this.by_key.set(key, shortcut);
      if (shortcut.control) describe(shortcut);
    }
    for (const [title, shortcuts] of Object.entries(groups)) {
      const lines = shortcuts.map(({ keys, text }): Line => [keys[0]!, text]);
      byId("help-keys").append(section(title, [...lines, ...(with_focus[title] ?? [])]));
    }
    document.addEventListener("keydown", (event) => this.onKey(event));
    byId("show-help").addEventListener("click", () => byId<HTMLDialogElement>("help").showModal());
  }

  private onKey(event: KeyboardEvent): void {
    const name = keyName(event);
    const shortcut = name === null ? undefined : this.by_key.get(name);
    if (!shortcut || event.defaultPrevented || document.querySelector("dialog[open]")) return;
    if (event.target instanceof HTMLElement && takesLetters(event.target)) return;
    if (event.repeat && !shortcut.repeats) return;
    event.preventDefault();
    if (shortcut.action) shortcut.action();
    else document.getElementById(shortcut.control!)?.click();
  }
}

/** Tells the key in the hint of the control, and to readers of the screen. */
function describe({ keys, control }: Shortcut): void {
  const element = document.getElementById(control!);
  if (!element) return;
  element.setAttribute("aria-keyshortcuts", keys[0]!);
  element.title = `${element.title || element.textContent!.trim()} (${shown(keys[0]!)})`;
}

function section(title: string, lines: Line[]): HTMLElement {
  const rows = lines.map(([key, text]) =>
    create("tr", {}, create("td", {}, create("kbd", {}, shown(key))), create("td", {}, text)));
  return create("section", {}, create("h3", {}, title), create("table", {}, create("tbody", {}, ...rows)));
}

function shown(key: string): string {
  return key.length === 1 ? key.toUpperCase() : key.replace("+", " + ");
}
