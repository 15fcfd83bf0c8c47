// SPDX-License-Identifier: BSD-3-Clause
// The tools in the corner of the picture: images, cameras, and the view of the whole graph.
import { askForFile, download, stem } from "../download";
import type { Model } from "../model";
import { cameraFromText, cameraToText } from "../scene/camera_file";
import type { SceneView } from "../scene/scene_view";
import type { Banners } from "./banners";
import { byId } from "./dom";
import { Menu } from "./menu";
import { Recorder } from "./recorder";

/** A camera has some hundred bytes. */
const MOST_CAMERA_BYTES = 10_000;

const ZOOM_FACTOR = 1.25;

export class PictureTools {
  constructor(private readonly view: SceneView, private readonly model: Model, private readonly banners: Banners) {
    byId("fit").addEventListener("click", () => view.fit());
    byId("from-above").addEventListener("click", () => view.lookFromAbove());
    byId("zoom-in").addEventListener("click", () => view.zoom(ZOOM_FACTOR));
    byId("zoom-out").addEventListener("click", () => view.zoom(1 / ZOOM_FACTOR));
    new Recorder(view, () => this.stem(), (text) => banners.showNotice(text));
    const camera_input = byId<HTMLInputElement>("camera-input");
    new Menu(byId("picture"), () => [
      { id: "save-picture", text: "Save picture (PNG)", choose: () => this.savePicture() },
      { id: "save-camera", text: "Save camera", choose: () => this.saveCamera() },
      {
        id: "load-camera", text: "Load camera…",
        choose: () => askForFile(camera_input, (file) => void this.loadCamera(file)),
      },
    ]);
    model.observe(() => {
      const file = model.state?.file;
      byId("tools").hidden = !file;
      byId("from-above").hidden = file?.dimension === 2;
    });
  }

  private stem(): string {
    return stem(this.model.state?.file?.name ?? "");
  }

  savePicture(): void {
    this.view.png().then(
      (png) => download(png, `${this.stem()}.png`),
      (error: Error) => this.banners.showCommandError(`The picture was not saved: ${error.message}`),
    );
  }

  private saveCamera(): void {
    const { camera } = this.view;
    if (camera) download(new Blob([cameraToText(camera)], { type: "application/json" }), `${this.stem()}-camera.json`);
  }

  private async loadCamera(file: File): Promise<void> {
    this.banners.showCommandError("");
    try {
      if (file.size > MOST_CAMERA_BYTES) throw new Error("the file is too large");
      this.view.setCamera(cameraFromText(await file.text()));
    } catch (error) {
      this.banners.showCommandError(`${file.name} was not loaded: ${(error as Error).message}.`);
    }
  }
}
