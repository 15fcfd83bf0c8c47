// SPDX-License-Identifier: BSD-3-Clause
// Shows where H and L have blocks.
//
//     node test/view_pattern.mjs PATH_TO_BOXPLUS DATA_FOLDER    exit code 77: something is missing, so the test is skipped
import { expectEqual, fail, openPage, runTest, simulatedFile, step, textOf, waitUntil } from "./support.mjs";

await runTest(simulatedFile("manhattan", "--poses", "700"), async (url, browser) => {
  const { page, problems } = await openPage(browser, url);

  await step("the dialog has four pictures and their numbers of blocks", async () => {
    await page.click("#show-pattern");
    await page.locator("dialog#pattern[open]").waitFor();
    const note = await textOf(page, "pattern-note");
    expectEqual(note, "699 vertices move; each has a row of blocks. A cell has 1.37 rows.");
    const pictures = await page.evaluate(() => [...document.querySelectorAll("#pattern figure")].map((figure) => {
      const canvas = figure.querySelector("canvas"), { width, height } = canvas;
      const { data } = canvas.getContext("2d").getImageData(0, 0, width, height);
      const isDrawn = (x, y) => data[4 * (y * width + x) + 3] > 0;
      let above = 0, below = 0, diagonal = 0;
      for (let y = 0; y < height; ++y) {
        for (let x = 0; x < width; ++x) if (isDrawn(x, y)) x > y ? ++above : x < y ? ++below : ++diagonal;
      }
      return { text: figure.textContent, width, above, below, diagonal };
    }));
    expectEqual(pictures.length, 4);
    for (const { text, width, above, below, diagonal } of pictures) {
      expectEqual(width, 512);
      expectEqual(diagonal, 512);
      if (below < 100 || above !== (text.startsWith("H") ? below : 0)) fail(`${text}: ${above} cells above the diagonal, ${below} below`);
    }
    const blocks = pictures.map(({ text }) => Number(/: ([0-9,]+) blocks$/.exec(text)[1].replaceAll(",", "")));
    expectEqual(blocks[0], blocks[1]);
    if (!(blocks[2] > blocks[3] && blocks[3] > blocks[1])) fail(`the numbers of blocks are ${blocks}`);
  });

  await step("the dialog closes", async () => {
    await page.click("#pattern button");
    await waitUntil(page, () => !document.getElementById("pattern").open);
  });

  await step("no error and no request to another host", () => {
    if (problems.length > 0) fail(problems.join("; "));
  });
});
