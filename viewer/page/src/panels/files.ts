// SPDX-License-Identifier: BSD-3-Clause
// Opens files, by a dialog or by drag and drop, and saves the graph as a download.
import { askForFile, download, stem } from "../download";
import type { Model } from "../model";
import type { Connection } from "../protocol/connection";
import type { FileFormat } from "../protocol/messages";
import type { Banners } from "./banners";
import type { Commands } from "./commands";
import { byId, setText } from "./dom";
import { DropTarget } from "./drop_target";
import { Menu } from "./menu";

/** The limit of the server. */
const MOST_BYTES = 2 ** 30;

export class Files {
  private sending = "";
  private readonly open_buttons: HTMLButtonElement[];
  /** Those of the buttons while they can be used. */
  private readonly titles: Map<HTMLButtonElement, string>;

  constructor(
    private readonly model: Model, private readonly connection: Connection, private readonly commands: Commands,
    private readonly banners: Banners, private readonly open_truth: HTMLButtonElement | null,
  ) {
    this.open_buttons = [byId<HTMLButtonElement>("open"), byId<HTMLButtonElement>("open-first"), ...(open_truth ? [open_truth] : [])];
    this.titles = new Map(this.open_buttons.map((button) => [button, button.title]));
    const input = byId<HTMLInputElement>("file-input");
    for (const id of ["open", "open-first"]) {
      byId(id).addEventListener("click", () => askForFile(input, (file) => this.open(file)));
    }
    open_truth?.addEventListener("click", () => askForFile(input, (file) => this.open(file, "truth")));
    new DropTarget(() => this.whyNotNow(), {
      take: (file) => this.open(file),
      refuse: (sentence) => banners.showCommandError(sentence),
    });
    new Menu(byId("save"), () => (model.form?.formats ?? []).map((format) => ({
      id: `save-${format.name}`,
      text: `${format.name} (${format.extension})`,
      choose: () => this.save(format),
    })));
    model.observe(() => this.update());
  }

  private open(file: File, as: "graph" | "truth" = "graph"): void {
    if (file.size > MOST_BYTES) {
      this.banners.showCommandError(`${file.name} is larger than 1 GiB. Start boxplus view with this file instead.`);
      return;
    }
    void this.commands.run(`${file.name} was not opened`, async () => {
      this.setSending(`Sending ${file.name}…`);
      try {
        await this.connection.openFile(file, as);
      } finally {
        this.setSending("");
      }
    });
  }

  private save(format: FileFormat): void {
    void this.commands.run("The graph was not saved", async () => {
      const name = stem(this.model.state?.file?.name ?? "");
      download(await this.connection.graphFile(format.name), `${name}${format.extension}`);
    });
  }

  private setSending(text: string): void {
    this.sending = text;
    this.update();
  }

  /** The sentence why no file can be opened now, or "". */
  private whyNotNow(): string {
    if (!this.model.connection.connected) return "boxplus does not answer, so no file can be opened.";
    const never = this.model.state?.opens_no_files;
    if (never) return sentence(never);
    return this.model.isBusy || this.sending !== "" ? "boxplus is busy. Stop it, or wait, before you open a file." : "";
  }

  private update(): void {
    const { state, hasGraph, isBusy } = this.model;
    const no_file = this.whyNotNow();
    const no_truth = state?.opens_no_truth ? sentence(state.opens_no_truth) : no_file;
    for (const button of this.open_buttons) {
      const why_not = button === this.open_truth ? no_truth : no_file;
      button.disabled = why_not !== "" || (button === this.open_truth && !hasGraph);
      button.title = why_not || (this.titles.get(button) ?? "");
    }
    byId<HTMLButtonElement>("save").disabled = !hasGraph || isBusy || !this.model.form;
    const progress = this.sending || (state?.activity === "reading" ? "Reading the file…" : "");
    setText(byId("progress"), progress);
    byId("progress").hidden = progress === "";
    byId("empty").hidden = state === null || state.file !== null || progress !== "";
  }
}

function sentence(reason: string): string {
  return `${reason.charAt(0).toUpperCase()}${reason.slice(1)}.`;
}
