// SPDX-License-Identifier: BSD-3-Clause
// The matrix H of the normal equations as text for other programs.
#pragma once

#include <string>

#include "boxplus/graph/graph.h"

namespace boxplus::app {

/// H = Σ ρ′ JᵀΩJ at the current estimates, for the edges of level 0. Each vertex that is not fixed has a
/// block of rows, one per direction of its tangent: eliminated vertices first, both groups by id, then
/// unfixed parameters among them by id. Comments name the rows of each block. Nothing is held for gauge
/// freedom, so H may be singular.
///
/// The format is Matrix Market (coordinate real symmetric: the lower triangle) if `path` ends with ".mtx",
/// and otherwise Octave's text format, with two variables: the sparse matrix H, and `blocks`, with a row for
/// each block: id, first row of H, number of rows, and 1 if it is a parameter. Rows are numbered from 1.
/// Throws InvalidArgument if H is not finite.
std::string matrix_text(const Graph& graph, const std::string& path);

}  // namespace boxplus::app
