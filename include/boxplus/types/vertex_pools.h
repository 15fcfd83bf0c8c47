// SPDX-License-Identifier: BSD-3-Clause
// Declares that the pools of poses and points are compiled only once, in the library.
#pragma once

#include "boxplus/graph/typed_vertex_pool.h"

namespace boxplus::detail {

extern template class TypedVertexPool<SE2>;
extern template class TypedVertexPool<SE3>;
extern template class TypedVertexPool<Vector2>;
extern template class TypedVertexPool<Vector3>;

}  // namespace boxplus::detail
