// SPDX-License-Identifier: BSD-3-Clause
// Segments in the plane as infinite lines.
#pragma once

#include "boxplus/io/graph_file.h"

namespace boxplus::app {

/// Makes each VERTEX_SEGMENT2D the VERTEX_LINE2D (θ, ρ) through its end points, with the same id, and each
/// edge of a segment an EDGE_SE2_LINE2D. θ is the angle of the normal n, which is the direction d from the
/// first point to the second, turned by −90°; ρ = n·p.
///
/// EDGE_SE2_SEGMENT2D_LINE measures the same, so z and Ω do not change. The other edges measure positions
/// along the line, too. They are p = ρ n + t d, so that ∂p/∂(θ, ρ, t) = [ρ d − t n, n, d]. Ω is transformed
/// to these coordinates, and the t are marginalized (Schur complement). This is exact up to the first order.
///
/// Throws InvalidArgument if there is no VERTEX_SEGMENT2D, an edge has no counterpart, or a segment is one
/// point.
void segments_to_lines(GraphFile& file);

}  // namespace boxplus::app
