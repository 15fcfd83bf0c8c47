// SPDX-License-Identifier: BSD-3-Clause
// What is wrong with a graph: the list of findings, and their marks in the picture.
//
//     node test/view_diagnosis.mjs PATH_TO_BOXPLUS DATA_FOLDER   exit code 77: something is missing, so the test is skipped
import { appendFileSync } from "node:fs";
import {
  expectEqual, fail, openPage, picture, pictureAtRest, runTest, simulatedFile, step, textOf, waitForStatus, waitForText, waitUntil,
} from "./support.mjs";

/** A pose that nothing measures, and a component of two poses that is not connected with the rest. */
const DEFECTS = `VERTEX_SE2 1000 5 5 0
VERTEX_SE2 1001 0 9 0
VERTEX_SE2 1002 1 9 0
EDGE_SE2 1001 1002 1 0 0 100 0 0 100 0 100
`;

function defectiveFile(boxplus) {
  const path = simulatedFile("manhattan", "--poses", "100")(boxplus);
  appendFileSync(path, DEFECTS);
  return path;
}

await runTest(defectiveFile, async (url, browser) => {
  const { page, problems } = await openPage(browser, url);
  const findings = () => page.locator("#findings li");
  const of = (kind) => page.locator(`#findings li[data-kind="${kind}"] button`);

  await step("Diagnose lists what is wrong", async () => {
    await page.click("#tab-element");
    expectEqual(await findings().count(), 0);
    await page.click("#diagnose");
    await waitForText(page, "diagnosis-note", "finding");
    const isolated = await of("isolated-vertex").textContent();
    if (!isolated.includes("1000")) fail(`found "${isolated}"`);
    const free = await of("free-component").allTextContents();
    if (!free.some((text) => text.includes("1001"))) fail(`found "${free}"`);
  });

  await step("a click on a finding marks what it is about", async () => {
    const without = await pictureAtRest(page);
    await of("free-component").last().click();
    await waitForText(page, "element-note", "marked");
    const group = await pictureAtRest(page);
    if (group.hash === without.hash) fail("nothing is marked");
    await of("isolated-vertex").click();
    await waitForText(page, "element-facts", "Vertex 1000");
    if ((await pictureAtRest(page)).hash === group.hash) fail("the mark did not move");
  });

  await step("an edit clears the list, and a run makes it old", async () => {
    await page.locator("#element-edits button", { hasText: "Remove" }).click();
    await waitUntil(page, () => document.querySelectorAll("#findings li").length === 0);
    await page.click("#diagnose");
    await waitForText(page, "diagnosis-note", "finding");
    expectEqual(await of("isolated-vertex").count(), 0);
    await page.click("#optimize");
    await waitForStatus(page, "converged");
    await waitForText(page, "diagnosis-note", "changed since");
    await picture(page);
    if ((await textOf(page, "diagnosis-note")).includes("finding")) fail("the note is not new");
  });

  await step("no error and no request to another host", () => {
    if (problems.length > 0) fail(problems.join("; "));
  });
});
