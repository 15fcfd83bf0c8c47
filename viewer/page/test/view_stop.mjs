// SPDX-License-Identifier: BSD-3-Clause
// Stops a long run on the page: a sphere whose optimization takes seconds.
//
//     node test/view_stop.mjs PATH_TO_BOXPLUS DATA_FOLDER       exit code 77: something is missing, so the test is skipped
import { fail, openPage, runTest, simulatedFile, step, textOf, waitForStatus, waitUntil } from "./support.mjs";

await runTest(simulatedFile("sphere", "--poses", "20000"), async (url, browser) => {
  const { page, problems } = await openPage(browser, url);
  const initial = Number(await textOf(page, "chi2"));

  await step("Stop ends the run, and keeps its best estimates", async () => {
    await page.click("#optimize");
    await waitUntil(page, clickStopAfterFirstIteration);
    await waitForStatus(page, "not converged");
    const chi2 = Number(await textOf(page, "chi2"));
    if (!(chi2 < initial)) fail(`chi2 was ${initial}, and is ${chi2}`);
    await waitUntil(page, () => document.querySelector("#stop").disabled && !document.querySelector("#optimize").disabled);
  });

  await step("no error and no request to another host", () => {
    if (problems.length > 0) fail(problems.join("; "));
  });
});

/** Runs in the page. */
function clickStopAfterFirstIteration() {
  const stop = document.querySelector("#stop");
  if (stop.disabled || document.querySelectorAll("#rows tr").length === 0) return false;
  stop.click();
  return true;
}
