// SPDX-License-Identifier: BSD-3-Clause
// Connects the parts: the stream fills the model and the scene; panels show the model and send commands.
import { ColorManagement } from "three";
import { Model } from "./model";
import { Banners } from "./panels/banners";
import { Chart } from "./panels/chart";
import { Commands } from "./panels/commands";
import { Display } from "./panels/display";
import { byId, setText } from "./panels/dom";
import { ElementPanel } from "./panels/element";
import { Files } from "./panels/files";
import { Guess } from "./panels/guess";
import { Iterations } from "./panels/iterations";
import { Log } from "./panels/log";
import { PictureTools } from "./panels/picture_tools";
import { RunBar } from "./panels/run_bar";
import { KEYS_WITH_FOCUS, shortcutGroups } from "./panels/shortcut_table";
import { Shortcuts } from "./panels/shortcuts";
import { Tabs } from "./panels/tabs";
import { TimeLinePanel } from "./panels/time_line_panel";
import { TopBar } from "./panels/top_bar";
import { Connection } from "./protocol/connection";
import type { Frame, Message } from "./protocol/messages";
import { SceneView } from "./scene/scene_view";
import { SettingValues } from "./settings/setting_values";
import { SettingsForm } from "./settings/settings_form";
import { followSystemTheme } from "./theme";

declare global {
  interface Window {
    /** For tests and the console. */
    boxplus: { model: Model; view: SceneView | null; time_line: TimeLinePanel | null };
  }
}

function main(): void {
  ColorManagement.enabled = false;
  followSystemTheme();
  const model = new Model();
  const banners = new Banners(model);
  const view = createView(banners);
  const tools = view && new PictureTools(view, model, banners);
  if (view) new Display(view);
  const chart = new Chart(model);
  const time_line = view && new TimeLinePanel(model, view, chart);
  const connection = new Connection({
    onMessage: (message) => receive(message, model, view, time_line, element),
    onConnection: (state) => model.setConnection(state),
  });
  const commands = new Commands(banners);
  const element = view && new ElementPanel(model, connection, commands, view);
  const values = new SettingValues();
  new TopBar(model);
  new Files(model, connection, commands, banners);
  new RunBar(model, connection, values, commands);
  new SettingsForm(model, values);
  new Guess(model, connection, commands);
  new Iterations(model);
  new Log(model);
  new Tabs();
  new Shortcuts(shortcutGroups(tools, time_line), KEYS_WITH_FOCUS);
  window.boxplus = { model, view, time_line };
  void connection.run();
}

function receive(
  message: Message, model: Model, view: SceneView | null, time_line: TimeLinePanel | null, element: ElementPanel | null,
): void {
  if (message.kind === "state") model.apply(message.state);
  if (message.kind === "form") model.setForm(message.form);
  if (message.kind === "structure") {
    view?.setStructure(message.structure);
    time_line?.setStructure(message.structure);
    element?.setStructure(message.structure);
    setText(byId("hint"), hint(message.structure.dimension));
  }
  if (message.kind === "frame") {
    time_line?.add(message.frame);
    element?.setFrame();
    if (isInitial(message.frame, model) && view?.knowsInitial === false) view.setInitial(message.frame);
  }
}

/** True if the estimates are those of the file. */
function isInitial({ iteration, chi2 }: Frame, { state }: Model): boolean {
  return iteration === 0 && chi2 === state?.chi2_initial;
}

/** Without WebGL 2, the panels work and the picture is missing. */
function createView(banners: Banners): SceneView | null {
  try {
    return new SceneView(byId<HTMLCanvasElement>("scene"));
  } catch (error) {
    console.warn(error);
    byId("scene").hidden = true;
    banners.showCommandError("This browser has no WebGL 2, so there is no picture of the graph.");
    return null;
  }
}

function hint(dimension: number): string {
  return dimension === 2 ? "Drag: move · wheel: zoom" : "Drag: turn · right drag: move · wheel: zoom";
}

main();
