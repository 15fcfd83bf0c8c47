// SPDX-License-Identifier: BSD-3-Clause
// The colors of the scene and of the plot: the variables of style.css, which has them for dark and for light themes.
import { Color } from "three";

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
  };
}

export function onThemeChange(observer: () => void): void {
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", observer);
}
