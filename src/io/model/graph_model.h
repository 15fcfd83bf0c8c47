// SPDX-License-Identifier: BSD-3-Clause
// The COLMAP model of a graph (SparseModel).
#pragma once

#include <string>
#include <vector>

#include "boxplus/io/file_format.h"
#include "boxplus/io/sparse_model.h"

namespace boxplus {

/// See sparse_model().
SparseModel model_of(const GraphFileView& file);
/// Makes model_of() compute the reprojection errors of all points, also of those that have not changed since
/// the file was read: some programs write models with the errors of earlier estimates.
void forget_reprojection_errors(GraphFile& file);
/// See losses().
std::vector<std::string> model_losses(const GraphFileView& file);

}  // namespace boxplus
