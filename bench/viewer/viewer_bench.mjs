// SPDX-License-Identifier: BSD-3-Clause
// Measures the viewer's page in chromium with software rendering, and what streaming costs a run. Prints a section of RESULTS.md.
//
//     node bench/viewer/viewer_bench.mjs PATH_TO_BOXPLUS DATA_FOLDER
import { execFileSync } from "node:child_process";
import { existsSync, mkdtempSync, rmSync } from "node:fs";
import { createServer } from "node:http";
import { cpus, tmpdir } from "node:os";
import { join } from "node:path";
import { openPage, startBrowser, startViewer } from "../../viewer/page/test/support.mjs";

const REPETITIONS = 5;
/** Of a drag of the mouse. */
const DRAG_MS = 3000;
/** Of 20 per second. */
const HOUR_OF_FRAMES = 72_000;
const ITERATIONS_PER_RUN = 500;
/** Kinds of messages. */
const STATE = 1, FRAME = 3;
/** Many small steps, on one thread, so that the reader of the stream has a processor of its own. */
const LONG_RUN = { algorithm: "levenberg-marquardt", lambda: "1e6", iterations: "40", threads: "1" };

const [boxplus, data] = process.argv.slice(2);
if (!data) throw new Error(`usage: node ${process.argv[1]} PATH_TO_BOXPLUS DATA_FOLDER`);
const folder = mkdtempSync(join(tmpdir(), "boxplus-"));

function simulate(name, ...args) {
  const path = join(folder, name);
  execFileSync(boxplus, ["simulate", ...args, "-o", path], { stdio: ["ignore", "ignore", "inherit"] });
  return path;
}

async function onViewer(file, action) {
  const viewer = await startViewer(boxplus, file);
  try {
    await action(viewer.url);
  } finally {
    await viewer.stop();
  }
}

async function pageRow(browser, name, url) {
  await idle(url);
  const opened = [];
  for (let i = 0; i < REPETITIONS; ++i) {
    const { page } = await openPage(browser, url);
    opened.push(await page.evaluate(() => performance.now()));
    await page.close();
  }
  const { page } = await openPage(browser, url);
  const { rate, lines } = await drag(page);
  await page.waitForFunction(() => !window.boxplus.view.isMoving);
  const whole = await page.evaluate(() => {
    const { view } = window.boxplus;
    const begin = performance.now();
    view.pixels();
    return performance.now() - begin;
  });
  const structure = await page.evaluate(() => {
    const { vertices, edges } = window.boxplus.view.graph.structure;
    const sum = (groups) => groups.reduce((total, { count }) => total + count, 0);
    return { vertices: sum(vertices), lines: sum(edges) };
  });
  await page.close();
  const cells = [name, structure.vertices, structure.lines, median(opened).toFixed(0), rate.toFixed(1), lines, whole.toFixed(0)];
  return `| ${cells.join(" | ")} |`;
}

/** Drags the graph, after a first drag in which the page learns how fast the machine is. */
async function drag(page) {
  const box = await page.locator("#scene").boundingBox();
  const x = box.x + box.width / 2, y = box.y + box.height / 2;
  const pictures = () => page.evaluate(() => window.boxplus.view.pictures);
  const total = await page.evaluate(() => window.boxplus.view.graph.structure.edges.reduce((sum, { count }) => sum + count, 0));
  let rate = 0, lines = 0;
  for (let attempt = 0; attempt < 2; ++attempt) {
    await page.mouse.move(x, y);
    await page.mouse.down();
    const first = await pictures(), begin = Date.now();
    for (let i = 0; Date.now() - begin < DRAG_MS; ++i) await page.mouse.move(x + 100 * Math.sin(i / 40), y + 50 * Math.sin(i / 60));
    rate = (1000 * ((await pictures()) - first)) / (Date.now() - begin);
    lines = await page.evaluate(() => Math.round(window.boxplus.view.budget.current.lines));
    await page.mouse.up();
  }
  return { rate, lines: Math.min(lines, total) };
}

async function streamingRow(name, url) {
  await idle(url);
  const alone = [], streamed = [];
  let frames = 0;
  for (let i = 0; i < REPETITIONS; ++i) {
    alone.push(await run(url));
    const client = await Client.open(url);
    streamed.push(await run(url));
    frames = client.frames;
    client.close();
  }
  const more = 100 * (median(streamed) / median(alone) - 1);
  return `| ${name} | ${median(alone).toFixed(3)} | ${median(streamed).toFixed(3)} | ${more.toFixed(1)} % | ${frames} |`;
}

/**
 * The memory of a page, after its garbage was collected, while a server sends the frames of an hour as fast as the page reads them:
 * runs of 500 iterations, one after the other, whose structure and first frame are those of the viewer.
 */
