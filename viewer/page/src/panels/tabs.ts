// SPDX-License-Identifier: BSD-3-Clause
// The tabs of the panel: one section is visible. Arrow keys move between them.
import { byId } from "./dom";

export class Tabs {
  private readonly tabs = [...byId("tabs").querySelectorAll<HTMLButtonElement>("[role=tab]")];

  constructor() {
    this.tabs.forEach((tab, i) => {
      tab.addEventListener("click", () => this.select(tab));
      tab.addEventListener("keydown", (event) => {
        const move = event.key === "ArrowRight" ? 1 : event.key === "ArrowLeft" ? -1 : 0;
        if (move === 0) return;
        const next = this.tabs[(i + move + this.tabs.length) % this.tabs.length]!;
        this.select(next);
        next.focus();
      });
    });
    this.select(this.tabs[0]!);
  }

  private select(selected: HTMLButtonElement): void {
    for (const tab of this.tabs) {
      const is_selected = tab === selected;
      tab.setAttribute("aria-selected", String(is_selected));
      tab.tabIndex = is_selected ? 0 : -1;
      byId(tab.getAttribute("aria-controls")!).hidden = !is_selected;
    }
  }
}
