// SPDX-License-Identifier: BSD-3-Clause
// What the page knows: the server's newest state, with the rows and log lines that came in parts. The page never invents
// any of it.
import type { ConnectionState } from "./protocol/connection";
import type { Form, IterationRow, LogLine, MaybeNumber, RunMessage, StateMessage } from "./protocol/messages";

/** Older lines of the log leave the page. */
const MOST_LOG_LINES = 5000;

export interface Run {
  /** Differs from that of the run before. */
  id: number;
  /** The server's number of the table; a run gets another one when it ends or begins anew. */
  number: number;
  rows: IterationRow[];
  status: string;
  headline: string;
  summary: string;
  stages: string[];
  start: { name: string; chi2: MaybeNumber } | null;
  chi2_per_degree: MaybeNumber;
  degrees_of_freedom: number;
  false_edges: number;
}

/** chi2 per degree of freedom above which the Ω and the errors do not fit together, with enough degrees of freedom. */
const MOST_CHI2_PER_DEGREE = 4, LEAST_DEGREES = 10;

/** True if chi2 is far above what the noise explains. Then the result may be wrong, although it is a minimum. */
export function fitsPoorly({ chi2_per_degree, degrees_of_freedom }: Run): boolean {
  return degrees_of_freedom >= LEAST_DEGREES && chi2_per_degree !== null && chi2_per_degree > MOST_CHI2_PER_DEGREE;
}

export class Model {
  connection: ConnectionState = { connected: false, problem: "" };
  state: StateMessage | null = null;
  version = "";
  /** What can be chosen for the graph. */
  form: Form | null = null;
  run: Run | null = null;
  log: LogLine[] = [];
  /** The number of the first line in `log`. */
  log_first = 0;

  /** The number of runs that the page saw. */
  private runs = 0;
  private readonly observers: (() => void)[] = [];

  /** Calls the observer after each change. */
  observe(observer: () => void): void {
    this.observers.push(observer);
  }

  setConnection(connection: ConnectionState): void {
    this.connection = connection;
    this.notify();
  }

  apply(state: StateMessage): void {
    this.state = state;
    if (state.version !== undefined) this.version = state.version;
    if (state.run && !(this.run && isSameRun(this.run, state.run))) ++this.runs;
    this.run = state.run && mergedRun(this.run, state.run, this.runs);
    this.appendLog(state.log.first, state.log.lines);
    this.notify();
  }

  setForm(form: Form): void {
    this.form = form;
    this.notify();
  }

  /** True if commands for a graph make sense. */
  get hasGraph(): boolean {
    return this.connection.connected && this.state !== null && this.state.file !== null;
  }

  get isBusy(): boolean {
    return this.state?.busy ?? false;
  }

  private appendLog(first: number, lines: LogLine[]): void {
    const kept = first - this.log_first;
    if (kept < 0 || kept > this.log.length) {
      this.log = [];
      this.log_first = first;
    } else {
      this.log.length = kept;
    }
    for (const line of lines) this.log.push(line);
    if (this.log.length > MOST_LOG_LINES) {
      const surplus = this.log.length - MOST_LOG_LINES;
      this.log.splice(0, surplus);
      this.log_first += surplus;
    }
  }

  private notify(): void {
    for (const observer of this.observers) observer();
  }
}

function mergedRun(known: Run | null, message: RunMessage, id: number): Run {
  const kept = known?.number === message.number ? known.rows.slice(0, message.first_row) : [];
  const { number, status, headline, summary, stages = [], start = null, chi2_per_degree = null, degrees_of_freedom = 0, false_edges = 0 } = message;
  const facts = { stages, start, chi2_per_degree, degrees_of_freedom, false_edges };
  return { id, number, status, headline, summary, rows: kept.concat(message.rows), ...facts };
}

/** The number grows by one when a run ends, begins anew from another start, and when the next run begins. */
function isSameRun(known: Run, { number }: RunMessage): boolean {
  return number === known.number || (known.status === "running" && number === known.number + 1);
}

/** The place of an iteration in chi2Sequence(). During a run, the rows of an attempt that it gave up may come before. */
export function placeOf(iteration: number, rows: IterationRow[]): number {
  let place = rows.length;
  while (place > 0 && rows[place - 1]!.iteration !== iteration) --place;
  return place;
}

/** The iteration at a place in chi2Sequence(). */
export function iterationAt(place: number, rows: IterationRow[]): number {
  return rows[place - 1]?.iteration ?? 0;
}

/** chi2 before the first row and after each row; NaN if it is not finite. */
export function chi2Sequence(run: Run, chi2_initial: number | null): number[] {
  const first = run.rows[0];
  const before = first ? (first.chi2 ?? NaN) + (first.chi2_decrease ?? NaN) : (chi2_initial ?? NaN);
  return [before, ...run.rows.map((row) => row.chi2 ?? NaN)];
}
