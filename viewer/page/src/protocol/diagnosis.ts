// SPDX-License-Identifier: BSD-3-Clause
// The answer to `GET /diagnosis`, as viewer/PROTOCOL.md describes it.
import type { ElementName } from "./element";

export interface Finding {
  severity: "error" | "warning" | "note";
  kind: string;
  text: string;
  /** null if there are several. */
  element: ElementName | null;
  /** The numbers of the drawn vertices. */
  marked: number[];
}

export interface Diagnosis {
  structure: number;
  /** Of all findings, some of which may not be sent. */
  count: number;
  findings: Finding[];
}
