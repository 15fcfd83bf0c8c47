// SPDX-License-Identifier: BSD-3-Clause
// A browser may take the graphics card away from the page, and give it back: the picture is then as before.
//
//     node test/view_context.mjs PATH_TO_BOXPLUS DATA_FOLDER      exit code 77: something is missing, so the test is skipped
import { dataFile, expectEqual, openPage, pictureAtRest, runTest, step, waitUntil } from "./support.mjs";

await runTest(dataFile("posegraph2d/intel_1728.g2o"), async (url, browser) => {
  for (const theme of ["light", "dark"]) {
    await step(`a restored WebGL context has the ${theme} background, and the same picture`, async () => {
      const { page } = await openPage(browser, url, { colorScheme: theme });
      const before = await pictureAtRest(page), background = await corner(page);
      await page.evaluate(async () => {
        const canvas = document.getElementById("scene");
        const event = (name) => new Promise((resolve) => canvas.addEventListener(name, resolve, { once: true }));
        const context = canvas.getContext("webgl2").getExtension("WEBGL_lose_context");
        const lost = event("webglcontextlost");
        context.loseContext();
        await lost;
        const restored = event("webglcontextrestored");
        setTimeout(() => context.restoreContext());
        await restored;
      });
      await waitUntil(page, () => !document.getElementById("scene").getContext("webgl2").isContextLost());
      expectEqual(await corner(page), background);
      expectEqual((await pictureAtRest(page)).hash, before.hash);
      await page.close();
    });
  }
});

/** The color of the first pixel. */
function corner(page) {
  return page.evaluate(() => window.boxplus.view.pixels().slice(0, 3).join());
}
