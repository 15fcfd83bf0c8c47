// SPDX-License-Identifier: BSD-3-Clause
// The bytes of the elements of some pools. src/types defines these functions, because it knows the types.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "boxplus/graph/edge_pool.h"
#include "boxplus/graph/vertex_pool.h"

namespace boxplus {

/// All estimates or error functions of a pool, with those of free slots, one after the other. Nothing if the
/// type is none of the common poses, points and edges, which have all of their data in themselves.
std::optional<std::span<const std::byte>> plain_elements(const detail::VertexPool& pool);
std::optional<std::span<const std::byte>> plain_elements(const detail::EdgePool& pool);

}  // namespace boxplus
