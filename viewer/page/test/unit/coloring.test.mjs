// SPDX-License-Identifier: BSD-3-Clause
// Tests of src/scene/coloring.ts and of the colors of classes, without a browser.
import assert from "node:assert/strict";
import test from "node:test";
import { contrast, leastDifference, THEMES } from "./colors.mjs";
import { load } from "./load.mjs";

const { coloringOf, MOST_CLASSES } = await load("src/scene/coloring.ts");

function structure(vertices, ...edges) {
  return { fixed: new Uint8Array(vertices), lines: Uint32Array.from(edges.flat()) };
}

test("by type, there are no classes", () => {
  assert.equal(coloringOf(structure(2, [0, 1]), "type", null), null);
});

test("the degree of a vertex is the number of its edges", () => {
  const { classes, of_vertex } = coloringOf(structure(5, [0, 1], [1, 2], [1, 3], [0, 1]), "degree", null);
  assert.deepEqual(classes, [
    { name: "0", count: 1 }, { name: "1", count: 2 }, { name: "2", count: 1 }, { name: "4", count: 1 },
  ]);
  assert.deepEqual([...of_vertex], [2, 3, 1, 1, 0]);
});

test("high degrees are classes of several degrees up to the largest", () => {
  const star = (degree) => structure(degree + 1, ...Array.from({ length: degree }, (_, i) => [0, i + 1]));
  assert.deepEqual(coloringOf(star(8), "degree", null).classes.map(({ name }) => name), ["1", "5–8"]);
  assert.deepEqual(coloringOf(star(17), "degree", null).classes.map(({ name }) => name), ["1", "17"]);
  assert.deepEqual(coloringOf(star(1200), "degree", null).classes.map(({ name }) => name), ["1", "17–1,200"]);
});

test("components are sorted by size", () => {
  const { classes, of_vertex } = coloringOf(structure(6, [0, 4], [5, 1], [2, 3], [3, 5]), "component", null);
  assert.deepEqual(classes, [{ name: "Component 1", count: 4 }, { name: "Component 2", count: 2 }]);
  assert.deepEqual([...of_vertex], [1, 0, 0, 0, 1, 0]);
});

test("components beyond the number of colors are one class", () => {
  const { classes, of_vertex } = coloringOf(structure(11, [9, 10]), "component", null);
  assert.equal(classes.length, MOST_CLASSES);
  assert.deepEqual(classes.at(0), { name: "Component 1", count: 2 });
  assert.deepEqual(classes.at(-1), { name: "3 others", count: 3 });
  assert.equal(of_vertex.filter((i) => i === MOST_CLASSES - 1).length, 3);
});

test("a path of many vertices in any order is one component", () => {
  const count = 20_000;
  const edges = Array.from({ length: count - 1 }, (_, i) => [i + 1, i]).reverse();
  assert.deepEqual(coloringOf(structure(count, ...edges), "component", null).classes, [{ name: "Component 1", count }]);
});

test("the uncertainty of a vertex is the standard deviation of its position", () => {
  const covariances = (...sigmas) => Float32Array.from(sigmas.flatMap((sigma) => [sigma ** 2 / 2, 9, 9, sigma ** 2 / 2, 9, 0]));
  const uncertainty = { note: "", vertices: Uint32Array.of(0, 2, 3, 4), covariances: covariances(1, 64, 30, 0) };
  const { has_rest, classes, of_vertex } = coloringOf(structure(6, [0, 1]), "uncertainty", uncertainty);
  assert.deepEqual(classes, [
    { name: "1–2", count: 1 }, { name: "2–4", count: 0 }, { name: "4–8", count: 0 }, { name: "8–16", count: 0 },
    { name: "16–32", count: 1 }, { name: "32–64", count: 1 }, { name: "fixed, or not known", count: 3 },
  ]);
  assert.deepEqual([...of_vertex], [0, 6, 5, 4, 6, 6]);
  assert.equal(has_rest, true);
});

test("a few huge or tiny uncertainties do not determine the classes", () => {
  const sigmas = Array.from({ length: 100 }, (_, i) => (i < 2 ? 1e-6 : i === 99 ? 1e6 : 2 ** ((6 * (i - 2)) / 96)));
  const covariances = Float32Array.from(sigmas.flatMap((sigma) => [sigma ** 2, 0, 0, 0, 0, 0]));
  const uncertainty = { note: "", vertices: Uint32Array.from(sigmas, (_, i) => i), covariances };
  const { classes } = coloringOf(structure(100, [0, 1]), "uncertainty", uncertainty);
  assert.deepEqual(classes.map(({ name }) => name), ["1e-6–2", "2–4", "4–8", "8–16", "16–32", "32–1e6"]);
  for (const each of classes) assert.ok(each.count >= 15, JSON.stringify(classes));
});

test("one uncertainty that differs from all others has a class of its own", () => {
  const sigmas = Array.from({ length: 100 }, (_, i) => (i === 7 ? 64 : 1));
  const covariances = Float32Array.from(sigmas.flatMap((sigma) => [sigma ** 2, 0, 0, 0, 0, 0]));
  const uncertainty = { note: "", vertices: Uint32Array.from(sigmas, (_, i) => i), covariances };
  const { classes } = coloringOf(structure(100, [0, 1]), "uncertainty", uncertainty);
  assert.deepEqual(classes.map(({ count }) => count), [99, 0, 0, 0, 0, 1]);
});

test("without uncertainties, all vertices are the rest; equal ones are one class", () => {
  const { has_rest, classes } = coloringOf(structure(2, [0, 1]), "uncertainty", null);
  assert.deepEqual([has_rest, classes], [true, [{ name: "fixed, or not known", count: 2 }]]);
  const equal = { note: "", vertices: Uint32Array.of(0, 1), covariances: Float32Array.of(4, 0, 0, 0, 0, 0, 0, 0, 0, 4, 0, 0) };
  assert.deepEqual(coloringOf(structure(2, [0, 1]), "uncertainty", equal).classes, [{ name: "2", count: 2 }]);
});

for (const [name, theme] of Object.entries(THEMES)) {
  const classes = Array.from({ length: MOST_CLASSES }, (_, i) => theme[`class-${i + 1}`]);
  const ramp = ["low", "middle", "high"].map((place) => theme[`ramp-${place}`]);

  test(`color-blind people can tell the components apart in the ${name} theme`, () => {
    for (let i = 0; i < MOST_CLASSES; ++i) {
      for (let k = 0; k < i; ++k) {
        const difference = leastDifference(classes[i], classes[k]);
        assert.ok(difference > 20, `--class-${k + 1} and --class-${i + 1} differ by ${difference.toFixed(1)}`);
      }
    }
  });

  test(`color-blind people see the order of degrees in the ${name} theme`, () => {
    const contrasts = ramp.map((color) => contrast(color, theme.scene));
    assert.ok(contrasts[0] * 1.5 < contrasts[1] && contrasts[1] * 1.5 < contrasts[2], `the contrasts are ${contrasts}`);
  });

  test(`the colors of classes stand out from the ${name} background`, () => {
    for (const color of [...classes, ...ramp]) assert.ok(contrast(color, theme.scene) >= 3, `${color}`);
  });
}
