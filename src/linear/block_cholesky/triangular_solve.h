// SPDX-License-Identifier: BSD-3-Clause
// Forward and backward substitution with the supernodal factor, in the permuted order. For Scalar = double
// and float.
#pragma once

#include <cstdint>

#include "linear/block_cholesky/numeric_factor.h"
#include "linear/block_cholesky/symbolic_factor.h"

namespace boxplus {

/// x ← L⁻¹ x or L⁻ᵀ x for `columns` right-hand sides. x is columns × scalars, so the values of one scalar are
/// contiguous. `work` is that of the factor, and `panels` its arena. A single right-hand side uses the
/// threads of the schedule, with the same bits. Returns false soon after the token is raised; x is then not
/// usable.
template <class Scalar>
bool solve_lower(const SymbolicFactor& symbolic, const Scalar* panels, int columns, Scalar* x, Scalar* work,
                 const StopToken& stop = {});
template <class Scalar>
bool solve_upper(const SymbolicFactor& symbolic, const Scalar* panels, int columns, Scalar* x, Scalar* work,
                 const StopToken& stop = {});

/// solve_upper() for one right-hand side that is zero after the columns of fronts[last_front].
template <class Scalar>
void solve_upper_from(const SymbolicFactor& symbolic, const Scalar* panels, std::uint32_t last_front,
                      Scalar* x, Scalar* work);

/// X = (A + λD)⁻¹ B, unpermuted, for at most as many right-hand sides as the factor has room for, one after
/// the other. Returns false soon after the token is raised; X is then unchanged.
template <class Scalar>
bool solve_with(const SymbolicFactor& symbolic, const BlockStructure& structure,
                const NumericFactor<Scalar>& factor, const double* b, int columns, double* x,
                const StopToken& stop = {});

}  // namespace boxplus
