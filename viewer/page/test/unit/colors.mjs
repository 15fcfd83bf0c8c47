// SPDX-License-Identifier: BSD-3-Clause
// What tests of colors share: the colors of style.css, and how people see them.
import { readFileSync } from "node:fs";

const STYLE = readFileSync(new URL("../../style.css", import.meta.url), "utf8");

/** The variables of a theme as [r, g, b] from 0 to 1, by their names without "--". */
function variables(begin) {
  const from = STYLE.indexOf(begin);
  const block = STYLE.slice(from, STYLE.indexOf("}", from));
  const entries = [...block.matchAll(/--([\w-]+): #([0-9a-f]{6});/g)];
  return Object.fromEntries(entries.map(([, name, hex]) => [name, [0, 2, 4].map((i) => parseInt(hex.slice(i, i + 2), 16) / 255)]));
}

export const THEMES = { light: variables(":root {"), dark: variables(':root[data-theme="dark"] {') };

function linear(color) {
  return color.map((value) => (value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4));
}

/** The contrast of WCAG 2: from 1 to 21. */
export function contrast(a, b) {
  const luminance = (color) => linear(color).reduce((sum, value, i) => sum + [0.2126, 0.7152, 0.0722][i] * value, 0);
  const [low, high] = [luminance(a), luminance(b)].sort((x, y) => x - y);
  return (high + 0.05) / (low + 0.05);
}

/** Linear RGB as people without one kind of cones see it (Machado, Oliveira and Fernandes, 2009). */
const SIGHTS = {
  all: [[1, 0, 0], [0, 1, 0], [0, 0, 1]],
  protanopia: [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]],
  deuteranopia: [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.01182, 0.04294, 0.968881]],
  tritanopia: [[1.255528, -0.076749, -0.178779], [-0.078411, 0.930809, 0.147602], [0.004733, 0.691367, 0.3039]],
};

/** The least distance of two colors in CIELAB, of all kinds of sight. */
export function leastDifference(a, b) {
  return Math.min(...Object.values(SIGHTS).map((sight) => {
    const [p, q] = [a, b].map((color) => lab(seen(sight, linear(color))));
    return Math.hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
  }));
}

function seen(sight, color) {
  return sight.map((row) => Math.min(1, Math.max(0, row[0] * color[0] + row[1] * color[1] + row[2] * color[2])));
}

function lab([r, g, b]) {
  const f = (t) => (t > 0.008856 ? Math.cbrt(t) : 7.787 * t + 16 / 116);
  const x = f((0.4124 * r + 0.3576 * g + 0.1805 * b) / 0.9505);
  const y = f(0.2126 * r + 0.7152 * g + 0.0722 * b);
  const z = f((0.0193 * r + 0.1192 * g + 0.9505 * b) / 1.089);
  return [116 * y - 16, 500 * (x - y), 200 * (y - z)];
}
