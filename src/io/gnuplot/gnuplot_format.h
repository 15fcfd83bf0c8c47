// SPDX-License-Identifier: BSD-3-Clause
// Data for gnuplot. boxplus only writes it.
#pragma once

#include "boxplus/io/file_format.h"

namespace boxplus {

/// Data sets with names, which gnuplot's `index` selects: poses and points (a line per vertex: id, position,
/// heading θ or quaternion), and odometry, closures and observations (two lines and a blank line per pair of
/// vertices of an edge: two positions). Data sets without elements are left out. Odometry is an edge of two
/// poses whose ids differ by 1; a closure is one of any other two poses; all others are observations.
/// Vertices without a finite position, and edges with less than two vertices that have one, are left out.
FileFormat gnuplot_format();

}  // namespace boxplus
