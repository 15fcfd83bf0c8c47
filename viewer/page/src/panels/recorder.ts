// SPDX-License-Identifier: BSD-3-Clause
// Takes an image of every new frame while it is on, and offers all of them as one file at the end.
import { counted } from "../format";
import { download } from "../download";
import type { SceneView } from "../scene/scene_view";
import { zip } from "../zip";
import { byId, setText } from "./dom";

const MOST_IMAGES = 300;
const MOST_BYTES = 2 ** 28;

export class Recorder {
  private readonly button = byId("record");
  private images: Promise<Blob>[] = [];
  private bytes = 0;
  private is_on = false;

  /** `stem` returns the beginning of file names. */
  constructor(private readonly view: SceneView, private readonly stem: () => string, private readonly notify: (text: string) => void) {
    view.on_frame = () => {
      if (this.is_on) this.take(view.drawnPng());
    };
    this.button.addEventListener("click", () => (this.is_on ? void this.stop("") : this.start()));
  }

  private start(): void {
    this.notify("");
    this.images = [];
    this.bytes = 0;
    // A frame that waits is taken by on_frame.
    const png = this.view.png();
    this.is_on = true;
    this.take(png);
  }

  private take(image: Promise<Blob>): void {
    this.images.push(image);
    this.show();
    // stop() tells the error of an image.
    image.then((blob) => (this.bytes += blob.size), () => {});
    if (this.images.length >= MOST_IMAGES || this.bytes >= MOST_BYTES)
      void this.stop(`The recording stopped after ${counted(this.images.length, "image", "images")}, which is as much as fits.`);
  }

  private async stop(notice: string): Promise<void> {
    this.is_on = false;
    this.show();
    const images = this.images;
    this.images = [];
    this.notify(notice);
    try {
      const buffers = await Promise.all(images.map(async (image) => (await image).arrayBuffer()));
      const entries = buffers.map((buffer, i) => ({
        name: `image-${String(i + 1).padStart(4, "0")}.png`,
        bytes: new Uint8Array(buffer),
      }));
      download(zip(entries), `${this.stem()}-images.zip`);
    } catch (error) {
      this.notify(`The images were not saved: ${(error as Error).message}`);
    }
  }

  private show(): void {
    this.button.dataset["on"] = String(this.is_on);
    setText(this.button, this.is_on ? `Stop recording (${this.images.length})` : "Record");
  }
}
