// SPDX-License-Identifier: BSD-3-Clause
// Small and large windows in both themes: nothing is cut off or covered, and everything can be read.
//
//     node test/view_looks.mjs PATH_TO_BOXPLUS DATA_FOLDER      exit code 77: something is missing, so the test is skipped
import { dataFile, fail, openPage, runTest, step, waitForStatus } from "./support.mjs";
import { contrast } from "./unit/colors.mjs";

/** Width, height and pixels per unit of length. */
const WINDOWS = [[420, 800, 1], [900, 600, 1], [1024, 640, 1], [1280, 720, 1], [1280, 720, 2], [3840, 2160, 1]];
const LEAST_TAB = 0.3;
const LEAST_TEXT = 4.5, LEAST_BORDER = 3;

await runTest(dataFile("posegraph3d/smallGrid3D.g2o"), async (url, browser) => {
  for (const [width, height, scale] of WINDOWS) {
    const { page, problems } = await openPage(browser, url, { viewport: { width, height }, deviceScaleFactor: scale });
    await page.click("#optimize");
    await waitForStatus(page, "converged");
    for (const theme of ["light", "dark"]) {
      await page.emulateMedia({ colorScheme: theme });
      await page.locator(`html[data-theme=${theme}]`).waitFor();
      const where = `at ${width} × ${height} × ${scale} in the ${theme} theme`;

      await step(`${where}, no control is outside of the window or covered`, async () => {
        const hidden = await page.evaluate(hiddenControls);
        if (hidden.length > 0) fail(hidden.join(", "));
      });

      await step(`${where}, the tabs have at least 30 % of the height`, async () => {
        const { height: tab_height } = await page.locator("[role=tabpanel]:not([hidden])").boundingBox();
        if (tab_height < LEAST_TAB * height) fail(`they have ${tab_height} of ${height} pixels`);
      });

      for (const tab of ["display", "settings", "iterations", "log", "element"]) {
        await step(`${where}, all of the tab ${tab} can be read`, async () => {
          await page.click(`#tab-${tab}`);
          const { texts, borders } = await page.evaluate(colorsInUse);
          if (texts.length < 20 || borders.length < 5) fail(`found only ${texts.length} texts and ${borders.length} borders`);
          expectContrast(texts, LEAST_TEXT);
          expectContrast(borders, LEAST_BORDER);
        });
      }
    }
    await step("no error and no request to another host", () => {
      if (problems.length > 0) fail(problems.join("; "));
    });
    await page.close();
  }
});

function expectContrast(pairs, least) {
  for (const { name, color, background } of pairs) {
    const found = contrast(rgb(color), rgb(background));
    if (found < least) fail(`the contrast of ${name} is ${found.toFixed(2)}`);
  }
}

/** From "rgb(1, 2, 3)". */
function rgb(text) {
  return text.match(/\d+/g).slice(0, 3).map((value) => Number(value) / 255);
}

/** Runs in the page: what lies outside of the window, or has something else at its center. The tabs may scroll. */
function hiddenControls() {
  const places = "header *, #tools *, #hint, #time-line *, #run *, #tabs *";
  const shown = [...document.querySelectorAll(places)].filter((element) =>
    element.checkVisibility({ visibilityProperty: true }) && element.matches("button, input, output, p, h1, span:not(.space)"));
  return shown.filter((element) => {
    const { left, right, top, bottom, width, height } = element.getBoundingClientRect();
    if (width === 0 || height === 0) return false;
    const has_ellipsis = getComputedStyle(element).textOverflow === "ellipsis";
    const is_cut_off = !has_ellipsis && element.clientWidth > 0 && element.scrollWidth > element.clientWidth + 1;
    if (left < 0 || top < 0 || right > innerWidth || bottom > innerHeight || is_cut_off) return true;
    if (getComputedStyle(element).pointerEvents === "none") return false;
    const on_top = document.elementFromPoint((left + right) / 2, (top + bottom) / 2);
    return !element.contains(on_top) && !on_top.contains(element);
  }).map((element) => element.id || element.textContent);
}

/** Runs in the page: the colors of visible texts and of the borders of controls, with what is behind them. */
function colorsInUse() {
  const behind = (element) => {
    for (let at = element; at; at = at.parentElement) {
      const color = getComputedStyle(at).backgroundColor;
      if (!/, 0\)$/.test(color)) return color;
    }
    return "rgb(255, 255, 255)";
  };
  const name = (element) => element.id || element.textContent.trim() || element.className;
  const isEnabled = (element) => element.closest(":disabled, .disabled") === null;
  const hasText = (element) => [...element.childNodes].some((node) =>
    node.nodeType === Node.TEXT_NODE && node.textContent.trim() !== "");
  const shown = [...document.body.querySelectorAll("*")].filter((element) =>
    element.checkVisibility({ visibilityProperty: true }) && isEnabled(element));
  const texts = shown.filter(hasText);
  const with_border = "button:not(.quiet, [role=tab], .primary), select, input:not([type=range], [type=checkbox])";
  const bordered = shown.filter((element) => element.matches(with_border));
  return {
    texts: texts.map((element) => (
      { name: name(element), color: getComputedStyle(element).color, background: behind(element) })),
    borders: bordered.map((element) => ({
      name: `the border of ${name(element)}`,
      color: getComputedStyle(element).borderTopColor,
      background: behind(element.parentElement),
    })),
  };
}
