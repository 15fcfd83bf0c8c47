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
/// See losses().
std::vector<std::string> model_losses(const GraphFileView& file);

}  // namespace boxplus
