// SPDX-License-Identifier: BSD-3-Clause
// Tangent directions in which a vertex stays: their rows and columns leave H.
#pragma once

#include <span>

#include "boxplus/linearize/plan.h"

namespace boxplus {

/// Whether the vertex stays in all directions of its tangent.
bool all_directions_fixed(const VertexPool& pool, std::uint32_t slot);

/// Fills Plan::fixed_scalars and Chunk::fixed of a plan that is complete otherwise. O(nonzero blocks of H),
/// unless no vertex has fixed directions.
void list_fixed_directions(const Graph& graph, Plan& plan);

/// Takes the fixed scalars of a chunk out of H and the gradient: as if their columns of every Jacobian were
/// zero, but for the diagonal, which stays positive.
void leave_out_fixed(const Chunk::FixedScalars& fixed, std::span<double> values, std::span<double> gradient);

}  // namespace boxplus
