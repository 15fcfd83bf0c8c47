// SPDX-License-Identifier: BSD-3-Clause
// The colors of the scene and of the plot: the variables of style.css, which has them for dark and for light themes.
import { Color } from "three";
import type { EdgeGroup, VertexGroup } from "./protocol/messages";
import { type Coloring, MOST_CLASSES } from "./scene/coloring";
import { store, stored } from "./stored";
import { LEVELS } from "./scene/edge_levels";

export interface Theme {
  background: Color;
  pose: Color;
  camera: Color;
  landmark: Color;
  fixed: Color;
  /** The estimates of the file, under the current ones. */
  before: Color;
  /** The true estimates, under the current ones. */
  truth: Color;
  uncertainty: Color;
  scan: Color;
  odometry: Color;
  loop_closure: Color;
  observation: Color;
  other: Color;
  /** Colors from low to high values. */
  ramp: [Color, Color, Color];
  /** Colors of classes without an order; the last one is for the rest. */
  distinct: Color[];
  /** Of edges that are colored by a value; the last one is that of outliers. */
  levels: Color[];
  selection: Color;
  plot_line: string;
  plot_grid: string;
  plot_text: string;
  /** The mark in the plot. */
  mark: string;
}

export function currentTheme(): Theme {
  const style = getComputedStyle(document.documentElement);
  const text = (name: string) => style.getPropertyValue(name).trim();
  const color = (name: string) => new Color(text(name));
  return {
    background: color("--scene"),
    pose: color("--pose"),
    camera: color("--camera"),
    landmark: color("--landmark"),
    fixed: color("--fixed"),
    before: color("--before"),
    truth: color("--truth"),
    uncertainty: color("--uncertainty"),
    scan: color("--scan"),
    odometry: color("--odometry"),
    loop_closure: color("--loop-closure"),
    observation: color("--observation"),
    other: color("--other-edge"),
    ramp: [color("--ramp-low"), color("--ramp-middle"), color("--ramp-high")],
    distinct: Array.from({ length: MOST_CLASSES }, (_, i) => color(`--class-${i + 1}`)),
    levels: Array.from({ length: LEVELS }, (_, level) => color(`--level-${level}`)),
    selection: color("--selection"),
    plot_line: text("--accent"),
    plot_grid: text("--line"),
    plot_text: text("--dim"),
    mark: text("--mark"),
  };
}

/** The color of a type, unless the user chose another one. */
export function typeColor(theme: Theme, group: VertexGroup | EdgeGroup): Color {
  if (group.color) return new Color(group.color);
  if ("role" in group) {
    const { odometry, loop_closure, observation, other } = theme;
    return { odometry, "loop closure": loop_closure, observation, other }[group.role];
  }
  if (group.shape === "point") return theme.landmark;
  return group.shape === "pose" ? theme.pose : theme.camera;
}

/** The color of each class. */
export function classColors({ ramp, distinct }: Theme, { scale, has_rest, classes }: Coloring): Color[] {
  if (scale === "distinct") return distinct.slice(0, classes.length);
  const [low, middle, high] = ramp;
  const last = classes.length - (has_rest ? 2 : 1);
  return classes.map((_, i) => {
    if (i > last) return distinct[MOST_CLASSES - 1]!;
    const place = last > 0 ? (2 * i) / last : 0;
    return place < 1 ? low.clone().lerp(middle, place) : middle.clone().lerp(high, place - 1);
  });
}

const dark_system = matchMedia("(prefers-color-scheme: dark)");
const observers: (() => void)[] = [];

export function onThemeChange(observer: () => void): void {
  observers.push(observer);
}

/** The page has the theme of the system until the user chooses the other one. */
export function followSystemTheme(): void {
  const chosen = stored("theme");
  setTheme(chosen === "dark" || chosen === "light" ? chosen : systemTheme());
  dark_system.addEventListener("change", () => {
    store("theme", null);
    setTheme(systemTheme());
  });
}

export function toggleTheme(): void {
  const theme = document.documentElement.dataset["theme"] === "dark" ? "light" : "dark";
  store("theme", theme === systemTheme() ? null : theme);
  setTheme(theme);
}

function systemTheme(): "dark" | "light" {
  return dark_system.matches ? "dark" : "light";
}

function setTheme(theme: "dark" | "light"): void {
  document.documentElement.dataset["theme"] = theme;
  for (const observer of observers) observer();
}
