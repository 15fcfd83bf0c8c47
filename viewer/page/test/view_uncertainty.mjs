// SPDX-License-Identifier: BSD-3-Clause
// Shows how uncertain positions are, in the plane and in space.
//
//     node test/view_uncertainty.mjs PATH_TO_BOXPLUS DATA_FOLDER   exit code 77: something is missing, so the test is skipped
import {
  expectEqual, fail, openPage, picture, pictureAtRest, runTest, simulatedFile, step, textOf, waitForStatus, waitForText, waitUntil,
} from "./support.mjs";

for (const world of ["manhattan", "sphere"]) {
  await runTest(simulatedFile(world, "--poses", "100"), async (url, browser) => {
    const { page, problems } = await openPage(browser, url);
    await page.click("#optimize");
    await waitForStatus(page, "converged");
    const without = await pictureAtRest(page);

    await step(`${world}: Compute draws the regions`, async () => {
      await page.click("#compute-uncertainty");
      await waitForText(page, "uncertainty-note", "Covariances of all 100 positions");
      const chi2 = await textOf(page, "chi2");
      await waitForText(page, "time-text", `chi2 ${chi2}`);
      const { hash, drawn } = await pictureAtRest(page);
      if (hash === without.hash || drawn <= without.drawn) fail(`${drawn} pixels are drawn, and ${without.drawn} before`);
    });

    await step("they can be hidden, together or with their type", async () => {
      const shown = await picture(page);
      await page.click("#show-uncertainty");
      expectEqual((await picture(page)).hash, without.hash);
      await page.click("#show-uncertainty");
      expectEqual((await picture(page)).hash, shown.hash);
      await page.click("#vertices-0");
      const no_poses = await picture(page);
      await page.click("#show-uncertainty");
      expectEqual((await picture(page)).hash, no_poses.hash);
      await page.click("#show-uncertainty");
      await page.click("#vertices-0");
    });

    await step("vertices are colored by them", async () => {
      const by_type = await picture(page);
      await page.selectOption("#color-mode", "uncertainty");
      if ((await picture(page)).hash === by_type.hash) fail("the uncertainties do not change the picture");
      const counts = (await page.locator("#legend .number").allTextContents()).map(Number);
      expectEqual(counts.reduce((sum, each) => sum + each, 0), 100);
      if (counts.filter((each) => each > 0).length < 4) fail(`the classes have ${counts} vertices`);
    });

    await step("they vanish with the estimates to which they belong", async () => {
      await page.focus("#scene");
      await page.keyboard.press("<");
      await waitUntil(page, () => document.getElementById("uncertainty-note").hidden);
      await page.keyboard.press(">");
      await waitForText(page, "uncertainty-note", "Covariances");
      await page.click("#reset");
      await waitUntil(page, () => document.getElementById("uncertainty-note").hidden);
      await waitForText(page, "legend", "Compute the uncertainty first.");
    });

    await step("no error and no request to another host", () => {
      if (problems.length > 0) fail(problems.join("; "));
    });
  });
}
