// SPDX-License-Identifier: BSD-3-Clause
// What the end-to-end tests share: they start `boxplus view` and look at its page with chromium.
import { execFileSync, spawn } from "node:child_process";
import { accessSync, constants, mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { delimiter, join } from "node:path";
import { createInterface } from "node:readline";

const SKIPPED = 77;
/** WebGL 2 without a graphics card. */
const CHROMIUM_ARGUMENTS = ["--headless", "--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"];
/** The machine may be busy with other tests. */
export const PATIENCE_MS = 60_000;

export function skip(sentence) {
  console.log(`SKIPPED: ${sentence}`);
  process.exit(SKIPPED);
}

export function fail(sentence) {
  throw new Error(sentence);
}

/**
 * Runs a test whose arguments are the path of boxplus and the folder of the data. `makeFile` gets both, and returns the path of
 * the graph. `options` are further arguments of `boxplus view`.
 */
export async function runTest(makeFile, test, options = () => []) {
  const [boxplus, data] = process.argv.slice(2);
  if (!data) fail(`usage: node ${process.argv[1]} PATH_TO_BOXPLUS DATA_FOLDER`);
  const file = makeFile(boxplus, data);
  const browser = await startBrowser();
  let viewer;
  try {
    viewer = await startViewer(boxplus, file, ...options());
    await test(viewer.url, browser);
    await step("Ctrl-C ends the viewer with exit code 0", async () => {
      const code = await viewer.stop();
      if (code !== 0) fail(`the exit code is ${code}`);
    });
  } catch (error) {
    console.error(`FAILED: ${error.message}`);
    process.exitCode = 1;
  } finally {
    await browser.close();
    await viewer?.stop();
  }
}

/** For runTest(): the file of the data sets with this path. */
export function dataFile(file) {
  return (_, data) => {
    const path = join(data, file);
    if (!isReadable(path)) skip(`the data file ${path} is missing`);
    return path;
  };
}

/** For runTest(): the graph that `boxplus simulate` makes with these arguments, in a folder that is deleted at the end. */
export function simulatedFile(...args) {
  return (boxplus) => {
    const folder = mkdtempSync(join(tmpdir(), "boxplus-"));
    process.on("exit", () => rmSync(folder, { recursive: true }));
    const path = join(folder, "graph.g2o");
    execFileSync(boxplus, ["simulate", ...args, "-o", path], { stdio: ["ignore", "ignore", "inherit"] });
    return path;
  };
}

export function expectEqual(actual, expected) {
  if (actual !== expected) fail(`expected "${expected}", found "${actual}"`);
}

export async function step(sentence, action) {
  try {
    await action();
  } catch (error) {
    throw new Error(`${sentence}: ${error.message}`);
  }
  console.log(`ok: ${sentence}`);
}

/** Waits until `condition` is true in the page. */
export async function waitUntil(page, condition, argument) {
  await page.waitForFunction(condition, argument, { timeout: PATIENCE_MS });
}

/** A page that notes each error and each request to another host in `problems`. */
export async function openPage(browser, url, options = {}) {
  const page = await browser.newPage({ viewport: { width: 1280, height: 720 }, ...options });
  const problems = [];
  page.setDefaultTimeout(PATIENCE_MS);
  page.on("console", (message) => {
    if (message.type() === "error") problems.push(`console: ${message.text()}`);
  });
  page.on("pageerror", (error) => problems.push(`error: ${error.message}`));
  page.on("request", (request) => {
    const { protocol, origin } = new URL(request.url());
    if (protocol.startsWith("http") && origin !== new URL(url).origin) problems.push(`request to ${request.url()}`);
  });
  await page.goto(url);
  await waitForPicture(page);
  return { page, problems };
}

export async function waitForPicture(page) {
  await waitUntil(page, () => window.boxplus.view.pictures > 0);
}

/** The text of the element with this id. */
export function textOf(page, id) {
  return page.locator(`#${id}`).textContent();
}

export async function waitForText(page, id, part) {
  await waitUntil(page, ([element, wanted]) => document.getElementById(element).textContent.includes(wanted), [id, part]);
}

/** Carries out the action, and returns the file that the page then offers. */
export async function downloadFrom(page, action) {
  const download = page.waitForEvent("download");
  await action();
  const file = await download;
  return { name: file.suggestedFilename(), bytes: readFileSync(await file.path()) };
}

export async function waitForStatus(page, status) {
  await waitUntil(page, (wanted) => document.querySelector("#status").dataset.status === wanted, status);
}

/** A number that differs if the pictures differ, and the number of pixels that are not background. */
export function picture(page) {
  return page.evaluate(() => {
    const pixels = new Uint32Array(window.boxplus.view.pixels().buffer);
    let hash = 0, drawn = 0;
    for (const pixel of pixels) {
      hash = (Math.imul(hash, 31) + pixel) | 0;
      if (pixel !== pixels[0]) ++drawn;
    }
    return { hash, drawn };
  });
}

/** The picture after the camera stopped. */
export async function pictureAtRest(page) {
  await waitUntil(page, () => !window.boxplus.view.isMoving);
  return picture(page);
}

export async function startBrowser() {
  const playwright = await import("playwright-core").catch(() =>
    skip("node_modules of viewer/page are missing; scripts/page_tools.sh installs them"));
  const executable = (process.env.PATH ?? "").split(delimiter).map((folder) => join(folder, "chromium")).find(isExecutable);
  if (!executable) skip("chromium is missing; scripts/page_tools.sh installs it");
  return playwright.chromium.launch({ executablePath: executable, args: CHROMIUM_ARGUMENTS });
}

/** Starts `boxplus view`, which prints its URL. */
export async function startViewer(boxplus, file, ...options) {
  const process_of_viewer = spawn(boxplus, ["view", file, "--port", "0", ...options], { stdio: ["ignore", "pipe", "inherit"] });
  const exit = new Promise((resolve, reject) => {
    process_of_viewer.on("exit", (code, signal) => resolve(code ?? signal));
    process_of_viewer.on("error", reject);
  });
  const first_line = new Promise((resolve) => createInterface(process_of_viewer.stdout).once("line", resolve));
  const line = await Promise.race([first_line, exit.then((code) => fail(`boxplus view ended with ${code}`))]);
  const url = /http:\/\/\S+/.exec(line)?.[0] ?? fail(`boxplus view printed no URL, but "${line}"`);
  const stop = () => {
    process_of_viewer.kill("SIGINT");
    return exit;
  };
  return { url, stop };
}

function isReadable(path) {
  return isAccessible(path, constants.R_OK);
}

function isExecutable(path) {
  return isAccessible(path, constants.X_OK);
}

function isAccessible(path, mode) {
  try {
    accessSync(path, mode);
    return true;
  } catch {
    return false;
  }
}
