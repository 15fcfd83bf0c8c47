// SPDX-License-Identifier: BSD-3-Clause
// Finds the outliers of a graph on the page, looks at its vertices and edges, and edits them.
//
//     node test/view_elements.mjs PATH_TO_BOXPLUS DATA_FOLDER   exit code 77: something is missing, so the test is skipped
import {
  expectEqual, fail, openPage, picture, runTest, simulatedFile, step, textOf, waitForStatus, waitForText, waitUntil,
} from "./support.mjs";

const EMPTY_PLACE = [300, 50];
const WRONG_IDS = [["400", "there is no vertex 400"], ["-1", "expected a number"]];
const file = simulatedFile("manhattan", "--poses", "400", "--outliers", "0.2");

await runTest(file, async (url, browser) => {
  const { page, problems } = await openPage(browser, url);
  const lines = await lineCount(page);

  await step("a search for false edges colors them by its verdicts", async () => {
    await page.click("#tab-settings");
    await page.selectOption("#setting-outliers", "loop-closures");
    await page.click("#optimize");
    await waitForText(page, "log-lines", "suspected edges are false");
    await waitUntil(page, () => window.boxplus.view.frame.line_values?.verdicts);
    await page.click("#tab-display");
    await page.selectOption("#edge-coloring", "verdict");
    await picture(page);
    const [trusted, inliers, , outliers] = await legendCounts(page);
    if (!(trusted > 0 && inliers > 0 && outliers > 0)) fail(`the legend counts ${trusted}, ${inliers} and ${outliers} lines`);
    const numbers = await page.evaluate(() => {
      const { frame } = window.boxplus.view;
      const line = frame.line_values.verdicts.indexOf(3);
      return [...window.boxplus.view.graph.structure.lines.slice(2 * line, 2 * line + 2)];
    });
    await find(page, String(numbers[0]));
    await page.locator("#element-edges button", { hasText: new RegExp(`^${numbers[1]}$`) }).first().click();
    await waitForText(page, "element-facts", "Verdict");
    await waitForText(page, "element-facts", "outlier");
    await page.keyboard.press("Escape");
    await waitForText(page, "element-note", "Click a vertex");
    await page.click("#tab-display");
    await page.selectOption("#edge-coloring", "role");
    await page.click("#tab-settings");
    await page.selectOption("#setting-outliers", "none");
    await page.click("#reset");
    await waitUntil(page, () => window.boxplus.view.frame.line_values?.verdicts === null);
  });

  await step("a robust kernel leaves edges with a large chi2", async () => {
    await page.click("#tab-settings");
    await page.selectOption("#setting-kernel", "Cauchy");
    await page.click("#optimize");
    await waitForStatus(page, "converged");
    await waitUntil(page, () => window.boxplus.view.frame.line_values?.weights);
  });

  await step("edges have the colors of their chi2 or of their weight", async () => {
    await page.click("#tab-display");
    const by_role = await picture(page);
    for (const coloring of ["chi2", "weight"]) {
      await page.selectOption("#edge-coloring", coloring);
      if ((await picture(page)).hash === by_role.hash) fail(`the colors of ${coloring} are those of roles`);
      const counts = await legendCounts(page);
      const sum = counts.reduce((total, count) => total + count, 0);
      if (sum !== lines) fail(`the legend of ${coloring} counts ${sum} of ${lines} lines`);
      if (counts.at(-1) === 0) fail(`there are no outliers in ${coloring}`);
    }
    await page.selectOption("#edge-coloring", "role");
    if ((await picture(page)).hash !== by_role.hash) fail("the colors of roles do not come back");
  });

  await step("a click selects the vertex or the edge under it", async () => {
    await page.click("#fit");
    const before = await picture(page);
    await page.mouse.click(...(await placeOf(page, [7])));
    await waitForText(page, "element-facts", "Vertex 7");
    await waitForText(page, "element-facts", "SE2 · VERTEX_SE2");
    if ((await picture(page)).hash === before.hash) fail("the vertex is not marked");
    const outlier = await page.evaluate(() => {
      const { chi2 } = window.boxplus.view.frame.line_values;
      return chi2.indexOf(chi2.reduce((most, value) => Math.max(most, value)));
    });
    const ends = await page.evaluate((line) => {
      const { lines } = window.boxplus.view.graph.structure;
      return [lines[2 * line], lines[2 * line + 1]];
    }, outlier);
    // Near the end of an edge there may be others.
    const places = [[0.37, 0.63], [0.45, 0.55], [0.29, 0.71], [0.52, 0.48], [0.6, 0.4]];
    let found = "";
    for (const [a, b] of places) {
      await page.mouse.click(...EMPTY_PLACE);
      await waitForText(page, "element-note", "Click a vertex");
      await page.mouse.click(...(await placeOf(page, ends, [a, b])));
      await waitUntil(page, () => document.querySelector("#element-note").hidden);
      found = await page.locator("#element h2").textContent();
      if (found === `Edge ${ends.join(" – ")}`) break;
    }
    expectEqual(found, `Edge ${ends.join(" – ")}`);
    await page.mouse.click(...EMPTY_PLACE);
    await waitForText(page, "element-note", "Click a vertex");
    if ((await picture(page)).hash !== before.hash) fail("the mark stays");
  });

  await step("a vertex is found by its id, and its worst edge leads to the other vertex", async () => {
    await page.fill("#element-id", "12");
    await page.keyboard.press("Enter");
    await waitForText(page, "element-facts", "Vertex 12");
    const values = (await page.locator("#element-edges td:nth-child(2)").allTextContents()).map(Number);
    if (values.length < 2 || values.some((value, i) => i > 0 && value > values[i - 1])) fail(`found ${values.join(", ")}`);
    await page.locator("#element-edges button").last().click();
    await waitForText(page, "element-facts", "Edge ");
    const other = (await page.locator("#element-vertices button").allTextContents()).find((id) => id !== "12");
    await page.locator("#element-vertices button", { hasText: new RegExp(`^${other}$`) }).click();
    await waitForText(page, "element-facts", `Vertex ${other}`);
  });

  await step("the facts change with the estimates, and a wrong id has an error", async () => {
    const estimate = await page.locator("#element .numbers").textContent();
    await page.click("#reset");
    await waitUntil(page, (before) => document.querySelector("#element .numbers").textContent !== before, estimate);
    for (const [id, error] of WRONG_IDS) {
      await page.fill("#element-id", id);
      await page.keyboard.press("Enter");
      await waitForText(page, "element-note", error);
    }
  });

  await step("a vertex is fixed and freed, and the log says so", async () => {
    await find(page, "12");
    await page.click("#edit-fix");
    await page.waitForSelector("#edit-free");
    if ((await page.evaluate(() => window.boxplus.view.graph.structure.fixed[12])) !== 1) fail("the picture does not know it");
    await page.click("#edit-free");
    await page.waitForSelector("#edit-fix");
    await waitForText(page, "log-lines", "vertex 12 is fixed");
    await waitForText(page, "log-lines", "vertex 12 is free");
  });

  await step("edges are scaled, disabled and removed, and chi2 follows", async () => {
    await page.click("#optimize");
    await waitForStatus(page, "converged");
    await find(page, "12");
    await page.locator("#element-edges button").first().click();
    await waitForText(page, "element-facts", "Edge ");
    const chi2 = () => textOf(page, "chi2");
    const changed = async (action) => {
      const before = await chi2();
      await action();
      await waitUntil(page, (old) => document.querySelector("#chi2").textContent !== old, before);
      await waitUntil(page, () => !window.boxplus.model.isBusy);
    };
    const first = await chi2();
    await page.fill("#edit-factor", "100");
    await changed(() => page.click("#edit-scale"));
    await page.fill("#edit-factor", "0.01");
    await changed(() => page.click("#edit-scale"));
    expectEqual(await chi2(), first);
    await changed(() => page.click("#edit-disable"));
    await page.waitForSelector("#edit-enable");
    await changed(() => page.click("#edit-enable"));
    expectEqual(await chi2(), first);
    const lines_before = await lineCount(page);
    await changed(() => page.click("#edit-remove"));
    await waitForText(page, "element-note", "Click a vertex");
    await waitUntil(page, (count) => window.boxplus.view.graph.structure.lines.length / 2 === count, lines_before - 1);
  });

  await step("a vertex is removed, the camera stays, and the graph is optimized again", async () => {
    await page.focus("#scene");
    await page.keyboard.press("+");
    await find(page, "12");
    const camera = await page.evaluate(() => window.boxplus.view.camera);
    await page.click("#edit-remove");
    await waitForText(page, "counts", "399 vertices");
    await waitUntil(page, () => window.boxplus.view.frame !== null);
    const after = await page.evaluate(() => window.boxplus.view.camera);
    const moved = Math.max(...camera.target.map((value, i) => Math.abs(value - after.target[i])));
    if (moved > 1e-6 * camera.height || Math.abs(after.height / camera.height - 1) > 1e-9) fail(`the camera moved by ${moved}`);
    await page.click("#optimize");
    await waitUntil(page, () => {
      const { isBusy, run } = window.boxplus.model;
      return !isBusy && run !== null && run.status !== "running";
    });
    expectEqual(await textOf(page, "command-error"), "×");
    await page.click("#reset");
    await waitForText(page, "log-lines", "what was edited stays edited");
  });

  await step("no error and no request to another host", () => {
    const others = problems.filter((text) => !text.includes("status of 400"));
    if (others.length > 0) fail(others.join("; "));
    expectEqual(String(problems.length), String(WRONG_IDS.length));
  });
});

