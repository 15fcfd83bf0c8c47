// SPDX-License-Identifier: BSD-3-Clause
// Optimizes intel_1728.g2o on the page, as a user would.
//
//     node test/view_intel.mjs PATH_TO_BOXPLUS DATA_FOLDER      exit code 77: something is missing, so the test is skipped
import {
  dataFile, expectEqual, fail, openPage, picture, runTest, step, textOf, waitForPicture, waitForStatus, waitUntil,
} from "./support.mjs";

const CHI2_INITIAL = "551.735731", CHI2_FINAL = "45.0046958";

await runTest(dataFile("posegraph2d/intel_1728.g2o"), async (url, browser) => {
  const first = await openPage(browser, url);
  const { page } = first;
  let before;

  await step("the page draws the graph of the file", async () => {
    expectEqual(await textOf(page, "file"), "intel_1728.g2o");
    expectEqual(await textOf(page, "chi2"), CHI2_INITIAL);
    before = await picture(page);
    if (before.drawn < 1000) fail(`only ${before.drawn} pixels are not background`);
  });

  await step("Optimize converges to the known chi2", async () => {
    await page.click("#optimize");
    await waitForStatus(page, "converged");
    expectEqual(await textOf(page, "chi2"), CHI2_FINAL);
  });

  await step("the picture changed", async () => {
    await waitForNewestFrame(page);
    const after = await picture(page);
    if (after.hash === before.hash) fail("the pixels are the same");
  });

  await step("a second page shows the same state", async () => {
    const second = await openPage(browser, url);
    await waitForStatus(second.page, "converged");
    expectEqual(await contents(second.page), await contents(page));
    await second.page.click("#reset");
    await waitUntil(page, (chi2) => document.querySelector("#chi2").textContent === chi2, CHI2_INITIAL);
    await expectNoProblems(second.problems);
    await second.page.close();
  });

  await step("Reset shows the picture of the file", async () => {
    await waitForNewestFrame(page);
    await page.click("#fit");
    const after = await picture(page);
    if (after.hash !== before.hash) fail("the pixels differ");
  });

  await step("a check box hides the poses", async () => {
    await page.uncheck("#vertices-0");
    const { drawn } = await picture(page);
    if (!(drawn < before.drawn)) fail(`${drawn} of ${before.drawn} pixels are left`);
    await page.check("#vertices-0");
    if ((await picture(page)).hash !== before.hash) fail("the poses do not come back");
  });

  await step("Step carries out one iteration", async () => {
    await page.click("#step");
    await waitUntil(page, () => document.querySelectorAll("#rows tr").length === 1);
    await waitUntil(page, () => !document.querySelector("#step").disabled);
    const chi2 = Number(await textOf(page, "chi2"));
    if (!(chi2 > Number(CHI2_FINAL) && chi2 < Number(CHI2_INITIAL))) fail(`chi2 is ${chi2}`);
  });

  await step("Stop is possible only during a run", async () => {
    if (await page.isEnabled("#stop")) fail("the button is enabled");
    await page.click("#optimize");
    await waitForStatus(page, "converged");
    if (await page.isEnabled("#stop")) fail("the button is enabled after the run");
  });

  await step("a reload shows the same state", async () => {
    const shown = await contents(page);
    await page.reload();
    await waitForPicture(page);
    await waitForStatus(page, "converged");
    expectEqual(await contents(page), shown);
  });

  await step("no error and no request to another host", () => expectNoProblems(first.problems));
});

/** What the panels show of the state. */
async function contents(page) {
  const texts = await Promise.all(["file", "counts", "chi2", "status", "headline", "rows"].map((id) => textOf(page, id)));
  return texts.join("\n");
}

/** Waits until the frame of the chi2 that the page shows is in the picture. */
function waitForNewestFrame(page) {
  return waitUntil(page, () => {
    const { model, view } = window.boxplus;
    return !model.isBusy && view.chi2 === model.state.chi2;
  });
}

function expectNoProblems(problems) {
  if (problems.length > 0) fail(problems.join("; "));
}
