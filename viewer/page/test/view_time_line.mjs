// SPDX-License-Identifier: BSD-3-Clause
// The time line of the page: goes through the iterations of a run, and plays them.
//
//     node test/view_time_line.mjs PATH_TO_BOXPLUS DATA_FOLDER  exit code 77: something is missing, so the test is skipped
import {
  dataFile, expectEqual, fail, openPage, picture, runTest, step, textOf, waitForPicture, waitForStatus, waitForText, waitUntil,
} from "./support.mjs";

const CHI2_INITIAL = "551.735731", CHI2_FINAL = "45.0046958";

await runTest(dataFile("posegraph2d/intel_1728.g2o"), async (url, browser) => {
  const { page, problems } = await openPage(browser, url);
  let initial, final, last;

  await step("before a run, there is nothing to go through", async () => {
    initial = await picture(page);
    expectEqual(await textOf(page, "time-text"), `Iteration 0, chi2 ${CHI2_INITIAL}`);
    if (await page.isEnabled("#time")) fail("the slider is enabled");
    if (await page.isEnabled("#play")) fail("Play is enabled");
  });

  await step("the time line follows a run to its end", async () => {
    await page.click("#optimize");
    await waitForStatus(page, "converged");
    await waitForText(page, "time-text", CHI2_FINAL);
    await page.click("#fit");
    final = await picture(page);
    last = await page.locator("#rows tr").count();
    expectEqual(await textOf(page, "time-text"), `Iteration ${last} of ${last}, chi2 ${CHI2_FINAL}`);
  });

  await step("Home shows the estimates before the run, and marks them in the chart", async () => {
    const chart = await page.locator("#chart").screenshot();
    await page.focus("#time");
    await page.keyboard.press("Home");
    expectEqual(await textOf(page, "time-text"), `Iteration 0 of ${last}, chi2 ${CHI2_INITIAL}`);
    await page.click("#fit");
    expectEqual((await picture(page)).hash, initial.hash);
    if (chart.equals(await page.locator("#chart").screenshot())) fail("the mark in the chart did not move");
    expectEqual(await textOf(page, "chi2"), CHI2_FINAL);
  });

  await step("the arrow keys go through the iterations", async () => {
    await page.focus("#time");
    await page.keyboard.press("ArrowRight");
    const text = await textOf(page, "time-text");
    const [, iteration, chi2] = /^Iteration (\d+) of \d+, chi2 (.*)$/.exec(text) ?? fail(`found "${text}"`);
    const row = await page.locator(`#rows tr:nth-child(${iteration}) td:nth-child(2)`).textContent();
    if (Math.abs(Number(chi2) / Number(row) - 1) > 1e-6) fail(`found "${text}", and ${row} in the table`);
    await page.keyboard.press("End");
    await page.click("#fit");
    expectEqual((await picture(page)).hash, final.hash);
  });

  await step("a click in the chart shows the iteration", async () => {
    await page.locator("#chart .u-over").click({ position: { x: 2, y: 40 } });
    await waitForText(page, "time-text", `Iteration 0 of ${last}`);
  });

  await step("Play goes from the first to the last iteration", async () => {
    await page.keyboard.press("End");
    await page.click("#play");
    expectEqual(await page.getAttribute("#play", "aria-label"), "Pause");
    await waitUntil(page, () => document.querySelector("#play").getAttribute("aria-label") === "Play");
    expectEqual(await textOf(page, "time-text"), `Iteration ${last} of ${last}, chi2 ${CHI2_FINAL}`);
  });

  await step("a page that was reloaded has the time line again", async () => {
    await page.reload();
    await waitForPicture(page);
    await waitForText(page, "time-text", `Iteration ${last} of ${last}, chi2 ${CHI2_FINAL}`);
    await page.focus("#time");
    await page.keyboard.press("Home");
    await waitForText(page, "time-text", `Iteration 0 of ${last}, chi2 ${CHI2_INITIAL}`);
    await page.keyboard.press("End");
  });

  await step("another run begins from the estimates of the run before", async () => {
    await page.click("#reset");
    await waitForText(page, "time-text", `Iteration 0, chi2 ${CHI2_INITIAL}`);
    await page.click("#step");
    await waitForText(page, "time-text", "Iteration 1 of 1");
    const chi2 = await textOf(page, "chi2");
    await page.click("#step");
    await waitUntil(page, (before) => document.querySelector("#chi2").textContent !== before, chi2);
    await waitForText(page, "time-text", `Iteration 1 of 1, chi2 ${await textOf(page, "chi2")}`);
    await page.focus("#time");
    await page.keyboard.press("Home");
    expectEqual(await textOf(page, "time-text"), `Iteration 0 of 1, chi2 ${chi2}`);
  });

  await step("Reset begins anew", async () => {
    await page.click("#reset");
    await waitForText(page, "time-text", `Iteration 0, chi2 ${CHI2_INITIAL}`);
    if (await page.isEnabled("#time")) fail("the slider is enabled");
  });

  await step("no error and no request to another host", () => {
    if (problems.length > 0) fail(problems.join("; "));
  });
});
