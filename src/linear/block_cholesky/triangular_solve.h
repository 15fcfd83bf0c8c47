// SPDX-License-Identifier: BSD-3-Clause
// Forward and backward substitution with the supernodal factor, in the permuted order. For Scalar = double
// and float.
#pragma once

#include <cstdint>

#include "linear/block_cholesky/numeric_factor.h"
#include "linear/block_cholesky/symbolic_factor.h"

namespace boxplus {

/// x ← L⁻¹ x or L⁻ᵀ x for `columns` right-hand sides; x is columns × scalars: the values of one scalar are
/// contiguous. `work` is that of the factor, `panels` its arena. A single
/// right-hand side is solved for on the threads of the schedule, to the same bits.
/// Returns false soon after the token is raised; x is of no use then.
template <class Scalar>
bool solve_lower(const SymbolicFactor& symbolic, const Scalar* panels, int columns, Scalar* x, Scalar* work,
                 const StopToken& stop = {});
template <class Scalar>
bool solve_upper(const SymbolicFactor& symbolic, const Scalar* panels, int columns, Scalar* x, Scalar* work,
                 const StopToken& stop = {});

/// solve_upper for one right-hand side that is zero after the columns of fronts[last_front].
template <class Scalar>
void solve_upper_from(const SymbolicFactor& symbolic, const Scalar* panels, std::uint32_t last_front,
                      Scalar* x, Scalar* work);

/// X = (A + λD)⁻¹ B, unpermuted: as many right-hand sides, one after the other, as the factor has room for.
/// Returns false, with X as it was, soon after the token is raised.
template <class Scalar>
bool solve_with(const SymbolicFactor& symbolic, const BlockStructure& structure,
                const NumericFactor<Scalar>& factor, const double* b, int columns, double* x,
                const StopToken& stop = {});

}  // namespace boxplus
