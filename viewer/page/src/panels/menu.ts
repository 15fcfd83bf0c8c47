// SPDX-License-Identifier: BSD-3-Clause
// A button that opens a list of actions. Arrow keys move in the list, Escape closes it.
import { create } from "./dom";

export interface MenuItem {
  id: string;
  text: string;
  /** Why the item cannot be chosen now. */
  disabled?: string | null;
  choose(): void;
}

export class Menu {
  private readonly list: HTMLElement;

  /** `items` is called each time the list opens. */
  constructor(private readonly button: HTMLElement, private readonly items: () => MenuItem[]) {
    const list_id = `${button.id}-list`;
    this.list = create("div", { id: list_id, className: "menu-list", hidden: true, role: "menu" });
    this.list.setAttribute("aria-label", button.textContent!.replace(/[…▾]/g, "").trim());
    button.setAttribute("aria-haspopup", "menu");
    button.setAttribute("aria-expanded", "false");
    button.setAttribute("aria-controls", list_id);
    button.after(this.list);
    button.addEventListener("click", () => (this.list.hidden ? this.open() : this.close()));
    button.addEventListener("keydown", (event) => {
      if (event.key !== "ArrowDown" && event.key !== "ArrowUp") return;
      event.preventDefault();
      if (this.list.hidden) this.open();
      this.move(event.key === "ArrowDown" ? 0 : -1);
    });
    this.list.addEventListener("keydown", (event) => this.onKey(event));
    document.addEventListener("pointerdown", (event) => {
      if (!this.contains(event.target)) this.close();
    });
    document.addEventListener("focusin", (event) => {
      if (!this.contains(event.target)) this.close();
    });
  }

  private open(): void {
    this.list.replaceChildren(...this.items().map((item) => this.line(item)));
    this.list.hidden = false;
    this.button.setAttribute("aria-expanded", "true");
    this.move(0);
  }

  private close(): void {
    this.list.hidden = true;
    this.button.setAttribute("aria-expanded", "false");
  }

  /** Items that cannot be chosen keep the focus, so that everyone can read why. */
  private line({ id, text, disabled, choose }: MenuItem): HTMLElement {
    const line = create("button", { id, type: "button", role: "menuitem", tabIndex: -1 }, text);
    if (disabled) {
      line.setAttribute("aria-disabled", "true");
      line.append(create("span", { className: "reason" }, disabled));
    }
    line.addEventListener("click", () => {
      if (disabled) return;
      this.close();
      this.button.focus();
      choose();
    });
    return line;
  }

  private onKey(event: KeyboardEvent): void {
    const lines = [...this.list.children];
    const at = lines.indexOf(document.activeElement!);
    const targets: Record<string, number> = { ArrowDown: at + 1, ArrowUp: at - 1, Home: 0, End: -1 };
    const target = targets[event.key];
    if (target !== undefined) {
      event.preventDefault();
      this.move(target);
    } else if (event.key === "Escape") {
      event.preventDefault();
      this.close();
      this.button.focus();
    } else if (event.key === "Tab") {
      this.close();
    }
  }

  private move(to: number): void {
    const lines = this.list.querySelectorAll<HTMLElement>("[role=menuitem]");
    lines[(to + lines.length) % lines.length]?.focus();
  }

  private contains(target: EventTarget | null): boolean {
    return target instanceof Node && (this.list.contains(target) || this.button.contains(target));
  }
}
