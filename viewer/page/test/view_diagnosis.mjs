// SPDX-License-Identifier: BSD-3-Clause
// What is wrong with a graph: the list of findings, and their marks in the picture.
//
//     node test/view_diagnosis.mjs PATH_TO_BOXPLUS DATA_FOLDER   exit code 77: something is missing, so the test is skipped
import { appendFileSync } from "node:fs";
import {
  expectEqual, fail, openPage, pictureAtRest, runTest, simulatedFile, step, waitForStatus, waitForText, waitUntil,
} from "./support.mjs";

/** A pose that nothing measures, a component of two poses that is not connected with the rest, and two edges with an Ω of another unit. */
const DEFECTS = `VERTEX_SE2 1000 5 5 0
VERTEX_SE2 1001 0 9 0
VERTEX_SE2 1002 1 9 0
EDGE_SE2 1001 1002 1 0 0 100 0 0 100 0 100
EDGE_SE2 3 4 1 0 0 1e-9 0 0 1e-9 0 1e-9
EDGE_SE2 20 21 1 0 0 1e-9 0 0 1e-9 0 1e-9
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

  await step("a finding about edges marks them", async () => {
    await of("mixed-units").first().click();
    await waitForText(page, "element-note", "2 edges are marked.");
    const ends = await page.evaluate(() => window.boxplus.view.graph.selection.objects[1].geometry.drawRange.count);
    expectEqual(ends, 4);
  });

  await step("Escape unmarks", async () => {
    const marked = await pictureAtRest(page);
    if (!(await page.isVisible("#unmark"))) fail("there is nothing to unmark");
    await page.keyboard.press("Escape");
    await waitForText(page, "element-note", "Click a vertex");
    if (await page.isVisible("#unmark")) fail("Unmark is visible");
    if ((await pictureAtRest(page)).drawn >= marked.drawn) fail("the marks are still drawn");
  });

  await step("a page that is reloaded and another page show the same findings", async () => {
    const texts = await findings().allTextContents();
    await page.reload();
    await waitForText(page, "diagnosis-note", "finding");
    const other = await openPage(browser, url);
    for (const each of [page, other.page]) {
      await waitForText(each, "diagnosis-note", "finding");
      expectEqual(JSON.stringify(await each.locator("#findings li").allTextContents()), JSON.stringify(texts));
    }
    await other.page.close();
    await page.click("#tab-element");
  });

  await step("an edit and a run make the findings old", async () => {
    await of("isolated-vertex").click();
    await waitForText(page, "element-facts", "Vertex 1000");
    await page.locator("#element-edits button", { hasText: "Remove" }).click();
    await waitForText(page, "diagnosis-note", "The graph has changed since this diagnosis.");
    // The buttons go when the page has the new structure, which may come after the note.
    await waitUntil(page, () => document.querySelectorAll("#findings [data-kind=free-component] button").length === 0);
    if (!(await page.textContent("#findings")).includes("1001")) fail("the findings are gone");
    await page.click("#diagnose");
    await waitUntil(page, () => document.querySelectorAll("#findings li[data-kind=isolated-vertex]").length === 0);
    await waitUntil(page, () => !document.getElementById("diagnosis-note").textContent.includes("changed"));
    await page.click("#optimize");
    await waitForStatus(page, "converged");
    await waitForText(page, "diagnosis-note", "The estimates have changed since this diagnosis.");
  });

  await step("no error and no request to another host", () => {
    if (problems.length > 0) fail(problems.join("; "));
  });
});
