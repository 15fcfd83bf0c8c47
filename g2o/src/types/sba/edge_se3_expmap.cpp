// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/types/sba/edge_se3_expmap.h"

#include "types/exponential.h"
#include "types/ready_made_edge.h"
#include "types/sba/adapters_sba.h"

namespace g2o {

namespace internal {

template <>
struct EdgeModel<EdgeSE3Expmap> {
  static Vector6 error(const EdgeSE3Expmap& e) {
    return (estimate<1>(e).inverse() * e.measurement() * estimate<0>(e)).log();
  }
  // Let E = T₂⁻¹ z T₁. A step δ of T₁ changes E to exp(Ad δ) E with the adjoint Ad of T₂⁻¹ z. A step δ of T₂
  // changes E to exp(−Ad δ) E with the adjoint Ad of T₂⁻¹.
  static void linearize(EdgeSE3Expmap& e) {
    const SE3Quat inverse = estimate<1>(e).inverse(), left = inverse * e.measurement();
    const Matrix6 J = adapters::left_jacobian_of_log(left * estimate<0>(e));
    e.jacobianOplusXn<0>() = J * left.adj();
    e.jacobianOplusXn<1>() = -J * inverse.adj();
  }
  static SE3Quat from_file(boxplus::FieldReader& in) {
    return adapters::to_se3quat(boxplus::FileFields<boxplus::SE3>::read(in)).inverse();
  }
  static void to_file(const EdgeSE3Expmap& e, boxplus::FieldWriter& out) {
    boxplus::FileFields<boxplus::SE3>::write(adapters::pose(e.measurement().inverse()), out);
  }
  static SE3Quat measured(const EdgeSE3Expmap& e) { return estimate<1>(e) * estimate<0>(e).inverse(); }
  static SE3Quat first(const EdgeSE3Expmap& e) { return e.measurement().inverse() * estimate<1>(e); }
  static SE3Quat second(const EdgeSE3Expmap& e) { return e.measurement() * estimate<0>(e); }
};

template struct EdgeFunctions<EdgeSE3Expmap>;

}  // namespace internal

EdgeSE3Expmap::EdgeSE3Expmap() = default;

}  // namespace g2o
