// SPDX-License-Identifier: BSD-3-Clause
// What the user may choose about the picture.
import type { EdgeGroup, Structure, VertexGroup } from "../protocol/messages";
import type { ColorMode } from "./coloring";
import type { EdgeColoring } from "./edge_levels";
import type { PointLimits } from "./point_filter";
import { isPoint } from "./statistics";

/** With more points than this, each of them is small. */
const MANY_POINTS = 5000;
const SMALL_POINT = 2, LARGE_POINT = 5;
const EDGE_OPACITY = 0.8;

/** What the user chose for a type; what is absent has its default. */
export interface TypeStyle {
  shown?: boolean;
  /** "#rrggbb" instead of the color of the theme. */
  color?: string;
  /** Points: their size in pixels. Other vertices: a factor on the size that the page chooses. Edges: their opacity. */
  size?: number;
}

export interface DisplayOptions {
  /** By the names of types; see styleOf(). */
  styles: Record<string, TypeStyle>;
  /** "#rrggbb" instead of the color of the theme. */
  background: string | null;
  poses_as_axes: boolean;
  /** The estimates of the file, faintly under the current ones. */
  shows_initial: boolean;
  /** The true estimates, if a file with them is open. */
  shows_truth: boolean;
  /** The ellipses of the current estimates, if they were computed. */
  shows_uncertainty: boolean;
  /** The points that lasers have hit. */
  shows_scans: boolean;
  /** What the colors of vertices tell. */
  color_mode: ColorMode;
  edge_coloring: EdgeColoring;
  limits: PointLimits;
}

export function defaultOptions(): DisplayOptions {
  return {
    styles: {},
    background: null,
    poses_as_axes: false,
    shows_initial: false,
    shows_truth: true,
    shows_uncertainty: true,
    shows_scans: true,
    color_mode: "type",
    edge_coloring: "role",
    limits: { least_track_length: 0, most_error: Infinity },
  };
}

/** Returns what the user chose for the type, which can be changed in place. */
export function styleOf(options: DisplayOptions, group: VertexGroup | EdgeGroup): TypeStyle {
  return (options.styles[`${"role" in group ? group.role : group.shape} ${group.name}`] ??= {});
}

export function defaultShown(structure: Structure, group: VertexGroup | EdgeGroup): boolean {
  if ("shape" in group && group.shape === "corner") return false;
  // The observations of a reconstruction would cover all else.
  return !("role" in group && structure.is_bundle && group.role === "observation");
}

export function defaultSize(structure: Structure, group: VertexGroup | EdgeGroup): number {
  if ("role" in group) return EDGE_OPACITY;
  if (!isPoint(group)) return 1;
  const points = structure.vertices.filter(isPoint).reduce((sum, { count }) => sum + count, 0);
  return points > MANY_POINTS ? SMALL_POINT : LARGE_POINT;
}
