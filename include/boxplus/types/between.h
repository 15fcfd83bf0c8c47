// SPDX-License-Identifier: BSD-3-Clause
// The relative measurement between two vertices of one type: Between(SE2(1, 0, 0)).
#pragma once

#include <array>
#include <type_traits>
#include <utility>

#include "boxplus/graph/stored_estimate.h"
#include "boxplus/graph/typed_edge_pool.h"
#include "boxplus/types/pose_math.h"
#include "boxplus/types/slam2d/between_jacobians.h"
#include "boxplus/types/slam3d/between_jacobians.h"
#include "boxplus/types/type_label.h"
#include "boxplus/types/vertex_pools.h"

namespace boxplus {

namespace detail {
struct BetweenText {
  static constexpr std::string_view kText = "Between";
};
}  // namespace detail

/// z measures b relative to a. Error: (a⁻¹ b) ⊟ z, in the units of T's tangent. The table shows the error for
/// each T, and the tag in g2o files:
///   SE2  (x, y, θ) of z⁻¹ a⁻¹ b                                       EDGE_SE2
///   SE3  (t, q_v) of z⁻¹ a⁻¹ b, with the sign of q that has w ≥ 0     EDGE_SE3:QUAT
///   Vector2, Vector3  (b − a) − z                                     EDGE_POINTXY, EDGE_POINTXYZ
/// Besides these types, T may be any type whose trait Manifold<T> has kDim, ominus, cast and Rebind. To
/// compute the motion from a to b, the edge uses the first of the expressions a.inverse_times(b), b − a and
/// a.inverse() * b that compiles; the result must be a T. For exact Jacobians, the expression must also
/// accept T over dual numbers (Rebind), and T must have a member type Scalar. T cannot be a Product, because
/// no such expression compiles for it.
template <class T>
struct Between {
  static constexpr std::string_view kName = detail::TypeLabel<detail::BetweenText, T>::kValue;
  static constexpr bool kJacobiansForSomeTypes = true;
  static constexpr bool kRigid = detail::kIsPose<T>;
  T measurement;

  explicit Between(T z) : measurement(std::move(z)) {}

  template <class X>
  auto error(const X& a, const X& b) const {
    return detail::difference(detail::motion_between(a, b), measurement);
  }

  template <class A, class B>
  requires requires(const T& x, A& J) { detail::between_jacobians(x, x, x, J, J); }
  void jacobians(const T& a, const T& b, A& J_a, B& J_b) const {
    detail::between_jacobians(measurement, a, b, J_a, J_b);
  }

  detail::RelativeFrame relative_frame(const T&, const T&) const requires detail::FrameType<T> {
    return detail::relative_pose(0, 1, measurement);
  }
};

template <class T>
Between(T) -> Between<detail::StoredEstimate<T>>;

namespace detail {
/// Computes the errors and, unless `jacobian` is null, the Jacobians of several Between<SE2> or Between<SE3>
/// at once, with the dense kernels, one edge per SIMD lane. The arguments `measurement`, `from` and `to`
/// point to the values of each edge's measurement and poses.
void linearize_between(std::type_identity<SE2>, int count, const double* const* measurement,
                       const double* const* from, const double* const* to, double* error, double* jacobian);
void linearize_between(std::type_identity<SE3>, int count, const double* const* measurement,
                       const double* const* from, const double* const* to, double* error, double* jacobian);
}  // namespace detail

template <class T>
requires std::is_same_v<T, SE2> || std::is_same_v<T, SE3>
struct detail::LaneKernel<Between<T>, T, T> {
  static constexpr bool kExists = true;
  static constexpr int kSources = 3;
  static std::array<const double*, kSources> sources(const Between<T>& edge, const T& from, const T& to) {
    return {edge.measurement.data(), from.data(), to.data()};
  }
  static void linearize(int count, const detail::LaneSources<kSources>& sources, double* error,
                        double* jacobian) {
    detail::linearize_between(std::type_identity<T>(), count, sources[0].data(), sources[1].data(),
                              sources[2].data(), error, jacobian);
  }
};

}  // namespace boxplus

namespace boxplus::detail {

extern template class TypedEdgePool<Between<SE2>, SE2, SE2>;
extern template class TypedEdgePool<Between<SE3>, SE3, SE3>;
extern template class TypedEdgePool<Between<Vector2>, Vector2, Vector2>;
extern template class TypedEdgePool<Between<Vector3>, Vector3, Vector3>;

}  // namespace boxplus::detail
