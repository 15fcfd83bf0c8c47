// SPDX-License-Identifier: BSD-3-Clause
// The display options over a reload. What is stored may be of another version of the page, so each value is checked.
import { asRecord, store, stored } from "../stored";
import { COLOR_MODES } from "./coloring";
import { type DisplayOptions, defaultOptions, type TypeStyle } from "./display_options";
import { EDGE_COLORINGS } from "./edge_levels";

export function storeOptions(options: DisplayOptions): void {
  // JSON knows no infinity: such a limit becomes null.
  store("display", options);
}

export function storedOptions(): DisplayOptions {
  const options = defaultOptions();
  const { styles, background, poses_as_axes, shows_initial, shows_truth, shows_uncertainty, shows_scans, color_mode, edge_coloring,
    limits } = asRecord(stored("display"));
  for (const [name, style] of Object.entries(asRecord(styles))) options.styles[name] = checkedStyle(asRecord(style));
  if (isColor(background)) options.background = background;
  options.poses_as_axes = poses_as_axes === true;
  options.shows_initial = shows_initial === true;
  options.shows_truth = shows_truth !== false;
  options.shows_uncertainty = shows_uncertainty !== false;
  options.shows_scans = shows_scans !== false;
  options.color_mode = COLOR_MODES.find((mode) => mode === color_mode) ?? "type";
  options.edge_coloring = EDGE_COLORINGS.find((coloring) => coloring === edge_coloring) ?? "role";
  const { least_track_length, most_error } = asRecord(limits);
  if (isSize(least_track_length)) options.limits.least_track_length = least_track_length;
  if (isSize(most_error)) options.limits.most_error = most_error;
  return options;
}

function checkedStyle({ shown, color, size }: Record<string, unknown>): TypeStyle {
  return {
    ...(typeof shown === "boolean" ? { shown } : {}),
    ...(isColor(color) ? { color } : {}),
    ...(isSize(size) ? { size } : {}),
  };
}

function isColor(value: unknown): value is string {
  return typeof value === "string" && /^#[0-9a-f]{6}$/i.test(value);
}

function isSize(value: unknown): value is number {
  return typeof value === "number" && Number.isFinite(value) && value >= 0;
}
