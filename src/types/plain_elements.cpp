// SPDX-License-Identifier: BSD-3-Clause
#include "covariance/plain_elements.h"

#include <type_traits>
#include <typeinfo>
#include <utility>

#include "boxplus/types/between.h"
#include "boxplus/types/slam2d.h"
#include "boxplus/types/slam3d.h"

namespace boxplus {
namespace {

using detail::TypedEdgePool;
using detail::TypedVertexPool;
using Bytes = std::span<const std::byte>;

/// The elements of a pool, if its type is one of `Pools`.
template <class... Pools, class Base>
std::optional<Bytes> elements_of(const Base& pool) {
  std::optional<Bytes> bytes;
  const auto try_type = [&]<class Pool>(std::type_identity<Pool>) {
    using Element = std::remove_cvref_t<decltype(std::declval<const Pool&>().value(0))>;
    static_assert(std::is_standard_layout_v<Element> && std::is_trivially_destructible_v<Element>);
    if (typeid(pool) != typeid(Pool)) return;
    bytes = Bytes();
    if (pool.slots() > 0)
      bytes = std::as_bytes(std::span(&static_cast<const Pool&>(pool).value(0), pool.slots()));
  };
  (try_type(std::type_identity<Pools>()), ...);
  return bytes;
}

}  // namespace

std::optional<Bytes> plain_elements(const detail::VertexPool& pool) {
  return elements_of<TypedVertexPool<SE2>, TypedVertexPool<SE3>, TypedVertexPool<Vector2>,
                     TypedVertexPool<Vector3>>(pool);
}

std::optional<Bytes> plain_elements(const detail::EdgePool& pool) {
  return elements_of<TypedEdgePool<Between<SE2>, SE2, SE2>, TypedEdgePool<Between<SE3>, SE3, SE3>,
                     TypedEdgePool<PointObservation2, SE2, Vector2>,
                     TypedEdgePool<PointObservation3, SE3, Vector3>>(pool);
}

}  // namespace boxplus
