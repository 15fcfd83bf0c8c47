// SPDX-License-Identifier: BSD-3-Clause
// Shows what lasers have hit. The points move with their poses.
//
//     node test/view_scans.mjs PATH_TO_BOXPLUS DATA_FOLDER   exit code 77: something is missing, so the test is skipped
import { readFileSync, writeFileSync } from "node:fs";
import {
  expectEqual, fail, openPage, picture, pictureAtRest, runTest, simulatedFile, step, waitForStatus,
} from "./support.mjs";

/** A half circle of points, 3 m away from the robot. */
const BEAMS = 90;
const SCAN = `ROBOTLASER1 0 -1.57 3.14 0.035 80 0 0 ${BEAMS} ${Array(BEAMS).fill("3").join(" ")} 0 0 0 0 0 0 0 0 0 0 0 0 0 robot 0`;

function fileWithScans(boxplus) {
  const path = simulatedFile("manhattan", "--poses", "100")(boxplus);
  writeFileSync(path, readFileSync(path, "utf8").replace(/^VERTEX_SE2 .*$/gm, (vertex) => `${vertex}\n${SCAN}`));
  return path;
}

await runTest(fileWithScans, async (url, browser) => {
  const { page, problems } = await openPage(browser, url);

  await step("the scans can be hidden and shown", async () => {
    const shown = await pictureAtRest(page);
    await page.click("#show-scans");
    const hidden = await picture(page);
    if (hidden.drawn >= shown.drawn) fail(`${shown.drawn} pixels are drawn, and ${hidden.drawn} without scans`);
    await page.click("#show-scans");
    expectEqual((await picture(page)).hash, shown.hash);
  });

  await step("the points move with the estimates", async () => {
    for (const type of ["#vertices-0", "#edges-0", "#edges-1"]) await page.click(type);
    const before = await pictureAtRest(page);
    if (before.drawn === 0) fail("nothing is drawn, but there are scans");
    await page.click("#optimize");
    await waitForStatus(page, "converged");
    if ((await pictureAtRest(page)).hash === before.hash) fail("the optimization does not change the picture");
  });

  await step("no error and no request to another host", () => {
    if (problems.length > 0) fail(problems.join("; "));
  });
  await page.close();
});
