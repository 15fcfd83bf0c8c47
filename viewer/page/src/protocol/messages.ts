// SPDX-License-Identifier: BSD-3-Clause
// The messages of the server, as viewer/PROTOCOL.md describes them. The names are those of the JSON.
import type { LineValues } from "../scene/edge_levels";
import type { Diagnosis } from "./diagnosis";

/** What the server sends for a number that is not finite is null. */
export type MaybeNumber = number | null;

export interface FileSummary {
  name: string;
  format: string;
  vertices: number;
  edges: number;
  dimension: number;
}

export interface IterationRow {
  iteration: number;
  chi2: MaybeNumber;
  chi2_decrease: MaybeNumber;
  step_max: MaybeNumber;
  lambda: MaybeNumber;
  radius: MaybeNumber;
  tries: number;
  time_s: MaybeNumber;
}

/** A run. `rows` replace all rows from `first_row`; a new `number` begins a new table. */
export interface RunMessage {
  number: number;
  first_row: number;
  rows: IterationRow[];
  status: string;
  headline: string;
  summary: string;
  /** The names of the first rows that are stages of a search for false edges, instead of iterations. */
  stages?: string[];
  /** The initial guess from which the first iteration starts; null if it starts from the estimates before the run. */
  start?: { name: string; chi2: MaybeNumber } | null;
  /** chi2 divided by the degrees of freedom; null if it is not known. */
  chi2_per_degree?: MaybeNumber;
  degrees_of_freedom?: number;
  /** The number of edges that the run found false, and that are still in the graph. */
  false_edges?: number;
}

export interface LogLine {
  level: string;
  text: string;
}

export interface StateMessage {
  /** Only in the first state of a stream, like `version`. */
  token?: string;
  version?: string;
  busy: boolean;
  activity: string;
  file: FileSummary | null;
  error?: string | null;
  chi2: MaybeNumber;
  chi2_initial: MaybeNumber;
  can_step: boolean;
  /** Why no files can be opened; null if they can. */
  opens_no_files: string | null;
  /** The same for the truth of this graph. */
  opens_no_truth: string | null;
  /** Whether the last diagnosis belongs to what the picture shows; null if there is none. */
  diagnosis: "current" | "other estimates" | "other graph" | null;
  run: RunMessage | null;
  log: { first: number; lines: LogLine[] };
}

/** A "corner" is only the end of lines. */
export type VertexShape = "pose" | "camera" | "camera back" | "point" | "corner";
export type EdgeRole = "odometry" | "loop closure" | "observation" | "other";

/** The vertices `first` to `first + count - 1` have one type. */
export interface VertexGroup {
  name: string;
  shape: VertexShape;
  first: number;
  count: number;
  /** The default color, if it is not that of the theme. */
  color?: string;
}

/** The lines `first` to `first + count - 1` have one type and one role. */
export interface EdgeGroup {
  name: string;
  role: EdgeRole;
  first: number;
  count: number;
  color?: string;
}

export interface Structure {
  /** It stays if the graph is edited, and differs if another file is opened. */
  graph: number;
  structure: number;
  dimension: number;
  is_bundle: boolean;
  /** The rotation, row-major, to a world whose z axis points up. */
  leveling: number[];
  vertices: VertexGroup[];
  edges: EdgeGroup[];
  /** The number of lines that are not sent. */
  left_out: number;
  /** Two vertex numbers for each line. */
  lines: Uint32Array;
  /** 1 if the vertex is fixed. */
  fixed: Uint8Array;
  /** The number of observations of each point, beginning with the first vertex that is a point. */
  track_lengths: Uint32Array | null;
  /** null if there are no laser scans. */
  scans: Scans | null;
}

/** The points that lasers have hit. Scan k belongs to the pose `vertices[k]`, and has `counts[k]` points. */
export interface Scans {
  vertices: Uint32Array;
  counts: Uint32Array;
  /** x, y, z of each point, scan after scan, in the frame of its pose. */
  points: Float32Array;
}

/** True if the structures have the same types with the same numbers of vertices, fixed vertices and edges. */
export function isSameKind(a: Structure, b: Structure): boolean {
  const kind = ({ dimension, is_bundle, vertices, edges, fixed, scans }: Structure) =>
    JSON.stringify([dimension, is_bundle, vertices, edges, fixed.reduce((sum, flag) => sum + flag, 0), scans?.vertices.length]);
  return kind(a) === kind(b);
}

