// SPDX-License-Identifier: BSD-3-Clause
// Shows the truth under the estimates, and how far they are from it.
//
//     node test/view_truth.mjs PATH_TO_BOXPLUS DATA_FOLDER      exit code 77: something is missing, so the test is skipped
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { basename, join } from "node:path";
import {
  downloadFrom, expectEqual, fail, openPage, picture, pictureAtRest, runTest, step, textOf, waitForStatus, waitForText, waitUntil,
} from "./support.mjs";

const BOXPLUS = process.argv[2];
const folder = mkdtempSync(join(tmpdir(), "boxplus-"));
process.on("exit", () => rmSync(folder, { recursive: true }));
const GRAPH = join(folder, "graph.g2o"), TRUTH = join(folder, "truth.g2o");

for (const world of ["manhattan", "sphere"]) {
  const simulated = () => {
    execFileSync(BOXPLUS, ["simulate", world, "--poses", "400", "-o", GRAPH, "--truth", TRUTH], { stdio: "ignore" });
    return GRAPH;
  };

  await runTest(simulated, async (url, browser) => {
    const { page, problems } = await openPage(browser, url);
    const without = await pictureAtRest(page);

    await step(`${world}: a file that is opened as truth shows ATE and RPE`, async () => {
      if (await page.isVisible("#truth-errors")) fail("there are errors without a truth");
      await openTruth(page, TRUTH);
      await waitForText(page, "truth-note", "truth.g2o: 400 of 400 poses match by id.");
      await expectErrors(page, GRAPH);
      const { hash } = await pictureAtRest(page);
      if (hash === without.hash) fail("the truth is not drawn");
      await page.click("#fit");
    });

    await step("the truth can be hidden", async () => {
      const shown = await picture(page);
      await page.click("#show-truth");
      await page.click("#fit");
      expectEqual((await picture(page)).hash, without.hash);
      await page.click("#show-truth");
      await page.click("#fit");
      expectEqual((await picture(page)).hash, shown.hash);
    });

    await step("Fit shows all of the truth", async () => {
      const size = () => page.evaluate(() => {
        const { kind, height, position, target } = window.boxplus.view.camera;
        return kind === "orthographic" ? height : Math.hypot(...position.map((value, i) => value - target[i]));
      });
      const before = await size();
      const vast = join(folder, "vast.g2o");
      // The positions come after the tag and the id.
      writeFileSync(vast, readFileSync(TRUTH, "utf8").replace(/^(VERTEX\S* \d+) (\S+) (\S+)/gm, (_, begin, x, y) => `${begin} ${5 * x} ${5 * y}`));
      await openTruth(page, vast);
      await waitForText(page, "truth-note", "vast.g2o");
      await page.click("#fit");
      if (!((await size()) > 2 * before)) fail(`the size of the view is ${await size()}, and ${before} before`);
      await openTruth(page, TRUTH);
      await waitForText(page, "truth-note", "truth.g2o");
      await page.click("#fit");
    });

    await step("a long name of a truth does not widen the panel", async () => {
      const long = join(folder, `${"truth".repeat(40)}.g2o`);
      writeFileSync(long, readFileSync(TRUTH));
      await openTruth(page, long);
      await waitForText(page, "truth-note", "truthtruth");
      const [width, content] = await page.evaluate(() => {
        const { clientWidth, scrollWidth } = document.getElementById("display");
        return [clientWidth, scrollWidth];
      });
      expectEqual(content, width);
      await openTruth(page, TRUTH);
    });

    await step("a malformed file and one without a common pose are refused, and the truth stays", async () => {
      const before = await errors(page);
      const stranger = readFileSync(TRUTH, "utf8").match(/^VERTEX.*/m)[0].replace(" 0 ", " 9000 ");
      for (const [name, text, message] of [
        ["broken.g2o", "VERTEX_SE2 0 0 zero 0\n", "broken.g2o:1:16: "],
        ["strange.g2o", stranger, "expected poses that match graph.g2o by id"],
        ["times.txt", "1 0 0 0 0 0 0 1\n", "got a TUM file"],
      ]) {
        writeFileSync(join(folder, name), text);
        await openTruth(page, join(folder, name));
        await waitForText(page, "file-error", message);
        expectEqual(JSON.stringify(await errors(page)), JSON.stringify(before));
      }
      if (await page.isHidden("#truth-errors")) fail("the truth is gone");
      await openTruth(page, TRUTH);
      await waitUntil(page, () => document.getElementById("file-error").hidden);
    });

    await step("the errors fall after Optimize, and are those of the optimum", async () => {
      const before = (await errors(page)).ate;
      await page.click("#optimize");
      await waitForStatus(page, "converged");
      await waitUntil(page, (ate) => window.boxplus.view.shown.truth.ate_m < ate / 2, before);
      await page.click("#save");
      const { bytes } = await downloadFrom(page, () => page.click("#save-g2o"));
      writeFileSync(join(folder, "optimum.g2o"), bytes);
      await expectErrors(page, join(folder, "optimum.g2o"));
      await page.focus("#scene");
      await page.keyboard.press("<");
      await waitUntil(page, (ate) => window.boxplus.view.shown.truth.ate_m === ate, before);
      await page.keyboard.press(">");
    });

    await step("an edit keeps the truth of the other vertices", async () => {
      await page.click("#tab-element");
      await page.fill("#element-id", "150");
      await page.press("#element-id", "Enter");
      await page.click("#edit-remove");
      await waitForText(page, "counts", "399 vertices");
      await page.click("#tab-display");
      await waitForText(page, "truth-note", "truth.g2o: ");
      if ((await errors(page)).ate === null) fail("there is no ATE");
    });

    await step("another graph has no truth", async () => {
      const dialog = page.waitForEvent("filechooser");
      await page.click("#open");
      await (await dialog).setFiles(GRAPH);
      await waitUntil(page, () => document.getElementById("truth-errors").hidden);
      await waitForText(page, "counts", "400 vertices");
      expectEqual((await pictureAtRest(page)).hash, without.hash);
    });

    await step("no error and no request to another host", () => {
      if (problems.length > 0) fail(problems.join("; "));
    });
  });

  await runTest(simulated, async (url, browser) => {
    await step("--truth shows the truth from the beginning", async () => {
      const { page } = await openPage(browser, url);
      await waitForText(page, "truth-note", basename(TRUTH));
      await expectErrors(page, GRAPH);
    });
  }, () => ["--truth", TRUTH]);
}

