// SPDX-License-Identifier: BSD-3-Clause
// The plot of chi2 by iteration. Its scale is logarithmic if chi2 falls by a large factor.
import uPlot from "uplot";
import { general } from "../format";
import { chi2Sequence, type Model, type Run } from "../model";
import { currentTheme, onThemeChange } from "../theme";
import { byId, create, setText } from "./dom";

/** The factor from the least to the largest chi2 above which the scale is logarithmic. */
const LARGE_FACTOR = 10;
/** In pixels of the style sheet. */
const MARK_RADIUS = 4.5, LEAST_AXIS_WIDTH = 58, LABEL_GAP = 12, DIGIT_WIDTH = 6.8;
const MOST_DIGITS = 13;

export class Chart {
  private readonly place = byId("chart");
  private readonly nothing = create("p", { className: "nothing" }, "chi2 of each iteration appears here");
  private plot: uPlot | null = null;
  private is_logarithmic = false;
  private shown_rows: unknown = null;
  private marked: number | null = null;
  /** Called with the place in chi2Sequence() that the user clicked. */
  on_choose: (place: number) => void = () => {};

  constructor(private readonly model: Model) {
    this.place.append(this.nothing);
    model.observe(() => this.update());
    onThemeChange(() => this.rebuild());
    this.place.addEventListener("click", () => {
      const place = this.plot?.cursor.idx;
      if (typeof place === "number") this.on_choose(place);
    });
    new ResizeObserver(() => {
      // A folded plot keeps its size.
      if (this.place.clientHeight > 0) this.plot?.setSize(this.size());
    }).observe(this.place);
  }

  /** Marks a place in chi2Sequence(), or none. */
  mark(place: number | null): void {
    if (place === this.marked) return;
    this.marked = place;
    this.plot?.redraw(false, false);
  }

  private update(): void {
    const { run } = this.model;
    setText(byId("fold-chart"), title(run));
    if ((run?.rows ?? null) === this.shown_rows) return;
    this.shown_rows = run?.rows ?? null;
    const { values } = this.data();
    const is_logarithmic = Math.min(...values) > 0 && Math.max(...values) > LARGE_FACTOR * Math.min(...values);
    if (!this.plot || is_logarithmic !== this.is_logarithmic || values.length === 0) {
      this.is_logarithmic = is_logarithmic;
      this.rebuild();
    } else {
      this.plot.setData(this.table());
    }
  }

  private rebuild(): void {
    this.plot?.destroy();
    this.plot = null;
    const is_empty = this.data().values.length === 0;
    this.nothing.hidden = !is_empty;
    if (!is_empty) this.plot = new uPlot(this.options(), this.table(), this.place);
  }

  private data() {
    const { run, state } = this.model;
    const sequence = run && run.rows.length > 0 ? chi2Sequence(run, state?.chi2_initial ?? null) : [];
    return { sequence, values: sequence.filter(Number.isFinite) };
  }

  private table(): uPlot.AlignedData {
    const { sequence } = this.data();
    return [sequence.map((_, i) => i), sequence.map((value) => (Number.isFinite(value) ? value : null))];
  }

  private drawMark(plot: uPlot): void {
    const value = this.marked === null ? null : plot.data[1]![this.marked];
    if (this.marked === null || value === undefined) return;
    const { ctx, bbox } = plot;
    const { mark } = currentTheme();
    const x = plot.valToPos(this.marked, "x", true);
    ctx.save();
    ctx.strokeStyle = ctx.fillStyle = mark;
    ctx.lineWidth = devicePixelRatio;
    ctx.beginPath();
    ctx.moveTo(x, bbox.top);
    ctx.lineTo(x, bbox.top + bbox.height);
    ctx.stroke();
    if (value !== null) {
      ctx.beginPath();
      ctx.arc(x, plot.valToPos(value, "y", true), MARK_RADIUS * devicePixelRatio, 0, 2 * Math.PI);
      ctx.fill();
    }
    ctx.restore();
  }

  private size() {
    return { width: Math.max(1, this.place.clientWidth - 10), height: Math.max(1, this.place.clientHeight) };
  }

  private options(): uPlot.Options {
    const theme = currentTheme();
    const font = "11px system-ui, sans-serif";
    const labeled: uPlot.Axis.Filter = (plot, splits) => (this.is_logarithmic ? roundValues(plot, splits) : splits);
    const points = { show: this.data().sequence.length < 60, size: 5, fill: theme.plot_line };
    const axis = { stroke: theme.plot_text, font, grid: { stroke: theme.plot_grid, width: 1 }, ticks: { show: false } };
    return {
      ...this.size(),
      legend: { show: false },
      hooks: { draw: [(plot) => this.drawMark(plot)] },
      cursor: { y: false, drag: { x: false, y: false } },
      padding: [10, 10, 0, 0],
      scales: {
        x: { time: false, range: (_, least, most) => [least, Math.max(most, least + 1)] },
        y: this.is_logarithmic ? { distr: 3 } : { range: (_, least, most) => linearRange(least, most) },
      },
      axes: [
        { ...axis, size: 24, gap: 2, incrs: [1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10000] },
        {
          ...axis,
          size: (_, values) => axisWidth(values),
          gap: 4,
          filter: labeled,
          grid: { ...axis.grid, filter: labeled },
          values: (_, splits, _axis, _space, increment) => labels(splits, increment),
        },
      ],
      series: [{}, { stroke: theme.plot_line, width: 1.5, points }],
    };
  }
}

/** Says where the plot begins if this is not at the estimates before the run. */
function title(run: Run | null): string {
  if (run && run.stages.length > 0) return `chi2 by stage: ${run.stages.join(", ")}, last run`;
  if (!run?.start) return "chi2 by iteration";
  return `chi2 from the initial guess (${run.start.name}: ${general(run.start.chi2, 4)}) on`;
}

function linearRange(least: number, most: number): [number, number] {
  const margin = 0.06 * (most - least) || 0.05 * Math.abs(most) || 1;
  return [least - margin, most + margin];
}

/** As much as the longest label needs. uPlot asks before there are labels, too. */
function axisWidth(values: (string | null)[] | null): number {
  const longest = Math.max(0, ...(values ?? []).map((value) => value?.length ?? 0));
  return Math.max(LEAST_AXIS_WIDTH, LABEL_GAP + DIGIT_WIDTH * longest);
}

/** The values, with as many digits as their differences need. */
function labels(splits: (number | null)[], increment: number): string[] {
  const most = Math.max(...splits.map((value) => Math.abs(value ?? 0)));
  const digits = increment > 0 && most > 0 ? Math.ceil(Math.log10(most / increment)) + 1 : 0;
  return splits.map((value) => (value === null ? "" : general(value, Math.min(MOST_DIGITS, Math.max(5, digits)))));
}

/** Of the values of a logarithmic axis, the powers of 10; also 2 and 5 times them if the axis is short. */
function roundValues(plot: uPlot, splits: number[]): (number | null)[] {
  const { min, max } = plot.scales["y"]!;
  const decades = Math.log10(max! / min!);
  const digits = decades <= 3 ? [1, 2, 5] : [1];
  const every = Math.ceil(decades / 6);
  return splits.map((value) => {
    const exponent = Math.floor(Math.log10(value) + 1e-9);
    return digits.includes(Math.round(value / 10 ** exponent)) && exponent % every === 0 ? value : null;
  });
}