async function memoryParagraph(browser, url) {
  await idle(url);
  const recorded = await Client.open(url);
  recorded.close();
  const repeater = await startRepeater(url, recorded.messages);
  try {
    const { page } = await openPage(browser, repeater.url);
    const session = await page.context().newCDPSession(page);
    const heap = async () => {
      await session.send("HeapProfiler.collectGarbage");
      const { usedSize, backingStorageSize = 0 } = await session.send("Runtime.getHeapUsage");
      return (usedSize + backingStorageSize) / 2 ** 20;
    };
    await repeater.sent(HOUR_OF_FRAMES / 4);
    const before = await heap();
    await repeater.sent(HOUR_OF_FRAMES);
    const after = await heap();
    await page.close();
    return `\nAn hour of frames of intel_1728 (${HOUR_OF_FRAMES} of ${ITERATIONS_PER_RUN} per run, as fast as the page reads): it holds ` +
      `${before.toFixed(0)} MiB after a quarter of them, and ${after.toFixed(0)} MiB after all.\n`;
  } finally {
    repeater.stop();
  }
}

/** A server with the page of the viewer, and a stream that begins with these messages and goes on with frames. */
async function startRepeater(url, messages) {
  const html = Buffer.from(await (await fetch(url)).arrayBuffer());
  let count = 0;
  const server = createServer((request, response) => {
    if (request.url.startsWith("/stream")) {
      response.writeHead(200, { "Content-Type": "application/octet-stream" });
      void sendHour(response, messages, () => ++count);
    } else {
      response.writeHead(request.url === "/" ? 200 : 404, { "Content-Type": "text/html" });
      response.end(request.url === "/" ? html : "");
    }
  });
  await new Promise((resolve) => server.listen(0, "127.0.0.1", resolve));
  return {
    url: `http://127.0.0.1:${server.address().port}/`,
    sent: async (wanted) => {
      while (count < wanted) await new Promise((resolve) => setTimeout(resolve, 100));
    },
    stop: () => {
      server.closeAllConnections();
      server.close();
    },
  };
}

async function sendHour(response, messages, onFrame) {
  const send = async (kind, payload) => {
    const head = Buffer.alloc(8);
    head.writeUInt32LE(payload.length, 0);
    head.writeUInt32LE(kind, 4);
    if (!response.write(Buffer.concat([head, payload]))) await new Promise((resolve) => response.once("drain", resolve));
  };
  for (const { kind, payload } of messages) await send(kind, payload);
  const state = JSON.parse(messages.find(({ kind }) => kind === STATE).payload.toString());
  const frame = messages.find(({ kind }) => kind === FRAME).payload;
  for (let i = 0; i < HOUR_OF_FRAMES; ++i) {
    const iteration = 1 + (i % ITERATIONS_PER_RUN);
    const row = { iteration, chi2: 1 + 1 / iteration, chi2_decrease: 0.1, step_max: 0.1, lambda: 0, radius: 0, tries: 1, time_s: 0.05 * iteration };
    const run = {
      number: 1 + Math.floor(i / ITERATIONS_PER_RUN), first_row: iteration - 1, rows: [row], status: "running", headline: "", summary: "",
    };
    await send(STATE, Buffer.from(JSON.stringify({ ...state, chi2: row.chi2, busy: true, activity: "optimizing", run, log: { first: 0, lines: [] } })));
    await send(FRAME, renumbered(frame, { iteration, sequence: i + 2, chi2: row.chi2 }));
    onFrame();
    // The page draws pictures in between.
    if (i % 20 === 0) await new Promise((resolve) => setTimeout(resolve, 1));
  }
}

/** The frame with other numbers in its header. */
function renumbered(payload, numbers) {
  const size = payload.readUInt32LE(0);
  let header = JSON.stringify({ ...JSON.parse(payload.subarray(4, 4 + size).toString()), ...numbers });
  header = header.padEnd(Math.ceil(header.length / 4) * 4);
  const length = Buffer.alloc(4);
  length.writeUInt32LE(header.length);
  return Buffer.concat([length, Buffer.from(header), payload.subarray(4 + size)]);
}

/** Optimizes from the estimates of the file, and returns the seconds. */
async function run(url) {
  const { token } = await idle(url);
  await command(url, token, { type: "reset" });
  await idle(url);
  await command(url, token, { type: "optimize", settings: LONG_RUN });
  const { run: done } = await idle(url);
  return done.rows.at(-1).time_s;
}

