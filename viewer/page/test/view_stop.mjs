// SPDX-License-Identifier: BSD-3-Clause
// Stops a run on the page: a reconstruction whose optimization takes longer than a click.
//
//     node test/view_stop.mjs PATH_TO_BOXPLUS DATA_FOLDER       exit code 77: something is missing, so the test is skipped
import { fail, openPage, runTest, step, textOf, waitForStatus, waitUntil } from "./support.mjs";

await runTest("bal/problem-49-7776-pre.txt", async (url, browser) => {
  const { page, problems } = await openPage(browser, url);
  const initial = Number(await textOf(page, "chi2"));

  await step("Stop ends the run, and keeps its best estimates", async () => {
    await page.evaluate(clickStopDuringRun);
    await waitForStatus(page, "not converged");
    const chi2 = Number(await textOf(page, "chi2"));
    if (!(chi2 < initial)) fail(`chi2 was ${initial}, and is ${chi2}`);
    await waitUntil(page, () => document.querySelector("#stop").disabled && !document.querySelector("#optimize").disabled);
  });

  await step("the filter says how many points it hides", async () => {
    await page.locator("#least-track-length").fill("4");
    const text = await textOf(page, "hidden-points");
    if (!/^Hides [1-9][0-9,]* of 7,776 points\.$/.test(text)) fail(`found "${text}"`);
  });

  await step("no error and no request to another host", () => {
    if (problems.length > 0) fail(problems.join("; "));
  });
});

/** Clicks Stop after the first iterations of the run. */
function clickStopDuringRun() {
  document.querySelector("#optimize").click();
  return new Promise((resolve) => {
    const timer = setInterval(() => {
      const stop = document.querySelector("#stop");
      if (stop.disabled || document.querySelectorAll("#rows tr").length < 2) return;
      clearInterval(timer);
      stop.click();
      resolve();
    }, 5);
  });
}
