// SPDX-License-Identifier: BSD-3-Clause
// Blocks of the inverse by solving for unit vectors.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "boxplus/linear/linear_solver.h"

namespace boxplus {

/// A requested block and where its values go.
struct InverseRequest {
  BlockCoordinate block;
  double* out;
};

/// The requests for `blocks` with values one after the other from `out`.
std::vector<InverseRequest> list_requests(const BlockStructure& structure,
                                          std::span<const BlockCoordinate> blocks, double* out);

/// Fills the requests (which it sorts by column) with one solve per scalar column that occurs. The solver is
/// factorized. False if a solve fails or is stopped.
bool solve_for_inverse(LinearSolver& solver, const BlockStructure& structure,
                       std::span<InverseRequest> requests, const StopToken& stop);

}  // namespace boxplus
