// SPDX-License-Identifier: BSD-3-Clause
// The contrast of the colors of style.css, as WCAG 2.2 (level AA) wants it: 4.5 for text, 3 for borders and signs.
import assert from "node:assert/strict";
import test from "node:test";
import { contrast, leastDifference, THEMES } from "./colors.mjs";

const BACKGROUNDS = ["back", "raised", "scene"];
const TEXTS = ["text", "dim", "accent", "good", "bad", "warn", "mark"];
/** Borders of controls, the ring around what has the focus, and signs of the legend. */
const SIGNS = [
  "edge", "accent", "bad", "pose", "camera", "landmark", "fixed", "truth", "uncertainty", "odometry", "loop-closure", "observation", "other-edge",
];

for (const [name, theme] of Object.entries(THEMES)) {
  const check = (color, background, least) => {
    const found = contrast(theme[color], theme[background]);
    assert.ok(found >= least, `the contrast of --${color} on --${background} is ${found.toFixed(2)}`);
  };

  test(`texts can be read in the ${name} theme`, () => {
    for (const color of TEXTS) for (const background of BACKGROUNDS) check(color, background, 4.5);
    check("on-accent", "accent", 4.5);
    check("bad", "bad-back", 4.5);
  });

  test(`controls and signs can be seen in the ${name} theme`, () => {
    for (const color of SIGNS) for (const background of BACKGROUNDS) check(color, background, 3);
  });
}

for (const [name, theme] of Object.entries(THEMES)) {
  test(`color-blind people can tell the truth from all else in the ${name} theme`, () => {
    for (const other of ["before", "scene", "selection", ...SIGNS.slice(SIGNS.indexOf("pose"))]) {
      if (other === "truth") continue;
      const difference = leastDifference(theme.truth, theme[other]);
      assert.ok(difference > 20, `--truth and --${other} differ by ${difference.toFixed(1)}`);
    }
  });
}

/** Of [r, g, b], in degrees. */
function hue([r, g, b]) {
  return (Math.atan2(Math.sqrt(3) * (g - b), 2 * r - g - b) * 180) / Math.PI;
}

for (const [name, theme] of Object.entries(THEMES)) {
  test(`the truth, the uncertainty and bad edges have different hues in the ${name} theme`, () => {
    const colors = ["truth", "uncertainty", "level-5"];
    for (const [i, a] of colors.entries()) {
      for (const b of colors.slice(0, i)) {
        const angle = Math.abs(hue(theme[a]) - hue(theme[b])) % 360;
        const difference = Math.min(angle, 360 - angle);
        assert.ok(difference > 45, `the hues of --${a} and --${b} differ by ${difference.toFixed(0)}°`);
      }
    }
  });
}

test("the contrast of black and white is 21", () => {
  assert.equal(contrast([0, 0, 0], [1, 1, 1]).toFixed(3), "21.000");
});
