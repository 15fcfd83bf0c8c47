// SPDX-License-Identifier: BSD-3-Clause
// The whole window takes a file that is dropped on it, and says so while a file is over it.
import { byId, setText } from "./dom";

export interface DropListener {
  take(file: File): void;
  refuse(sentence: string): void;
}

export class DropTarget {
  private readonly sign = byId("drop");
  /** Elements of the page that the file entered and did not leave. */
  private entered = 0;

  /** `why_not` returns the sentence why no file can be dropped now, or "". */
  constructor(private readonly why_not: () => string, private readonly listener: DropListener) {
    const listen = (type: "dragenter" | "dragover" | "dragleave" | "drop", react: (event: DragEvent) => void) =>
      window.addEventListener(type, (event) => {
        if (!event.dataTransfer?.types.includes("Files")) return;
        event.preventDefault();
        react(event);
      });
    listen("dragenter", () => this.show(this.entered + 1));
    listen("dragleave", () => this.show(this.entered - 1));
    listen("dragover", (event) => (event.dataTransfer!.dropEffect = this.why_not() === "" ? "copy" : "none"));
    listen("drop", (event) => {
      this.show(0);
      this.drop(event.dataTransfer!);
    });
  }

  private show(entered: number): void {
    this.entered = Math.max(0, entered);
    this.sign.hidden = this.entered === 0;
    const why_not = this.why_not();
    this.sign.classList.toggle("refuses", why_not !== "");
    setText(this.sign.querySelector("p")!, why_not || "Drop the file to open it");
  }

  private drop(data: DataTransfer): void {
    const why_not = this.why_not();
    const is_folder = data.items[0]?.webkitGetAsEntry()?.isDirectory ?? false;
    const file = data.files[0];
    if (why_not) this.listener.refuse(why_not);
    else if (data.files.length !== 1 || !file) this.listener.refuse("Only one file can be opened at a time.");
    else if (is_folder) this.listener.refuse("A folder cannot be dropped. Start boxplus view with this folder instead.");
    else this.listener.take(file);
  }
}
