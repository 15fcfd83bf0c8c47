// SPDX-License-Identifier: BSD-3-Clause
// Colors, images, recordings and cameras of the page.
//
//     node test/view_picture.mjs PATH_TO_BOXPLUS DATA_FOLDER    exit code 77: something is missing, so the test is skipped
import {
  dataFile, downloadFrom, expectEqual, fail, openPage, picture, pictureAtRest, runTest, step, waitForPicture, waitForStatus,
  waitForText, waitUntil,
} from "./support.mjs";

const PNG_SIGNATURE = "89504e470d0a1a0a";

await runTest(dataFile("posegraph3d/smallGrid3D.g2o"), async (url, browser) => {
  const { page, problems } = await openPage(browser, url);
  const before = await picture(page);

  await step("colors and the background survive a reload", async () => {
    await page.fill("#color-vertices-0", "#ff0000");
    const colored = await picture(page);
    if (colored.hash === before.hash) fail("the color of poses does not change the picture");
    await page.fill("#background", "#ffffff");
    const bright = await picture(page);
    if (bright.hash === colored.hash) fail("the background does not change the picture");
    await page.reload();
    await waitForPicture(page);
    expectEqual((await picture(page)).hash, bright.hash);
    await page.click("#reset-display");
    expectEqual((await picture(page)).hash, before.hash);
  });

  await step("colors tell degrees and components, with a legend", async () => {
    const legend = () => page.locator("#legend .type-row").allInnerTexts();
    expectEqual((await legend()).length, 0);
    await page.selectOption("#color-mode", "degree");
    const degrees = await picture(page);
    if (degrees.hash === before.hash) fail("the degrees do not change the picture");
    const counts = (await legend()).map((text) => Number(/(\d+)\s*$/.exec(text)[1]));
    expectEqual(counts.reduce((sum, each) => sum + each, 0), 125);
    const colors = () => page.locator("#legend .swatch").evaluateAll((signs) =>
      signs.map((sign) => sign.style.background).join());
    const light_colors = await colors();
    await page.click("#toggle-theme");
    if ((await colors()) === light_colors) fail("the legend has the same colors in the dark theme");
    await page.click("#toggle-theme");
    expectEqual(await colors(), light_colors);
    await page.selectOption("#color-mode", "component");
    if ((await picture(page)).hash === degrees.hash) fail("the components do not change the picture");
    expectEqual((await legend()).join().replace(/\s+/g, " ").trim(), "Component 1 125");
    await page.selectOption("#color-mode", "type");
    expectEqual((await picture(page)).hash, before.hash);
  });

  await step("the picture is saved as it is seen", async () => {
    await page.click("#picture");
    const { name, bytes } = await downloadFrom(page, () => page.click("#save-picture"));
    expectEqual(name, "smallGrid3D.png");
    expectEqual(bytes.subarray(0, 8).toString("hex"), PNG_SIGNATURE);
    const size = await page.evaluate(() => [document.querySelector("#scene").width, document.querySelector("#scene").height]);
    expectEqual(`${bytes.readUInt32BE(16)} × ${bytes.readUInt32BE(20)}`, size.join(" × "));
    const colors = await colorsOf(page, bytes);
    if (colors < 10) fail(`the image has only ${colors} colors`);
  });

  await step("a recording has an image of each frame", async () => {
    await page.click("#record");
    await page.click("#optimize");
    await waitForStatus(page, "converged");
    await waitUntil(page, () => window.boxplus.view.chi2 === window.boxplus.model.state.chi2);
    const { name, bytes } = await downloadFrom(page, () => page.click("#record"));
    expectEqual(name, "smallGrid3D-images.zip");
    const images = bytes.readUInt16LE(bytes.length - 22 + 10);
    if (images < 2) fail(`there are ${images} images`);
    expectEqual(bytes.subarray(30, 44).toString(), "image-0001.png");
    expectEqual(bytes.subarray(44, 52).toString("hex"), PNG_SIGNATURE);
  });

  await step("the estimates of the file are shown under the current ones", async () => {
    await page.click("#fit");
    const without = await picture(page);
    await page.check("#show-initial");
    if (!((await picture(page)).drawn > without.drawn)) fail("the picture shows no more than before");
    await page.uncheck("#show-initial");
    expectEqual((await picture(page)).hash, without.hash);
  });

  await step("a page that was reloaded knows the estimates of the file", async () => {
    await page.reload();
    await waitForPicture(page);
    await page.check("#show-initial");
    await waitUntil(page, () => window.boxplus.view.knowsInitial);
    await waitUntil(page, () => document.querySelector("#initial-unknown").hidden);
    await page.uncheck("#show-initial");
  });

  await step("a saved camera shows the same picture again", async () => {
    await page.focus("#scene");
    for (const key of ["+", "ArrowLeft", "ArrowUp"]) await page.keyboard.press(key);
    const seen = await pictureAtRest(page);
    await page.click("#picture");
    const { bytes } = await downloadFrom(page, () => page.click("#save-camera"));
    await page.click("#fit");
    if ((await pictureAtRest(page)).hash === seen.hash) fail("Fit does not change the picture");
    await loadCamera(page, "camera.json", bytes);
    await waitUntil(page, (wanted) => {
      const { position } = window.boxplus.view.camera;
      return wanted.every((value, i) => Math.abs(value - position[i]) < 1e-6);
    }, JSON.parse(bytes).position);
    const again = await pictureAtRest(page);
    if (Math.abs(again.drawn / seen.drawn - 1) > 0.01) fail(`${again.drawn} pixels are drawn, not ${seen.drawn}`);
    await loadCamera(page, "other.json", Buffer.from("{}"));
    await waitForText(page, "command-error", "other.json was not loaded: it is not a file that “Save camera” made.");
  });

  await step("no error and no request to another host", () => {
    if (problems.length > 0) fail(problems.join("; "));
  });
});

async function loadCamera(page, name, buffer) {
  const dialog = page.waitForEvent("filechooser");
  await page.click("#picture");
  await page.click("#load-camera");
  await (await dialog).setFiles({ name, mimeType: "application/json", buffer });
}

/** The number of colors of an image. */
function colorsOf(page, bytes) {
  return page.evaluate(async (numbers) => {
    const image = await createImageBitmap(new Blob([new Uint8Array(numbers)], { type: "image/png" }));
    const canvas = new OffscreenCanvas(image.width, image.height).getContext("2d");
    canvas.drawImage(image, 0, 0);
    const pixels = new Uint32Array(canvas.getImageData(0, 0, image.width, image.height).data.buffer);
    return new Set(pixels).size;
  }, [...bytes]);
}
