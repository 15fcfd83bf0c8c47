// SPDX-License-Identifier: BSD-3-Clause
// Computes blocks of the inverse by solving for unit vectors.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "boxplus/linear/linear_solver.h"

namespace boxplus {

/// A requested block, and the place for its values.
struct InverseRequest {
  BlockCoordinate block;
  double* out;
};

/// The requests for `blocks`, whose values are written one after the other from `out` on.
std::vector<InverseRequest> list_requests(const BlockStructure& structure,
                                          std::span<const BlockCoordinate> blocks, double* out);

/// Sorts the requests by column, and fills them with one solve per scalar column that occurs. The solver must
/// have factorized. Returns false if a solve fails or is stopped.
bool solve_for_inverse(LinearSolver& solver, const BlockStructure& structure,
                       std::span<InverseRequest> requests, const StopToken& stop);

}  // namespace boxplus
