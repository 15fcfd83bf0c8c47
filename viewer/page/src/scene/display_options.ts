// SPDX-License-Identifier: BSD-3-Clause
// What the user may choose about the picture.
import type { PointLimits } from "./point_filter";

export interface DisplayOptions {
  /** Factors on the sizes that the page chooses. */
  pose_scale: number;
  camera_scale: number;
  /** In pixels. */
  point_size: number;
  edge_opacity: number;
  poses_as_axes: boolean;
  /** Indices of the groups in the structure. */
  hidden_vertices: Set<number>;
  hidden_edges: Set<number>;
  limits: PointLimits;
}

export function defaultOptions(): DisplayOptions {
  return {
    pose_scale: 1,
    camera_scale: 1,
    point_size: 2,
    edge_opacity: 0.8,
    poses_as_axes: false,
    hidden_vertices: new Set(),
    hidden_edges: new Set(),
    limits: { least_track_length: 0, most_error: Infinity },
  };
}
