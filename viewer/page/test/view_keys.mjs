// SPDX-License-Identifier: BSD-3-Clause
// Works with the page by keys alone.
//
//     node test/view_keys.mjs PATH_TO_BOXPLUS DATA_FOLDER       exit code 77: something is missing, so the test is skipped
import {
  dataFile, downloadFrom, expectEqual, fail, openPage, picture, pictureAtRest, runTest, step, textOf, waitForPicture,
  waitForStatus, waitForText,
} from "./support.mjs";

await runTest(dataFile("posegraph3d/smallGrid3D.g2o"), async (url, browser) => {
  const { page, problems } = await openPage(browser, url);
  const press = (...keys) => keys.reduce((before, key) => before.then(() => page.keyboard.press(key)), Promise.resolve());
  const initial = await textOf(page, "chi2");

  await step("o optimizes, Shift+R resets", async () => {
    await press("o");
    await waitForStatus(page, "converged");
    await waitForText(page, "time-text", await textOf(page, "chi2"));
    await press("r");
    await press("Shift+R");
    await waitForText(page, "time-text", `Iteration 0, chi2 ${initial}`);
    await press("o");
    await waitForStatus(page, "converged");
  });

  await step("keys go through the time line", async () => {
    await press("<");
    await waitForText(page, "time-text", "Iteration 0 of ");
    await press(".");
    if ((await textOf(page, "time-text")).startsWith("Iteration 0 ")) fail("the next iteration is not shown");
    await press(",");
    await waitForText(page, "time-text", "Iteration 0 of ");
    await press(">");
    await waitForText(page, "time-text", await textOf(page, "chi2"));
  });

  await step("the picture turns, moves and zooms by keys", async () => {
    await press("f");
    let before = await pictureAtRest(page);
    await page.focus("#scene");
    for (const key of ["ArrowLeft", "Shift+ArrowLeft", "Shift+ArrowUp", "+", "-", "t", "b", "ArrowUp", "f"]) {
      await press(key);
      const after = await pictureAtRest(page);
      if (after.hash === before.hash) fail(`${key} does not change the picture`);
      before = after;
    }
  });

  await step("buttons zoom, too", async () => {
    const { distance } = await camera(page);
    await page.click("#zoom-in");
    if (!((await camera(page)).distance < distance)) fail("the camera is not nearer");
    await page.click("#zoom-out");
    expectEqual((await camera(page)).distance.toFixed(6), distance.toFixed(6));
  });

  await step("the view from above has y up", async () => {
    await press("t");
    const { direction } = await camera(page);
    if (!(direction[2] > 0.9999 && direction[1] <= 0)) fail(`the camera is in the direction ${direction}`);
  });

  await step("i saves the picture", async () => {
    expectEqual((await downloadFrom(page, () => press("i"))).name, "smallGrid3D.png");
  });

  await step("numbers choose tabs", async () => {
    for (const [i, tab] of ["display", "settings", "iterations", "log", "element"].entries()) {
      await press(String(i + 1));
      if (!(await page.isVisible(`#${tab}`))) fail(`${tab} is not visible`);
    }
    await press("1");
  });

  await step("the theme changes, and survives a reload", async () => {
    const background = () => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
    const light = await background(), light_picture = await picture(page);
    await press("d");
    if ((await background()) === light) fail("the background of the page is the same");
    if ((await picture(page)).hash === light_picture.hash) fail("the picture is the same");
    const dark = await background();
    await page.reload();
    await waitForPicture(page);
    expectEqual(await background(), dark);
    await press("d");
    expectEqual(await background(), light);
  });

  await step("? shows all keys, and they do nothing behind the sheet", async () => {
    await press("?");
    if (!(await page.isVisible("#help"))) fail("the sheet is not visible");
    await page.locator("#help kbd", { hasText: "Shift + R" }).waitFor();
    await press("h");
    if (!(await page.isVisible("#panel"))) fail("the panel is hidden");
    await press("Escape");
    if (await page.isVisible("#help")) fail("the sheet is visible");
    await press("h");
    if (await page.isVisible("#panel")) fail("the panel is visible");
    await press("h");
  });

  await step("letters that are typed into a field do nothing else", async () => {
    const theme = () => page.getAttribute("html", "data-theme");
    const before = await theme();
    await page.focus("#iterations-limit input");
    await press("d");
    expectEqual(await theme(), before);
    await page.focus("#color-mode");
    await press("d");
    expectEqual(await theme(), before);
  });

  await step("Tab reaches every control, and shows where it is", async () => {
    const wanted = await page.evaluate(controls);
    const reached = new Set();
    await page.evaluate(() => document.activeElement.blur());
    for (let i = 0; i < 3 * wanted.length; ++i) {
      await press("Tab");
      const { name, outline } = await page.evaluate(focused);
      if (name !== "BODY" && outline === "none") fail(`${name} does not show that it has the focus`);
      reached.add(name);
    }
    const missed = wanted.filter((name) => !reached.has(name));
    if (missed.length > 0) fail(`Tab does not reach ${missed.join(", ")}`);
  });

  await step("no error and no request to another host", () => {
    if (problems.length > 0) fail(problems.join("; "));
  });
});

/** Runs in the page: the ids of the controls that can be used now. The tabs are one control. */
function controls() {
  const all = [...document.querySelectorAll("button, input, select, #scene")];
  const usable = all.filter((element) => !element.disabled && element.checkVisibility({ visibilityProperty: true }) &&
    !(element.role === "tab" && element.ariaSelected !== "true"));
  return usable.map((element) => element.id || element.getAttribute("aria-label") || element.textContent);
}

/** Runs in the page. */
function focused() {
  const element = document.activeElement;
  const name = element.id || element.getAttribute("aria-label") || (element === document.body ? "BODY" : element.textContent);
  return { name, outline: getComputedStyle(element).outlineStyle };
}

/** Where the camera is relative to its target. */
async function camera(page) {
  const { position, target } = await page.evaluate(() => window.boxplus.view.camera);
  const offset = position.map((value, i) => value - target[i]);
  const distance = Math.hypot(...offset);
  return { distance, direction: offset.map((value) => value / distance) };
}
