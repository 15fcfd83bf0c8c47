// SPDX-License-Identifier: BSD-3-Clause
// Gives files to the user, and asks the user for files.

/** The browser must have time to read the file before its URL ends. */
const URL_LIFE_MS = 60_000;

export function download(content: Blob, name: string): void {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(content);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), URL_LIFE_MS);
}

/** Shows the dialog of the input, and calls `take` with the file, each time anew even if it is the same file. */
export function askForFile(input: HTMLInputElement, take: (file: File) => void): void {
  input.onchange = () => {
    const file = input.files?.[0];
    input.value = "";
    if (file) take(file);
  };
  input.click();
}

/** The name without its folder and its ending: "garage" for "garage.g2o.gz". */
export function stem(name: string): string {
  const last = name.split(/[\\/]/).filter((part) => part !== "").pop() ?? "";
  return last.replace(/\.(gz|bz2|xz|zst)$/i, "").replace(/\.[^.]*$/, "") || "graph";
}
