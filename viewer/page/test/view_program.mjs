// SPDX-License-Identifier: BSD-3-Clause
// The page of `boxplus optimize --view` offers no files, and says why.
//
//     node test/view_program.mjs PATH_TO_BOXPLUS DATA_FOLDER    exit code 77: something is missing, so the test is skipped
import { spawn } from "node:child_process";
import { createInterface } from "node:readline";
import { expectEqual, fail, openPage, simulatedFile, startBrowser, step, waitUntil } from "./support.mjs";

const REASON = "This viewer shows the graph of a program, and opens no files.";
const [boxplus] = process.argv.slice(2);
const browser = await startBrowser();
const command = spawn(boxplus, ["optimize", simulatedFile("manhattan", "--poses", "100")(boxplus), "--view", "--port", "0"],
  { stdio: ["ignore", "ignore", "pipe"] });
const exit = new Promise((resolve) => command.on("exit", resolve));
try {
  const line = await new Promise((resolve) => createInterface(command.stderr).once("line", resolve));
  const { page, problems } = await openPage(browser, /http:\/\/\S+/.exec(line)[0]);
  // After the run, the page may go on with the graph.
  await waitUntil(page, () => !document.getElementById("optimize").disabled);

  for (const id of ["open", "open-truth"]) {
    await step(`#${id} is disabled, with the reason`, async () => {
      if (await page.isEnabled(`#${id}`)) fail("it can be clicked");
      expectEqual(await page.getAttribute(`#${id}`, "title"), REASON);
    });
  }

  await step("no error and no request to another host", () => {
    if (problems.length > 0) fail(problems.join("; "));
  });
} catch (error) {
  console.error(`FAILED: ${error.message}`);
  process.exitCode = 1;
} finally {
  await browser.close();
  command.kill("SIGINT");
  await exit;
}
