// SPDX-License-Identifier: BSD-3-Clause
// The page that `boxplus plot` writes: one file, opened without a server, shows the same picture as `boxplus view`.
//
//     node test/view_export.mjs PATH_TO_BOXPLUS DATA_FOLDER     exit code 77: something is missing, so the test is skipped
import { execFileSync } from "node:child_process";
import { dirname, join } from "node:path";
import { pathToFileURL } from "node:url";
import {
  downloadFrom, expectEqual, fail, openPage, pictureAtRest, runTest, simulatedFile, step, textOf,
} from "./support.mjs";

let exported = "";

function makeFile(boxplus) {
  const graph = simulatedFile("sphere", "--poses", "200")(boxplus);
  exported = join(dirname(graph), "graph.html");
  execFileSync(boxplus, ["plot", graph, "-o", exported], { stdio: ["ignore", "ignore", "inherit"] });
  return graph;
}

await runTest(makeFile, async (url, browser) => {
  const live = await openPage(browser, url);
  const file = await openPage(browser, pathToFileURL(exported).href);
  const { page } = file;

  await step("the file shows the same picture as the server", async () => {
    const picture = await pictureAtRest(page);
    if (picture.drawn < 1000) fail(`only ${picture.drawn} pixels are drawn`);
    expectEqual(picture.hash, (await pictureAtRest(live.page)).hash);
    for (const id of ["file", "counts", "chi2", "time-text"]) expectEqual(await textOf(page, id), await textOf(live.page, id));
  });

  await step("what needs a server is not shown", async () => {
    for (const id of ["status", "open", "save", "optimize", "guess", "chart", "tab-settings", "tab-log", "tab-element", "play", "record"]) {
      if (!await live.page.locator(`#${id}`).isVisible()) fail(`the server's page has no ${id}`);
      if (await page.locator(`#${id}`).isVisible()) fail(`the file's page has ${id}`);
    }
    if (await page.locator("#connection-error").isVisible()) fail("the file's page misses a server");
  });

  await step("keys and the help know nothing of a server", async () => {
    await page.keyboard.press("?");
    const help = await textOf(page, "help-keys");
    if (!help.includes("Show the whole graph") || /Optimize|Tab Log|Play/.test(help)) fail(help);
    await page.keyboard.press("Escape");
    await page.keyboard.press("o");
  });

  await step("the display, the camera and the theme work", async () => {
    for (const change of [() => page.selectOption("#color-mode", "degree"), () => page.click("#from-above"), () => page.keyboard.press("d")]) {
      const before = await pictureAtRest(page);
      await change();
      if ((await pictureAtRest(page)).hash === before.hash) fail(`${change} does not change the picture`);
    }
  });

  await step("the picture can be saved", async () => {
    const { name, bytes } = await downloadFrom(page, () => page.keyboard.press("i"));
    expectEqual(name, "graph.png");
    if (bytes.length < 1000) fail(`the picture has ${bytes.length} bytes`);
  });

  await step("no error and no request to another host", () => {
    const problems = [...live.problems, ...file.problems];
    if (problems.length > 0) fail(problems.join("; "));
  });
});
