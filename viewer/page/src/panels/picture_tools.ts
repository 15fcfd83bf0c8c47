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

export class PictureTools {
  constructor(private readonly view: SceneView, private readonly model: Model, private readonly banners: Banners) {
    byId("fit").addEventListener("click", () => view.fit());
    byId("scene").addEventListener("keydown", ({ key, ctrlKey, metaKey, altKey }) => {
      if (["f", "F", "Home"].includes(key) && !ctrlKey && !metaKey && !altKey) view.fit();
    });
    new Recorder(view, () => this.stem(), (text) => banners.showNotice(text));
    const camera_input = byId<HTMLInputElement>("camera-input");
    new Menu(byId("picture"), () => [
      { id: "save-picture", text: "Save picture (PNG)", choose: () => void this.savePicture() },
      { id: "save-camera", text: "Save camera", choose: () => this.saveCamera() },
      {
        id: "load-camera", text: "Load camera…",
        choose: () => askForFile(camera_input, (file) => void this.loadCamera(file)),
      },
    ]);
    model.observe(() => (byId("tools").hidden = !model.state?.file));
  }

  private stem(): string {
    return stem(this.model.state?.file?.name ?? "");
  }

  private async savePicture(): Promise<void> {
    try {
      download(await this.view.png(), `${this.stem()}.png`);
    } catch (error) {
      this.banners.showCommandError(`The picture was not saved: ${(error as Error).message}`);
    }
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
