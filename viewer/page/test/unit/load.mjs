// SPDX-License-Identifier: BSD-3-Clause
// Imports a module of the page into node.
import { fileURLToPath } from "node:url";
import { build } from "esbuild";

export async function load(file) {
  const { outputFiles } = await build({
    absWorkingDir: fileURLToPath(new URL("../..", import.meta.url)),
    entryPoints: [file],
    bundle: true,
    write: false,
    format: "esm",
  });
  return import(`data:text/javascript;base64,${Buffer.from(outputFiles[0].contents).toString("base64")}`);
}
