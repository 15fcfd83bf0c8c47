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

/// The requests for `blocks`. The places for their values lie one after the other, starting at `out`.
std::vector<InverseRequest> list_requests(const BlockStructure& structure,
                                          std::span<const BlockCoordinate> blocks, double* out);

/// Sorts the requests by column, and computes them with one solve per scalar column that they contain. The
/// solver's factorize() must have succeeded before. Returns false if a solve fails or is stopped.
bool solve_for_inverse(LinearSolver& solver, const BlockStructure& structure,
                       std::span<InverseRequest> requests, const StopToken& stop);

}  // namespace boxplus
