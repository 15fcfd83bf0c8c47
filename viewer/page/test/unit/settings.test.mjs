// SPDX-License-Identifier: BSD-3-Clause
// Tests of src/settings, and of what is stored and written to files, without a browser.
import assert from "node:assert/strict";
import test from "node:test";
import { load } from "./load.mjs";

const storage = new Map();
globalThis.sessionStorage = { getItem: (name) => storage.get(name) ?? null, setItem: (name, text) => storage.set(name, text) };

const { SettingValues } = await load("src/settings/setting_values.ts");
const { storedOptions, storeOptions } = await load("src/scene/stored_options.ts");
const { cameraFromText, cameraToText } = await load("src/scene/camera_file.ts");
const { crc32, zip } = await load("src/zip.ts");
const { stem } = await load("src/download.ts");
const { label } = await load("src/format.ts");

const choices = (...values) => values.map((value) => ({ value, unsuitable: null }));
const FORM = {
  formats: [],
  settings: [
    { name: "algorithm", kind: "choice", default: "automatic", choices: choices("automatic", "dogleg", "levenberg-marquardt") },
    { name: "lambda", kind: "number", default: "", needs: { setting: "algorithm", value: "levenberg-marquardt" } },
    { name: "kernel", kind: "kernel", default: "", choices: choices("Huber", "Barron:ALPHA") },
    { name: "kernel-width", kind: "number", default: "", needs: { setting: "kernel", value: "" } },
    { name: "iterations", kind: "whole number", default: "100" },
  ],
};

function newValues(form = FORM) {
  const values = new SettingValues();
  values.setForm(form);
  return values;
}

test("only settings that differ from their defaults are sent", () => {
  storage.clear();
  const values = newValues();
  assert.deepEqual(values.toSend(), {});
  values.choose("algorithm", "dogleg");
  values.choose("iterations", "7");
  assert.deepEqual(values.toSend(), { algorithm: "dogleg", iterations: "7" });
  assert.deepEqual(values.toSend(["iterations"]), { algorithm: "dogleg" });
  values.choose("algorithm", "automatic");
  values.choose("iterations", "");
  assert.deepEqual(values.toSend(), {});
});

test("a setting is sent only if the one that it needs has the value", () => {
  storage.clear();
  const values = newValues();
  values.choose("lambda", "0.1");
  values.choose("kernel-width", "2");
  assert.deepEqual(values.toSend(), {});
  assert.equal(values.whyDisabled(FORM.settings[3]), "Needs a kernel");
  values.choose("kernel", "Barron:-2");
  values.choose("algorithm", "levenberg-marquardt");
  assert.equal(values.whyDisabled(FORM.settings[3]), "");
  assert.deepEqual(values.toSend(),
    { algorithm: "levenberg-marquardt", lambda: "0.1", kernel: "Barron:-2", "kernel-width": "2" });
});

test("settings survive a reload, and a reset forgets them", () => {
  storage.clear();
  newValues().choose("algorithm", "dogleg");
  const values = newValues();
  assert.deepEqual(values.toSend(), { algorithm: "dogleg" });
  values.reset();
  assert.deepEqual(newValues().toSend(), {});
});

test("a choice that is unsuitable for the graph has its default", () => {
  storage.clear();
  newValues().choose("algorithm", "dogleg");
  const form = structuredClone(FORM);
  form.settings[0].choices[1].unsuitable = "not for this graph";
  const values = newValues(form);
  assert.deepEqual(values.toSend(), {});
  values.setForm(FORM);
  assert.deepEqual(values.toSend(), { algorithm: "dogleg" });
});

test("what is stored by another version does no harm", () => {
  storage.clear();
  for (const text of ["", "[1]", "{", "7", '{"algorithm": 7}']) {
    storage.set("boxplus settings", text);
    assert.deepEqual(newValues().toSend(), {});
  }
  storage.set("boxplus display", '{"styles": {"pose SE2": {"color": "red", "size": -1, "shown": 1}}, "background": 3, "limits": 0}');
  const options = storedOptions();
  assert.deepEqual(options.styles, { "pose SE2": {} });
  assert.equal(options.background, null);
});

test("display options survive a reload", () => {
  storage.clear();
  const options = storedOptions();
  assert.equal(options.limits.most_error, Infinity);
  options.styles["pose SE2"] = { color: "#ff0000", size: 2, shown: false };
  options.background = "#ffffff";
  options.limits.least_track_length = 3;
  storeOptions(options);
  assert.deepEqual(storedOptions(), options);
});

test("a camera that is saved can be loaded", () => {
  for (const camera of [
    { kind: "perspective", position: [1, 2, 3], target: [0, 0, 0] },
    { kind: "orthographic", target: [1, 2, 0], height: 4 },
  ]) assert.deepEqual(cameraFromText(cameraToText(camera)), camera);
  assert.throws(() => cameraFromText("{}"), /Save camera/);
  assert.throws(() => cameraFromText('{"format": "boxplus camera 1", "kind": "perspective", "target": [0, 0, null]}'), /target/);
});

test("a zip file has its signatures and checksums", async () => {
  assert.equal(crc32(new TextEncoder().encode("123456789")), 0xcbf43926);
  const bytes = new TextEncoder().encode("content");
  const file = Buffer.from(await zip([{ name: "a.txt", bytes }, { name: "b.txt", bytes }]).arrayBuffer());
  assert.equal(file.readUInt32LE(0), 0x04034b50);
  const end = file.length - 22;
  assert.equal(file.readUInt32LE(end), 0x06054b50);
  assert.equal(file.readUInt16LE(end + 10), 2);
  const directory = file.readUInt32LE(end + 16);
  assert.equal(directory + file.readUInt32LE(end + 12), end);
  assert.equal(file.readUInt32LE(directory), 0x02014b50);
  assert.equal(file.readUInt32LE(directory + 16), crc32(bytes));
});

test("names of files and of settings", () => {
  assert.equal(stem("garage.g2o.gz"), "garage");
  assert.equal(stem("/data/intel.g2o"), "intel");
  assert.equal(stem(""), "graph");
  assert.equal(label("cost-tolerance"), "Cost tolerance");
});
