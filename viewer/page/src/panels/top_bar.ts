// SPDX-License-Identifier: BSD-3-Clause
// The bar at the top: file, counts, chi2, and what the server does.
import { counted, general } from "../format";
import { fitsPoorly, type Model, type Run } from "../model";
import { toggleTheme } from "../theme";
import { byId, setText } from "./dom";

/** The number of digits of chi2, as in the reports of the command. */
const CHI2_DIGITS = 9;

export class TopBar {
  constructor(private readonly model: Model) {
    model.observe(() => this.update());
    byId("toggle-theme").addEventListener("click", toggleTheme);
    byId("toggle-panel").addEventListener("click", () => {
      const is_hidden = document.body.classList.toggle("no-panel");
      byId("toggle-panel").setAttribute("aria-expanded", String(!is_hidden));
    });
  }

  private update(): void {
    const { state } = this.model;
    const file = state?.file;
    document.title = file ? `${file.name} – boxplus` : "boxplus";
    setText(byId("file"), file?.name ?? "boxplus");
    setText(byId("counts"), file
      ? `${counted(file.vertices, "vertex", "vertices")} · ${counted(file.edges, "edge", "edges")} · ${file.dimension}-D`
      : "");
    byId("chi2-figure").hidden = !file;
    setText(byId("chi2"), general(state?.chi2, CHI2_DIGITS));
    this.updateStatus();
  }

  private updateStatus(): void {
    const { status, tone, text } = this.status();
    const element = byId("status");
    element.dataset["status"] = status;
    element.dataset["tone"] = tone;
    setText(element, text);
  }

  private status(): { status: string; tone: string; text: string } {
    const { connection, state, run } = this.model;
    if (!connection.connected) {
      const status = connection.problem ? "lost" : "connecting";
      return { status, tone: connection.problem ? "bad" : "", text: connection.problem ? "not connected" : status };
    }
    if (!state) return { status: "connecting", tone: "", text: "connecting" };
    if (state.busy) return { status: "busy", tone: "busy", text: activity(state.activity, run) };
    if (state.error && !state.file) return { status: "error", tone: "bad", text: "file not read" };
    if (!run) return { status: "ready", tone: "", text: "ready" };
    if (run.status === "converged" && fitsPoorly(run)) return { status: run.status, tone: "warn", text: "converged, poor fit" };
    const tones: Record<string, string> = { converged: "good", failed: "bad" };
    return { status: run.status, tone: tones[run.status] ?? "", text: run.status };
  }
}

function activity(name: string, run: Run | null): string {
  const rows = run?.rows.length ?? 0, stages = run?.stages.length ?? 0;
  if (name !== "optimizing" || rows === 0) return name;
  return rows > stages ? `${name}, iteration ${rows - stages}` : "looking for false edges";
}
