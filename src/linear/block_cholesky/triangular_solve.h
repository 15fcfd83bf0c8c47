// SPDX-License-Identifier: BSD-3-Clause
// Forward and backward substitution with the supernodal factor, in the permuted order. Scalar is double or
// float.
#pragma once

#include <cstdint>

#include "linear/block_cholesky/numeric_factor.h"
#include "linear/block_cholesky/symbolic_factor.h"

namespace boxplus {

/// solve_lower() computes x ← L⁻¹ x, and solve_upper() computes x ← L⁻ᵀ x, for `columns` right-hand sides.
/// The matrix x is columns × scalars and column-major, so the values of one scalar are contiguous. `panels`
/// is the arena of the factor, and `work` is its scratch memory. A single right-hand side uses the threads of
/// the schedule, and the result has the same bits as on one thread. Returns false soon after the token is
/// raised; x is then not usable.
template <class Scalar>
bool solve_lower(const SymbolicFactor& symbolic, const Scalar* panels, int columns, Scalar* x, Scalar* work,
                 const StopToken& stop = {});
template <class Scalar>
bool solve_upper(const SymbolicFactor& symbolic, const Scalar* panels, int columns, Scalar* x, Scalar* work,
                 const StopToken& stop = {});

/// Does the same as solve_upper() for one right-hand side that is zero after the columns of
/// fronts[last_front].
template <class Scalar>
void solve_upper_from(const SymbolicFactor& symbolic, const Scalar* panels, std::uint32_t last_front,
                      Scalar* x, Scalar* work);

/// X = (A + λD)⁻¹ B, in the numbering of the structure. The columns of B and X lie one after the other, and
/// the factor must be allocated for this number of right-hand sides. Returns false soon after the token is
/// raised; X is then unchanged.
template <class Scalar>
bool solve_with(const SymbolicFactor& symbolic, const BlockStructure& structure,
                const NumericFactor<Scalar>& factor, const double* b, int columns, double* x,
                const StopToken& stop = {});

}  // namespace boxplus
