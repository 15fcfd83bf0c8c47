// SPDX-License-Identifier: BSD-3-Clause
// Connects the parts: the stream fills the model and the scene; panels show the model and send commands.
import { ColorManagement } from "three";
import { Model } from "./model";
import { Banners } from "./panels/banners";
import { Chart } from "./panels/chart";
import { Display } from "./panels/display";
import { byId, setText, setTextOrHide } from "./panels/dom";
import { Iterations } from "./panels/iterations";
import { Log } from "./panels/log";
import { RunBar } from "./panels/run_bar";
import { Tabs } from "./panels/tabs";
import { TopBar } from "./panels/top_bar";
import { Connection } from "./protocol/connection";
import type { Message } from "./protocol/messages";
import { SceneView } from "./scene/scene_view";

declare global {
  interface Window {
    /** For tests and the console. */
    boxplus: { model: Model; view: SceneView | null };
  }
}

function main(): void {
  ColorManagement.enabled = false;
  const model = new Model();
  const view = createView();
  const connection = new Connection({
    onMessage: (message) => receive(message, model, view),
    onConnection: (state) => model.setConnection(state),
  });
  const banners = new Banners(model);
  new TopBar(model);
  new RunBar(model, connection, (text) => banners.showCommandError(text));
  new Chart(model);
  new Iterations(model);
  new Log(model);
  new Tabs();
  window.boxplus = { model, view };
  void connection.run();
}

function receive(message: Message, model: Model, view: SceneView | null): void {
  if (message.kind === "state") model.apply(message.state);
  if (message.kind === "structure") {
    view?.setStructure(message.structure);
    setText(byId("hint"), hint(message.structure.dimension));
  }
  if (message.kind === "frame") view?.setFrame(message.frame);
}

/** Without WebGL 2, the panels work and the picture is missing. */
function createView(): SceneView | null {
  try {
    const view = new SceneView(byId<HTMLCanvasElement>("scene"));
    new Display(view);
    byId("fit").addEventListener("click", () => view.fit());
    byId("scene").addEventListener("keydown", (event) => {
      if (event.key === "f" || event.key === "F") view.fit();
    });
    return view;
  } catch (error) {
    console.warn(error);
    byId("scene").hidden = true;
    byId("fit").hidden = true;
    setTextOrHide(byId("command-error"), "This browser has no WebGL 2, so there is no picture of the graph.");
    return null;
  }
}

function hint(dimension: number): string {
  return dimension === 2 ? "Drag: move · wheel: zoom" : "Drag: turn · right drag: move · wheel: zoom";
}

main();
