// SPDX-License-Identifier: BSD-3-Clause
// Shows how uncertain positions are, in the plane and in space.
//
//     node test/view_uncertainty.mjs PATH_TO_BOXPLUS DATA_FOLDER   exit code 77: something is missing, so the test is skipped
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
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
      await waitForText(page, "uncertainty-note", "Uncertainties belong to the newest estimates.");
      await waitForText(page, "legend", "Uncertainties belong to the newest estimates.");
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

/** The poses of the second chain are known 1000 times worse than they are long. */
function looseChain() {
  const folder = mkdtempSync(join(tmpdir(), "boxplus-"));
  process.on("exit", () => rmSync(folder, { recursive: true }));
  const lines = ["FIX 0"];
  for (let id = 0; id < 600; ++id) {
    lines.push(`VERTEX_SE3:QUAT ${id} ${id % 30} ${Math.floor(id / 30)} 0 0 0 0 1`);
    const information = id <= 20 ? 1e6 : 1e-4;
    const diagonal = (i) => [information, ...new Array(5 - i).fill(0)].join(" ");
    const [before, now] = [id - 1, id].map((each) => [each % 30, Math.floor(each / 30)]);
    if (id > 0) lines.push(`EDGE_SE3:QUAT ${id - 1} ${id} ${now[0] - before[0]} ${now[1] - before[1]} 0 0 0 0 1 ${[0, 1, 2, 3, 4, 5].map(diagonal).join(" ")}`);
  }
  const path = join(folder, "chain.g2o");
  writeFileSync(path, `${lines.join("\n")}\n`);
  return path;
}

await runTest(looseChain, async (url, browser) => {
  const { page, problems } = await openPage(browser, url);

  await step("regions that are large for the graph are limited and counted", async () => {
    await page.click("#compute-uncertainty");
    await waitForText(page, "uncertainty-note", "579 regions are larger than 5 % of the graph, and 80 of them are drawn, as outlines. 579 are even larger than 10 %");
    const counts = await page.evaluate(() => window.boxplus.view.graph.ellipses.parts.map(({ geometry }) => geometry.instanceCount));
    expectEqual(counts.join(), "21,101");
  });

  await step("no error and no request to another host", () => {
    if (problems.length > 0) fail(problems.join("; "));
  });
});
