// SPDX-License-Identifier: BSD-3-Clause
// The BAL problem of a COLMAP model.
#pragma once

#include "boxplus/io/graph_file.h"
#include "boxplus/io/sparse_model.h"

namespace boxplus {

/// Each image gets its own camera, even if images share one in the model, because BAL has no shared cameras.
/// Keeps the order of images, points and features. Throws InvalidArgument if the model of a camera has terms
/// that BAL's camera does not have.
GraphFile bal_from_model(const SparseModel& model);

}  // namespace boxplus
