// SPDX-License-Identifier: BSD-3-Clause
// Optimizes a reconstruction on the page, and hides its bad points.
//
//     node test/view_bundle.mjs PATH_TO_BOXPLUS DATA_FOLDER     exit code 77: something is missing, so the test is skipped
import { dataFile, fail, openPage, picture, runTest, step, textOf, waitForStatus, waitForText, waitUntil } from "./support.mjs";

await runTest(dataFile("bal/problem-49-7776-pre.txt"), async (url, browser) => {
  const { page, problems } = await openPage(browser, url);

  await step("Optimize converges", async () => {
    await page.click("#optimize");
    await waitForStatus(page, "converged");
  });

  await step("a camera has an estimate: its pose, and its parameters with their names", async () => {
    await page.click("#tab-element");
    await page.fill("#element-id", "3");
    await page.press("#element-id", "Enter");
    await waitForText(page, "element-facts", "Vertex 3");
    await waitForText(page, "element-facts", "position: ");
    await waitForText(page, "element-facts", "f: ");
    await waitForText(page, "element-facts", "k2: ");
    await page.keyboard.press("Escape");
    await page.click("#unmark");
    await page.click("#tab-display");
  });

  await step("the uncertainties name the camera to which they are relative", async () => {
    await page.click("#compute-uncertainty");
    await waitForText(page, "uncertainty-note", "2000 positions, spread evenly over all 7825, relative to vertex ");
    await page.click("#show-uncertainty");
  });

  await step("the filter of track lengths says how many points it hides", async () => {
    const before = await picture(page);
    const hidden = await hiddenPoints(page, "least-track-length", "4");
    const after = await picture(page);
    if (!(after.drawn < before.drawn)) fail(`${hidden} points are hidden, but ${after.drawn} pixels are drawn`);
    if ((await hiddenPoints(page, "least-track-length", "1")) !== 0) fail("points are hidden without a filter");
  });

  await step("the filter of errors says how many points it hides", async () => {
    await waitUntil(page, () => window.boxplus.view.graph.filter.errors !== null);
    const at_1_pixel = await hiddenPoints(page, "most-error", "0");
    const at_10_pixels = await hiddenPoints(page, "most-error", "1");
    if (!(at_1_pixel > at_10_pixels)) fail(`hides ${at_1_pixel} points at 1 px, and ${at_10_pixels} at 10 px`);
  });

  await step("no error and no request to another host", () => {
    if (problems.length > 0) fail(problems.join("; "));
  });
});

/** Sets the slider, and returns the number of hidden points that the page tells. */
async function hiddenPoints(page, slider, value) {
  await page.locator(`#${slider}`).fill(value);
  const text = await textOf(page, "hidden-points");
  if (text === "All 7,776 points pass.") return 0;
  const match = /^Hides ([0-9,]+) of 7,776 points\.$/.exec(text) ?? fail(`found "${text}"`);
  return Number(match[1].replaceAll(",", ""));
}
