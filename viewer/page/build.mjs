// SPDX-License-Identifier: BSD-3-Clause
// Builds dist/page.html.gz: index.html with the script and the style inside. The same sources give the same page.
//
//     node build.mjs            builds the page
//     node build.mjs --check    fails if dist/page.html.gz is not what the sources give
import { createHash } from "node:crypto";
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { gunzipSync, gzipSync } from "node:zlib";
import { build } from "esbuild";

const here = dirname(fileURLToPath(import.meta.url));
const output = join(here, "dist", "page.html.gz");

async function bundle(entry) {
  const result = await build({
    absWorkingDir: here,
    entryPoints: [entry],
    bundle: true,
    minify: true,
    write: false,
    charset: "utf8",
    format: "iife",
    target: ["chrome107", "firefox104", "safari16"],
    legalComments: "inline",
    logLevel: "warning",
  });
  return result.outputFiles[0].text.trim();
}

function sourceHash(text) {
  return `'sha256-${createHash("sha256").update(text, "utf8").digest("base64")}'`;
}

async function page() {
  const script = await bundle("src/main.ts");
  const style = await bundle("style.css");
  const policy = [
    "default-src 'none'",
    `script-src ${sourceHash(script)}`,
    `style-src ${sourceHash(style)}`,
    "connect-src 'self'",
    "img-src 'self' data: blob:",
    "base-uri 'none'",
    "form-action 'none'",
  ].join("; ");
  const parts = { policy, style, script };
  return readFileSync(join(here, "index.html"), "utf8").replace(/\{\{(\w+)\}\}/g, (_, name) => parts[name]);
}

function builtPage() {
  try {
    return gunzipSync(readFileSync(output)).toString("utf8");
  } catch {
    return "";
  }
}

const html = await page();
const is_current = builtPage() === html;
if (process.argv.includes("--check")) {
  if (!is_current) {
    console.error("viewer/page/dist/page.html.gz is not what its sources give; run `make page`");
    process.exit(1);
  }
} else if (!is_current) {
  const compressed = gzipSync(html, { level: 9 });
  compressed[9] = 3; // the operating system in the header of gzip, which differs between machines
  mkdirSync(dirname(output), { recursive: true });
  writeFileSync(output, compressed);
  console.log(`viewer/page/dist/page.html.gz: ${compressed.length} bytes (${html.length} unzipped)`);
}
