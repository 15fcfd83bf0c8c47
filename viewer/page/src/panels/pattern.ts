// SPDX-License-Identifier: BSD-3-Clause
// The dialog with pictures of H and its factor L, with the vertices by their ids and in the order that makes L sparse.
import { count, counted, general } from "../format";
import type { Model } from "../model";
import type { Connection } from "../protocol/connection";
import type { Pattern, PatternPicture } from "../protocol/messages";
import type { Commands } from "./commands";
import { byId, create, setText } from "./dom";

const NAMES: Record<PatternPicture["name"], string> = {
  H_by_id: "H, vertices by id",
  H_ordered: "H, by minimum degree",
  L_by_id: "L, vertices by id",
  L_ordered: "L, by minimum degree",
};
/** The opacity of a cell with one block, and of the fullest cell. */
const FAINTEST = 0.35, STRONGEST = 1;
/** With fewer cells, each one is a sharp square. */
const COARSE = 200;

export class PatternDialog {
  constructor(
    button: HTMLButtonElement, model: Model, private readonly connection: Connection, private readonly commands: Commands,
  ) {
    button.addEventListener("click", () => void this.open());
    model.observe(() => (button.disabled = !model.hasGraph || model.isBusy));
  }

  private open(): Promise<void> {
    return this.commands.run("There is no pattern", async () => {
      const pattern = await this.connection.pattern();
      const vertices = counted(pattern.size, "vertex moves", "vertices move");
      setText(byId("pattern-note"), `${vertices}; each has a row of blocks. A cell has ${general(pattern.size / pattern.cells, 3)} rows.`);
      byId("pattern-pictures").replaceChildren(...pattern.pictures.map((picture) => figure(picture, pattern)));
      byId<HTMLDialogElement>("pattern").showModal();
    });
  }
}

function figure(picture: PatternPicture, { cells }: Pattern): HTMLElement {
  const blocks = picture.is_complete ? counted(picture.blocks, "block", "blocks") : `more than ${count(picture.blocks)} blocks`;
  const text = `${NAMES[picture.name]}: ${blocks}`;
  const canvas = create("canvas", { width: Math.max(1, cells), height: Math.max(1, cells) });
  canvas.classList.toggle("coarse", cells < COARSE);
  canvas.setAttribute("role", "img");
  canvas.setAttribute("aria-label", text);
  draw(canvas.getContext("2d")!, picture.counts, cells, picture.name.startsWith("H"));
  return create("figure", {}, canvas, create("figcaption", {}, text));
}

/** A symmetric picture shows its lower triangle on both sides. */
function draw(context: CanvasRenderingContext2D, counts: Uint32Array, cells: number, is_symmetric: boolean): void {
  context.fillStyle = getComputedStyle(document.documentElement).getPropertyValue("--accent");
  const most = counts.reduce((a, b) => Math.max(a, b), 1);
  for (let row = 0; row < cells; ++row) {
    for (let column = 0; column <= row; ++column) {
      const blocks = counts[row * cells + column]!;
      if (blocks === 0) continue;
      const strength = most > 1 ? Math.log(blocks) / Math.log(most) : 1;
      context.globalAlpha = FAINTEST + (STRONGEST - FAINTEST) * strength;
      context.fillRect(column, row, 1, 1);
      if (is_symmetric && row !== column) context.fillRect(row, column, 1, 1);
    }
  }
}