/** True if frames of one structure belong to the other one, too, as after a lost connection. */
export function isSameStructure(a: Structure, b: Structure | null): boolean {
  return b !== null && a.structure === b.structure && isSameKind(a, b);
}

/** The covariances of positions. */
export interface Uncertainty {
  /** What was computed, or why nothing was. */
  note: string;
  vertices: Uint32Array;
  /** xx, xy, xz, yy, yz, zz in m² for each of the vertices. */
  covariances: Float32Array;
}

/** The true estimates from another file, in the order of the structure with this number. */
export interface Truth {
  structure: number;
  name: string;
  /** "id", "name" or "position". */
  matched_by: string;
  matched: number;
  poses: number;
  true_poses: number;
  /** x, y, z of each vertex; NaN if the vertex has no truth. */
  positions: Float32Array;
}

/** How a frame differs from the truth. */
export interface TruthFit {
  /** The motion that brings the positions of the truth closest to those of the frame; row-major. */
  rotation: number[];
  translation: [number, number, number];
  ate_m: MaybeNumber;
  rpe_m: MaybeNumber;
  rpe_rad: MaybeNumber;
}

export interface Frame {
  structure: number;
  sequence: number;
  iteration: number;
  chi2: MaybeNumber;
  center: [number, number, number];
  /** x, y, z of each vertex relative to `center`; NaN if the vertex is not drawn. */
  positions: Float32Array;
  /** x, y, z, w of each pose and camera. */
  orientations: Float32Array;
  /** The reprojection error of each point, if the server knows it. */
  errors: Float32Array | null;
  /** The arrays `chi2`, `weights` and `verdicts`, if the server knows them. */
  line_values: LineValues | null;
  /** null if nobody asked for it. */
  uncertainty: Uncertainty | null;
  /** null if there is no truth, or if it cannot be compared. */
  truth: TruthFit | null;
}

/** A value that a setting can have; `unsuitable` is the reason why it makes no sense for this graph. */
export interface Choice {
  value: string;
  unsuitable: string | null;
}

export interface Setting {
  name: string;
  group: string;
  kind: "choice" | "whole number" | "number" | "kernel";
  help: string;
  /** "" means that nothing is sent. */
  default: string;
  unit?: string;
  choices?: Choice[];
  /** The setting has no meaning unless the other one has this value; "" stands for any value. */
  needs?: { setting: string; value: string };
}

export interface FileFormat {
  name: string;
  extension: string;
}

/** What can be chosen for this graph. */
export interface Form {
  formats: FileFormat[];
  settings: Setting[];
}

export interface PatternPicture {
  name: "H_by_id" | "H_ordered" | "L_by_id" | "L_ordered";
  blocks: number;
  /** False if there are more blocks, and only the first rows are in the picture. */
  is_complete: boolean;
  /** The blocks in each cell, row by row. */
  counts: Uint32Array;
}

/** The lower triangle of H, and its factor L. */
export interface Pattern {
  /** The number of block rows. */
  size: number;
  /** The number of cells in each row of a picture. */
  cells: number;
  pictures: PatternPicture[];
}

export type Message =
  | { kind: "state"; state: StateMessage }
  | { kind: "form"; form: Form }
  | { kind: "structure"; structure: Structure }
  | { kind: "frame"; frame: Frame }
  | { kind: "truth"; truth: Truth }
  | { kind: "pattern"; pattern: Pattern }
  | { kind: "diagnosis"; diagnosis: Diagnosis };

/** The values of settings, by their names. */
export type SettingTexts = Record<string, string>;

export type EditKind = "fix" | "free" | "remove" | "disable" | "enable" | "scale";

export type Command =
  | ({ type: "edit"; edit: EditKind; structure: string; factor?: string } & { [key in "id" | "edge"]?: string })
  | { type: "optimize"; settings: SettingTexts }
  | { type: "step"; settings: SettingTexts }
  | { type: "guess"; start: string }
  | { type: "covariances" }
  | { type: "remove_false_edges" }
  | { type: "stop" }
  | { type: "reset" };
