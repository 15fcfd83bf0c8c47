// SPDX-License-Identifier: BSD-3-Clause
// What the user chose, kept while the tab of the browser lives.

/** Returns null if nothing is stored under this name, or if the browser stores nothing. */
export function stored(name: string): unknown {
  try {
    return JSON.parse(sessionStorage.getItem(`boxplus ${name}`) ?? "null");
  } catch {
    return null;
  }
}

export function store(name: string, value: unknown): void {
  try {
    sessionStorage.setItem(`boxplus ${name}`, JSON.stringify(value));
  } catch {
    // A browser may forbid it, and then the page forgets.
  }
}

/** Returns an empty object if the value is something else. */
export function asRecord(value: unknown): Record<string, unknown> {
  return typeof value === "object" && value !== null && !Array.isArray(value) ? (value as Record<string, unknown>) : {};
}