async function openTruth(page, path) {
  await waitUntil(page, () => !document.querySelector("#open-truth").disabled);
  const dialog = page.waitForEvent("filechooser");
  await page.click("#open-truth");
  await (await dialog).setFiles(path);
  await waitUntil(page, () => !document.querySelector("#open-truth").disabled);
}

/** Those of the frame in the picture, with all their digits. */
async function errors(page) {
  return page.evaluate(() => {
    const { ate_m: ate, rpe_m, rpe_rad } = window.boxplus.view.shown.truth;
    return { ate, rpe_m, rpe_rad };
  });
}

/** The page must show what `boxplus compare` says of the file. */
async function expectErrors(page, file) {
  const { ate_m, rpe } = JSON.parse(execFileSync(BOXPLUS, ["compare", file, TRUTH, "--json", "-"]));
  await waitUntil(page, () => window.boxplus.view.shown.truth);
  const { ate, rpe_m, rpe_rad } = await errors(page);
  for (const [name, found, expected] of [["ATE", ate, ate_m.rmse], ["RPE", rpe_m, rpe.translation_m.rmse], ["RPE", rpe_rad, rpe.rotation_rad.rmse]]) {
    if (Math.abs(found / expected - 1) > 1e-12) fail(`the page's ${name} is ${found}, and that of compare is ${expected}`);
  }
  const [, shown] = /ATE \[m\] +\d+ +(\S+)/.exec(execFileSync(BOXPLUS, ["compare", file, TRUTH], { encoding: "utf8" }));
  expectEqual(await textOf(page, "ate"), `${Number(shown)}\u00a0m`);
  if (!/^[.e\d-]+\u00a0m, [.e\d-]+°$/.test(await textOf(page, "rpe"))) fail(`the RPE is "${await textOf(page, "rpe")}"`);
}
