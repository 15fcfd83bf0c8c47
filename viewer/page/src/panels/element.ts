// SPDX-License-Identifier: BSD-3-Clause
// The selected vertex or edge: what the server knows of it. It is asked again after each command.
import type { Model } from "../model";
import type { Connection } from "../protocol/connection";
import { type Finding, markText } from "../protocol/diagnosis";
import { drawnPairs, drawnVertices, type ElementFacts, type ElementName, lastingName } from "../protocol/element";
import type { EditKind, Structure } from "../protocol/messages";
import type { SceneView } from "../scene/scene_view";
import type { Commands } from "./commands";
import { byId, replaceAround, setTextOrHide } from "./dom";
import { editButtons, editState } from "./element_edits";
import { factsOf } from "./element_facts";

/** A click moves the mouse at most this far. */
const CLICK_PIXELS = 4;

interface Group {
  vertices: number[];
  lines: number[];
}

const NOTHING: Group = { vertices: [], lines: [] };

export class ElementPanel {
  private chosen: ElementName | null = null;
  private facts: ElementFacts | null = null;
  /** The buttons for an element in a state. */
  private edits: { state: string; place: HTMLElement } | null = null;
  /** The numbers of vertices and lines that are marked without facts. */
  private group: Group = NOTHING;
  private graph = 0;
  private structure = 0;
  /** True if the server is to be asked as soon as it is not busy. */
  private is_due = false;
  private goes_there = false;
  private requests = 0;
  private answer = Promise.resolve();

  constructor(
    private readonly model: Model, private readonly connection: Connection, private readonly commands: Commands,
    private readonly view: SceneView,
  ) {
    this.listenToClicks(byId("scene"));
    byId("find").addEventListener("submit", (event) => {
      event.preventDefault();
      const number = byId<HTMLInputElement>("element-id").value.trim();
      if (number !== "") this.choose({ key: "id", number }, true);
    });
    byId("unmark").addEventListener("click", () => this.clear());
    model.observe(() => {
      this.enableEdits();
      this.askIfDue();
    });
  }

  /** An edit leaves most elements, whose numbers may change; another file leaves none. */
  setStructure({ graph, structure }: Structure): void {
    if (graph !== this.graph) this.clear();
    this.graph = graph;
    if (structure === this.structure) this.mark();
    else this.group = NOTHING;
    this.structure = structure;
  }

  /** A new frame means that the values of the element have changed. */
  setFrame(): void {
    if (!this.chosen) return;
    this.is_due = true;
    this.askIfDue();
  }

  private listenToClicks(canvas: HTMLElement): void {
    let from: [number, number] = [0, 0];
    canvas.addEventListener("pointerdown", ({ clientX, clientY }) => (from = [clientX, clientY]));
    canvas.addEventListener("click", ({ clientX, clientY }) => {
      if (Math.hypot(clientX - from[0], clientY - from[1]) > CLICK_PIXELS) return;
      const { left, top } = canvas.getBoundingClientRect();
      const picked = this.view.pick(clientX - left, clientY - top);
      if (picked) this.choose({ key: picked.key, number: String(picked.number) }, false);
      else this.clear();
    });
  }

  /** Marks the vertices and edges of a finding, of which no facts are shown. */
  markGroup(finding: Finding): void {
    this.clear();
    setTextOrHide(byId("element-note"), markText(finding));
    this.group = { vertices: finding.vertices.marked, lines: finding.edges.lines };
    this.mark();
    this.view.goTo([...this.group.vertices, ...this.view.endsOf(this.group.lines)]);
  }

  /** Shows the element, and moves the camera if it is not in the picture and `goes_there`. */
  choose(name: ElementName, goes_there: boolean): void {
    this.chosen = name;
    this.group = NOTHING;
    this.goes_there = goes_there;
    this.is_due = true;
    byId("tab-element").click();
    if (this.model.isBusy) setTextOrHide(byId("element-note"), "boxplus is busy. It answers after the run.");
    this.askIfDue();
  }

  private clear(): void {
    this.chosen = null;
    this.group = NOTHING;
    this.is_due = false;
    ++this.requests;
    this.show(null, "Click a vertex or an edge, or type the id of a vertex.");
  }

  private askIfDue(): void {
    if (!this.chosen || !this.is_due || !this.model.hasGraph || this.model.isBusy) return;
    this.is_due = false;
    this.answer = this.ask(this.chosen);
  }

  /** Only the answer to the last request is shown. */
  private async ask(name: ElementName): Promise<void> {
    const request = ++this.requests;
    try {
      const facts = await this.connection.element(this.structure, name);
      if (request !== this.requests) return;
      this.chosen = lastingName(facts);
      this.show(facts, "");
      if (this.goes_there) this.view.goTo(drawnVertices(facts));
      this.goes_there = false;
    } catch (error) {
      if (request !== this.requests) return;
      if (this.model.isBusy) this.is_due = true;
      else this.show(null, `No such element: ${(error as Error).message}.`);
    }
  }

  private show(facts: ElementFacts | null, note: string): void {
    this.facts = facts;
    setTextOrHide(byId("element-note"), note);
    const parts = facts ? factsOf(facts, (name) => this.choose(name, true)) : [];
    const edits = facts && this.editsOf(facts);
    const focused = document.activeElement?.closest("#element-edits") ? document.activeElement.id : "";
    if (edits) {
      const [title, ...others] = parts;
      replaceAround(byId("element-facts"), [title!], edits, others);
    } else {
      byId("element-facts").replaceChildren();
    }
    this.enableEdits();
    const next = document.getElementById(focused) ?? document.querySelector<HTMLElement>("#element-edits button");
    if (focused !== "" && document.activeElement?.id !== focused) (next ?? byId("element-id")).focus();
    this.mark();
  }

  /** Stay as they are as long as they fit, because the user may be typing or pressing one. */
  private editsOf(facts: ElementFacts): HTMLElement {
    const state = editState(facts);
    if (this.edits?.state !== state)
      this.edits = { state, place: editButtons(facts, (kind, factor) => void this.edit(facts, kind, factor)) };
    return this.edits.place;
  }

  private async edit(facts: ElementFacts, kind: EditKind, factor?: string): Promise<void> {
    const { key, number } = lastingName(facts);
    await this.commands.run("The edit was not made", async () => {
      // An edit would make the structure of a request outdated.
      await this.answer;
      // What is removed is not asked for again.
      if (kind === "remove") this.chosen = null;
      try {
        await this.connection.send({
          type: "edit", edit: kind, structure: String(this.structure), [key]: number, ...(factor === undefined ? {} : { factor }),
        });
      } catch (error) {
        this.chosen = lastingName(facts);
        throw error;
      }
      if (kind === "remove") this.clear();
    });
  }

  private enableEdits(): void {
    const enabled = this.model.hasGraph && !this.model.isBusy;
    for (const button of byId("element-facts").querySelectorAll<HTMLButtonElement>("#element-edits button"))
      button.disabled = !enabled;
  }

  private mark(): void {
    const { vertices, lines } = this.group;
    byId("unmark").hidden = !this.facts && vertices.length + lines.length === 0;
    if (this.facts) this.view.select(drawnVertices(this.facts), drawnPairs(this.facts));
    else this.view.select(vertices, this.view.endsOf(lines));
  }
}
