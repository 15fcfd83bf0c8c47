// SPDX-License-Identifier: BSD-3-Clause
// The table of iterations of the last run.
import { general, scientific } from "../format";
import type { Model, Run } from "../model";
import type { IterationRow } from "../protocol/messages";
import { byId, create, keepAtEnd } from "./dom";

interface Column {
  title: string;
  hint: string;
  text(row: IterationRow, run: Run): string;
  /** Absent: always shown. */
  isShown?(run: Run): boolean;
}

const COLUMNS: Column[] = [
  { title: "#", hint: "iteration", text: (row, { stages }) => stages[row.iteration - 1] ?? String(row.iteration - stages.length) },
  { title: "chi2", hint: "after the iteration", text: (row) => general(row.chi2, 7) },
  { title: "decrease", hint: "decrease of chi2", text: (row) => general(row.chi2_decrease, 3) },
  { title: "step", hint: "largest absolute entry of the step", text: (row) => scientific(row.step_max, 1) },
  {
    title: "λ", hint: "damping of the step", text: (row) => scientific(row.lambda, 1),
    isShown: (run) => run.rows.some((row) => row.lambda !== 0),
  },
  {
    title: "radius", hint: "radius of the trust region", text: (row) => scientific(row.radius, 1),
    isShown: (run) => run.rows.some((row) => row.radius !== 0 && row.radius !== null),
  },
  {
    title: "tries", hint: "number of evaluated steps", text: (row) => String(row.tries),
    isShown: (run) => run.rows.some((row) => row.tries > 1),
  },
  { title: "s", hint: "seconds since the start of the run", text: (row) => general(row.time_s, 3) },
];

export class Iterations {
  private readonly head = byId("iterations").querySelector("thead tr")!;
  private readonly body = byId<HTMLTableSectionElement>("rows");
  private shown: IterationRow[] = [];
  private columns: Column[] = [];

  constructor(private readonly model: Model) {
    model.observe(() => this.update());
    this.update();
  }

  private update(): void {
    const { run } = this.model;
    const rows = run?.rows ?? [];
    const columns = COLUMNS.filter((column) => !run || !column.isShown || column.isShown(run));
    if (columns.length !== this.columns.length || columns.some((column, i) => column !== this.columns[i])) {
      this.columns = columns;
      this.shown = [];
      const heads = columns.map(({ title, hint }) => create("th", { title: hint, scope: "col" }, title));
      this.head.replaceChildren(...heads);
    }
    keepAtEnd(byId("iterations"), () => this.updateRows(rows, run));
  }

  private updateRows(rows: IterationRow[], run: Run | null): void {
    let same = 0;
    while (same < rows.length && same < this.shown.length && rows[same] === this.shown[same]) ++same;
    while (this.body.rows.length > same) this.body.deleteRow(-1);
    for (const row of rows.slice(same)) {
      this.body.append(create("tr", {}, ...this.columns.map((column) => create("td", {}, column.text(row, run!)))));
    }
    this.shown = rows;
  }
}
