// SPDX-License-Identifier: BSD-3-Clause
// Forward and backward substitution with the supernodal factor, in the permuted order.
#pragma once

#include <cstdint>

#include "linear/block_cholesky/symbolic_factor.h"

namespace boxplus {

/// x ← L⁻¹ x or L⁻ᵀ x for `columns` right-hand sides; x is columns × scalars: the values of one scalar are
/// contiguous. `work` holds columns · largest_front numbers. `panels` is the arena.
void solve_lower(const SymbolicFactor& symbolic, const double* panels, int columns, double* x, double* work);
void solve_upper(const SymbolicFactor& symbolic, const double* panels, int columns, double* x, double* work);

/// solve_upper for one right-hand side that is zero after the columns of fronts[last_front].
void solve_upper_from(const SymbolicFactor& symbolic, const double* panels, std::uint32_t last_front,
                      double* x, double* work);

}  // namespace boxplus