async function find(page, id) {
  await page.click("#tab-element");
  await page.fill("#element-id", id);
  await page.keyboard.press("Enter");
  await waitForText(page, "element-facts", `Vertex ${id}`);
}

function lineCount(page) {
  return page.evaluate(() => window.boxplus.view.graph.structure.lines.length / 2);
}

/** Where the weighted mean of some vertices is on the page. */
function placeOf(page, vertices, weights = [1]) {
  return page.evaluate(([numbers, factors]) => {
    const { graph, viewProjection, rig } = window.boxplus.view;
    const place = graph.placeOf(numbers[0]).multiplyScalar(factors[0]);
    numbers.slice(1).forEach((number, i) => place.addScaledVector(graph.placeOf(number), factors[i + 1]));
    place.applyMatrix4(viewProjection.call({ rig }));
    const { left, top, width, height } = document.querySelector("#scene").getBoundingClientRect();
    return [left + (0.5 + 0.5 * place.x) * width, top + (0.5 - 0.5 * place.y) * height];
  }, [vertices, weights]);
}

/** The numbers of lines in the legend, from the least chi2 to that of outliers. */
async function legendCounts(page) {
  const texts = await page.locator("#edge-legend .number").allTextContents();
  return texts.map((text) => Number(text.replaceAll(",", "")));
}
