// SPDX-License-Identifier: BSD-3-Clause
// Opens and saves files on the page, and optimizes with settings.
//
//     node test/view_files.mjs PATH_TO_BOXPLUS DATA_FOLDER      exit code 77: something is missing, so the test is skipped
import { readFileSync } from "node:fs";
import { basename, join } from "node:path";
import {
  dataFile, downloadFrom, expectEqual, fail, openPage, runTest, step, textOf, waitForStatus, waitForText, waitUntil,
} from "./support.mjs";

const DATA = process.argv[3] ?? "";
const RECONSTRUCTION = join(DATA, "bal/problem-49-7776-pre.txt");
const POSE_GRAPH = join(DATA, "posegraph2d/csail.g2o");
const CHI2_INITIAL = "551.735731";
const MALFORMED = "VERTEX_SE2 0 0 0 0\nVERTEX_SE2 1 1 zero 0\nEDGE_SE2 0 1 1 0 0 1 0 0 1 0 1\n";

await runTest(dataFile("posegraph2d/intel_1728.g2o"), async (url, browser) => {
  const { page, problems } = await openPage(browser, url);

  await step("a setting changes the method of the run", async () => {
    await page.click("#tab-settings");
    await page.selectOption("#setting-algorithm", "dogleg");
    await page.fill("#setting-iterations", "50");
    await optimize(page, "converged");
    await expectInReport(page, /method +dogleg/);
    expectEqual(await textOf(page, "tab-settings"), "Settings (1)");
    if (await page.evaluate(() => document.documentElement.scrollHeight > innerHeight)) fail("the page is too high");
  });

  await step("settings survive a reload, and a reset forgets them", async () => {
    await page.reload();
    await waitForStatus(page, "converged");
    await page.click("#tab-settings");
    expectEqual(await page.inputValue("#setting-algorithm"), "dogleg");
    expectEqual(await page.inputValue("#setting-iterations"), "50");
    await page.click("#reset-settings");
    expectEqual(await page.inputValue("#setting-algorithm"), "automatic");
    expectEqual(await page.inputValue("#setting-iterations"), "100");
  });

  await step("a setting is enabled if the one that it needs is chosen", async () => {
    if (await page.isEnabled("#setting-kernel-width")) fail("the width of no kernel is enabled");
    await page.selectOption("#setting-kernel", "Barron");
    if (!(await page.isEnabled("#setting-kernel-width"))) fail("the width of a kernel is disabled");
    await page.fill("#setting-kernel-parameter", "-2");
    await page.fill("#setting-kernel-width", "3");
    await optimize(page, "converged");
    await expectInReport(page, /2512 edges have a kernel/);
  });

  await step("the page shows why the server refuses a setting", async () => {
    await page.fill("#setting-kernel-width", "wide");
    await page.click("#optimize");
    await waitForText(page, "command-error", "expected a number > 0, got 'wide'");
    await page.click("#command-error button");
    await page.click("#reset-settings");
  });

  await step("an initial guess, chosen with the keyboard, changes the estimates", async () => {
    await optimize(page, "converged"); // without the kernel
    await page.click("#reset");
    await waitForText(page, "chi2", CHI2_INITIAL);
    await waitUntil(page, () => !document.querySelector("#guess").disabled);
    await page.focus("#guess");
    for (const key of ["Enter", "ArrowDown", "Home", "Enter"]) await page.keyboard.press(key);
    await waitUntil(page, (chi2) => {
      return document.querySelector("#chi2").textContent !== chi2 && !document.querySelector("#optimize").disabled;
    }, CHI2_INITIAL);
  });

  await step("the dialog opens another file", async () => {
    const dialog = page.waitForEvent("filechooser");
    await page.click("#open");
    await (await dialog).setFiles(RECONSTRUCTION);
    await waitForFile(page, basename(RECONSTRUCTION));
    expectEqual(await textOf(page, "counts"), "7,825 vertices · 31,843 edges · 3-D");
  });

  await step("an unsuitable choice is disabled, and says why", async () => {
    const option = page.locator("#setting-start option[value=odometry]");
    if (!(await option.evaluate((element) => element.disabled))) fail("the initial guess from odometry can be chosen");
    if (!/relative pose/.test(await option.textContent())) fail(`its text is "${await option.textContent()}"`);
    await page.click("#guess");
    expectEqual(await page.getAttribute("#guess-odometry", "aria-disabled"), "true");
    await page.keyboard.press("Escape");
  });

  await step("a file that is dropped on the window opens", async () => {
    await drag(page, "dragenter", POSE_GRAPH);
    if (await page.isHidden("#drop")) fail("the window does not show that it takes the file");
    await drag(page, "drop", POSE_GRAPH);
    await waitForFile(page, basename(POSE_GRAPH));
    if (await page.isVisible("#drop")) fail("the window still waits for the file");
  });

  await step("a malformed file shows its message with line and column, and the graph stays", async () => {
    await drag(page, "drop", "broken.g2o", MALFORMED);
    await waitForText(page, "file-error", "broken.g2o:2:16: ");
    expectEqual(await textOf(page, "file"), basename(POSE_GRAPH));
    await page.click("#file-error button");
    if (await page.isVisible("#file-error")) fail("the message cannot be dismissed");
  });

  await step("the saved graph has the estimates of the page", async () => {
    await optimize(page, "converged");
    await page.click("#save");
    const { name, bytes } = await downloadFrom(page, () => page.click("#save-g2o"));
    expectEqual(name, basename(POSE_GRAPH));
    const lines = bytes.toString().split("\n").filter((line) => line.startsWith("VERTEX_SE2 "));
    const given = readFileSync(POSE_GRAPH, "utf8").split("\n").filter((line) => line.startsWith("VERTEX_SE2 "));
    expectEqual(lines.length, given.length);
    if (!/^VERTEX_SE2 0( [-+.e0-9]+){3}$/.test(lines[0])) fail(`the first vertex is "${lines[0]}"`);
    if (lines[lines.length - 1] === given[given.length - 1]) fail("the estimates are those of the file");
    await waitUntil(page, () => !document.querySelector("#open").disabled); // while the graph is written, no file opens
    await drag(page, "drop", "saved.g2o", bytes.toString());
    const chi2 = await textOf(page, "chi2");
    await waitForFile(page, "saved.g2o");
    if (Math.abs(Number(await textOf(page, "chi2")) / Number(chi2) - 1) > 1e-6) fail("chi2 of the saved graph differs");
  });

  await step("no error and no request to another host", () => {
    const others = problems.filter((problem) => !problem.includes("status of 400")); // the setting that was refused
    if (others.length > 0) fail(others.join("; "));
  });
});

async function optimize(page, status) {
  await waitUntil(page, () => !document.querySelector("#optimize").disabled);
  const number = await page.evaluate(() => window.boxplus.model.run?.number ?? 0);
  await page.click("#optimize");
  await waitUntil(page, (before) => (window.boxplus.model.run?.number ?? 0) > before, number);
  await waitForStatus(page, status);
}

async function expectInReport(page, pattern) {
  const report = await textOf(page, "summary");
  if (!pattern.test(report)) fail(`the report has no ${pattern}:\n${report}`);
}

async function waitForFile(page, name) {
  await waitForText(page, "file", name);
  await waitUntil(page, () => {
    const { model, view } = window.boxplus;
    return !model.isBusy && view.chi2 === model.state.chi2;
  });
}

/** Sends an event of drag and drop with a file; its content is that of the file on disk, unless it is given. */
async function drag(page, type, file, content = readFileSync(file, "utf8")) {
  const dataTransfer = await page.evaluateHandle(([name, text]) => {
    const data = new DataTransfer();
    data.items.add(new File([text], name));
    return data;
  }, [basename(file), content]);
  await page.dispatchEvent("#view", type, { dataTransfer });
}
