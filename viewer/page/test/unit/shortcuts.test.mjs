// SPDX-License-Identifier: BSD-3-Clause
// Tests of src/panels/shortcuts.ts and of the table of keys, without a browser.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import test from "node:test";
import { load } from "./load.mjs";

const { keyName, takesLetters } = await load("src/panels/shortcuts.ts");
const { shortcutGroups } = await load("src/panels/shortcut_table.ts");

const shortcuts = Object.values(shortcutGroups({}, {})).flat();

test("the name of a letter does not depend on Caps Lock", () => {
  assert.equal(keyName({ key: "r" }), "r");
  assert.equal(keyName({ key: "R" }), "r");
  assert.equal(keyName({ key: "r", shiftKey: true }), "Shift+R");
  assert.equal(keyName({ key: "R", shiftKey: true }), "Shift+R");
});

test("a sign is named after itself, on whatever key it lies", () => {
  assert.equal(keyName({ key: "?", shiftKey: true }), "?");
  assert.equal(keyName({ key: "+" }), "+");
});

test("keys with other modifiers belong to the browser", () => {
  for (const modifier of ["ctrlKey", "metaKey", "altKey"]) assert.equal(keyName({ key: "r", [modifier]: true }), null);
});

test("fields take letters, and other controls do not", () => {
  for (const type of ["text", "number"]) assert.ok(takesLetters({ tagName: "INPUT", type }));
  assert.ok(takesLetters({ tagName: "SELECT" }));
  assert.ok(takesLetters({ tagName: "TEXTAREA" }));
  for (const type of ["range", "checkbox", "color"]) assert.ok(!takesLetters({ tagName: "INPUT", type }));
  assert.ok(!takesLetters({ tagName: "BUTTON", type: "submit" }));
  assert.ok(!takesLetters({ tagName: "CANVAS" }));
});

test("each key has one meaning", () => {
  const keys = shortcuts.flatMap((shortcut) => shortcut.keys);
  assert.deepEqual(keys, [...new Set(keys)]);
});

test("each shortcut names a control of the page or has an action", () => {
  const made_by_script = ["show-initial"];
  const html = readFileSync(new URL("../../index.html", import.meta.url), "utf8");
  for (const { text, control, action } of shortcuts) {
    const is_known = html.includes(`id="${control}"`) || made_by_script.includes(control);
    assert.ok(control ? is_known : action, text);
  }
});
