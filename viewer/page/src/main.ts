// SPDX-License-Identifier: BSD-3-Clause
// Connects the parts: the stream fills the model and the scene; panels show the model and send commands.
import { ColorManagement } from "three";
import { Model } from "./model";
import { Banners } from "./panels/banners";
import { Chart } from "./panels/chart";
import { Commands } from "./panels/commands";
import { Covariances } from "./panels/covariances";
import { DiagnosisPanel } from "./panels/diagnosis";
import { Display } from "./panels/display";
import { byId, setText } from "./panels/dom";
import { ElementPanel } from "./panels/element";
import { Files } from "./panels/files";
import { makeFoldable } from "./panels/fold";
import { Guess } from "./panels/guess";
import { Iterations } from "./panels/iterations";
import { Log } from "./panels/log";
import { PatternDialog } from "./panels/pattern";
import { PictureTools } from "./panels/picture_tools";
import { RunBar } from "./panels/run_bar";
import { KEYS_WITH_FOCUS, shortcutGroups, withoutServer } from "./panels/shortcut_table";
import { Shortcuts } from "./panels/shortcuts";
import { Tabs } from "./panels/tabs";
import { TimeLinePanel } from "./panels/time_line_panel";
import { TopBar } from "./panels/top_bar";
import { TruthErrors } from "./panels/truth_errors";
import { Connection } from "./protocol/connection";
import type { Frame, Message } from "./protocol/messages";
import { savedMessages } from "./protocol/saved_stream";
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
  const display = view && new Display(view);
  const chart = new Chart(model);
  const truth_errors = new TruthErrors();
  const time_line = view && new TimeLinePanel(model, view, chart, truth_errors);
  new TopBar(model);
  new Tabs();
  makeFoldable("chart");
  window.boxplus = { model, view, time_line };
  const show = (message: Message) => receive(message, { model, view, time_line, truth_errors });
  const shortcuts = shortcutGroups(tools, time_line);
  const saved = byId("saved-stream").textContent!;
  if (saved === "") {
    new Shortcuts(shortcuts, KEYS_WITH_FOCUS);
    serve(model, banners, view, display, show);
  } else {
    document.body.classList.add("saved");
    new Shortcuts(withoutServer(shortcuts), KEYS_WITH_FOCUS);
    savedMessages(saved).forEach(show);
  }
}

/** Adds the parts that need a server, and shows what it sends. */
function serve(
  model: Model, banners: Banners, view: SceneView | null, display: Display | null, show: (message: Message) => void,
): void {
  const connection = new Connection({
    onMessage: (message) => {
      show(message);
      if (message.kind === "structure") {
        element?.setStructure(message.structure);
        diagnosis?.setStructure(message.structure.structure);
      }
      if (message.kind === "frame") element?.setFrame();
      if (message.kind === "diagnosis") diagnosis?.show(message.diagnosis);
    },
    onConnection: (state) => model.setConnection(state),
  });
  const commands = new Commands(banners);
  const element = view && new ElementPanel(model, connection, commands, view);
  const diagnosis = element && new DiagnosisPanel(model, connection, commands, element);
  const values = new SettingValues();
  new Files(model, connection, commands, banners, display?.open_truth ?? null);
  new RunBar(model, connection, values, commands);
  new SettingsForm(model, values);
  new Guess(model, connection, commands);
  if (display) {
    new Covariances(display.compute, model, connection, commands);
    new PatternDialog(display.show_pattern, model, connection, commands);
  }
  new Iterations(model);
  new Log(model);
  void connection.run();
}

interface Receivers {
  model: Model;
  view: SceneView | null;
  time_line: TimeLinePanel | null;
  truth_errors: TruthErrors;
}

function receive(message: Message, { model, view, time_line, truth_errors }: Receivers): void {
  if (message.kind === "state") model.apply(message.state);
  if (message.kind === "form") model.setForm(message.form);
  if (message.kind === "structure") {
    view?.setStructure(message.structure);
    time_line?.setStructure(message.structure);
    truth_errors.setTruth(null);
    setText(byId("hint"), hint(message.structure.dimension));
  }
  if (message.kind === "truth") {
    view?.setTruth(message.truth);
    truth_errors.setTruth(message.truth);
  }
  if (message.kind === "frame") {
    if (time_line) time_line.add(message.frame);
    else truth_errors.show(message.frame, false);
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
