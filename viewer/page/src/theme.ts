// SPDX-License-Identifier: BSD-3-Clause
// The colors of the scene and of the plot: the variables of style.css, which has them for dark and for light themes.
import { Color } from "three";
import type { EdgeGroup, VertexGroup } from "./protocol/messages";

export interface Theme {
  background: Color;
  pose: Color;
  camera: Color;
  landmark: Color;
  fixed: Color;
  odometry: Color;
  loop_closure: Color;
  observation: Color;
  other: Color;
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
    odometry: color("--odometry"),
    loop_closure: color("--loop-closure"),
    observation: color("--observation"),
    other: color("--other-edge"),
    plot_line: text("--accent"),
    plot_grid: text("--line"),
    plot_text: text("--dim"),
    mark: text("--mark"),
  };
}

/** The color of a type, unless the user chose another one. */
export function typeColor(theme: Theme, group: VertexGroup | EdgeGroup): Color {
  if ("role" in group) {
    const { odometry, loop_closure, observation, other } = theme;
    return { odometry, "loop closure": loop_closure, observation, other }[group.role];
  }
  if (group.shape === "point") return theme.landmark;
  return group.shape === "pose" ? theme.pose : theme.camera;
}

export function onThemeChange(observer: () => void): void {
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", observer);
}