async function command(url, token, body) {
  const response = await fetch(new URL("/command", url), {
    method: "POST",
    headers: { "Content-Type": "application/json", "X-Boxplus-Token": token },
    body: JSON.stringify(body),
  });
  if (!response.ok) throw new Error((await response.json()).error);
}

/** Waits until nothing runs, and returns the state. Asks seldom, because each answer contains a picture. */
async function idle(url) {
  for (;;) {
    const state = await Client.state(url);
    if (!state.busy) return state;
    await new Promise((resolve) => setTimeout(resolve, 2000));
  }
}

/** A client of the stream, without a page. */
class Client {
  frames = 0;
  /** The first ones, up to the first frame. */
  messages = [];
  #abort = new AbortController();

  /** Returns after the first frame. */
  static async open(url) {
    const client = new Client();
    await new Promise((resolve, reject) => void client.#read(url, resolve).catch(reject));
    return client;
  }

  /** The first state of a stream, which is closed then. */
  static async state(url) {
    const client = new Client();
    return new Promise((resolve, reject) => {
      const onState = (payload) => {
        client.close();
        resolve(JSON.parse(payload.toString()));
      };
      void client.#read(url, () => {}, onState).catch(reject);
    });
  }

  close() {
    this.#abort.abort();
  }

  async #read(url, onFrame, onState = () => {}) {
    const { body } = await fetch(new URL("/stream", url), { signal: this.#abort.signal });
    const chunks = [];
    let size = 0;
    for await (const chunk of body) {
      chunks.push(chunk);
      size += chunk.length;
      if (size < 8 || size < 8 + Buffer.concat(chunks.slice(0, 2)).readUInt32LE(0)) continue;
      let rest = Buffer.concat(chunks);
      while (rest.length >= 8 && rest.length >= 8 + rest.readUInt32LE(0)) {
        const kind = rest.readUInt32LE(4), payload = rest.subarray(8, 8 + rest.readUInt32LE(0));
        if (this.frames === 0) this.messages.push({ kind, payload: Buffer.from(payload) });
        if (kind === STATE) onState(payload);
        if (kind === FRAME && ++this.frames === 1) onFrame();
        rest = rest.subarray(8 + payload.length);
      }
      chunks.splice(0, chunks.length, rest);
      size = rest.length;
    }
  }
}

function version() {
  return execFileSync(boxplus, ["--version"], { encoding: "utf8" }).split("\n")[0];
}

function median(numbers) {
  return [...numbers].sort((a, b) => a - b)[numbers.length >> 1];
}

async function main() {
  const streets = simulate("streets.g2o", "streets", "--poses", "100000");
  const cloud = simulate("cloud.bal", "ba", "--shape", "city", "--cameras", "1000", "--points", "1000000");
  const torus = join(data, "posegraph3d", "torus3D.g2o");
  const files = [["torus3D", torus], ["streets", streets], ["city of points", cloud]].filter(([, file]) => existsSync(file));

  console.log("## The viewer\n");
  console.log(`Measured at ${new Date().toISOString().slice(0, 16).replace("T", " ")} UTC with ${version()}, on ${cpus()[0].model}, ` +
    `${cpus().length} threads.\n`);
  console.log("The page in headless chromium, which renders on the processor, at 1280 × 720. *Opened*: from the request of the");
  console.log(`page to its first picture, median of ${REPETITIONS}. *Pictures/s* are those while the mouse drags the graph; the page`);
  console.log("then draws so much of the graph that the machine can follow, and everything when the mouse rests.\n");
  console.log("| graph | vertices | lines | opened, ms | pictures/s | lines drawn while it moves | the whole graph, ms |");
  console.log("|---|--:|--:|--:|--:|--:|--:|");
  const browser = await startBrowser();
  try {
    for (const [name, file] of files) await onViewer(file, async (url) => console.log(await pageRow(browser, name, url)));
    const ring = simulate("ring.g2o", "torus", "--poses", "10000");
    const streamed = [["torus of 10000 poses, simulated", ring], ["streets", streets]];
    console.log("\n### What streaming costs a run\n");
    console.log(`The time of a run on one thread without a page, and with one client that reads all frames. They take`);
    console.log(`turns; medians of ${REPETITIONS}.\n`);
    console.log("| graph | alone, s | streamed, s | more | frames |");
    console.log("|---|--:|--:|--:|--:|");
    for (const [name, file] of streamed) await onViewer(file, async (url) => console.log(await streamingRow(name, url)));
    const intel = join(data, "posegraph2d", "intel_1728.g2o");
    if (existsSync(intel)) await onViewer(intel, async (url) => console.log(await memoryParagraph(browser, url)));
  } finally {
    await browser.close();
  }
}

try {
  await main();
} finally {
  rmSync(folder, { recursive: true });
}
