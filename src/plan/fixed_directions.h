// SPDX-License-Identifier: BSD-3-Clause
// Fixed tangent directions of vertices. Their rows and columns are removed from H.
#pragma once

#include <span>

#include "plan/plan.h"

namespace boxplus {

/// Whether all tangent directions of the vertex are fixed.
bool all_directions_fixed(const detail::VertexPool& pool, std::uint32_t slot);

/// Fills Plan::fixed_scalars and Chunk::fixed of an otherwise complete plan. Takes O(nonzero blocks of the
/// stored columns of H) if any vertex has fixed directions.
void list_fixed_directions(const Graph& graph, Plan& plan);

/// All entries of H and of the gradient that belong to fixed scalars, also in columns that are not stored.
Chunk::FixedScalars all_fixed_scalars(const Graph& graph, const Plan& plan);

/// Removes the fixed scalars of a chunk from the stored columns of H, whose values are `values`, and from the
/// gradient. The result is the same as if their columns in every Jacobian were zero, except that the diagonal
/// of H stays positive.
void leave_out_fixed(const Chunk::FixedScalars& fixed, std::span<double> values, std::span<double> gradient);

}  // namespace boxplus
