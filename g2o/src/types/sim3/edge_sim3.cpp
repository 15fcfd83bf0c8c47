// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/types/sim3/edge_sim3.h"

#include "g2o/core/factory.h"
#include "types/exponential.h"
#include "types/ready_made_edge.h"
#include "types/sim3/usable_sim3.h"

G2O_USE_TYPE_GROUP(sim3)  // registers the tags for clients that use only these types

namespace g2o {
namespace {

/// The adjoint of S: the matrix Ad with exp(Ad δ) = S exp(δ) S⁻¹.
Matrix7 adjoint(const Sim3& S) {
  const Matrix3 R = S.rotation().toRotationMatrix();
  Matrix7 Ad = Matrix7::Zero();
  Ad.topLeftCorner<3, 3>() = R;
  Ad.block<3, 3>(3, 0) = skew(S.translation()) * R;
  Ad.block<3, 3>(3, 3) = S.scale() * R;
  Ad.block<3, 1>(3, 6) = -S.translation();
  Ad(6, 6) = 1;
  return Ad;
}

}  // namespace

namespace internal {

template <>
struct MeasurementAdapter<Sim3> {};  // as in g2o, there are no measurement data

template <>
struct EdgeModel<EdgeSim3> {
  static Vector7 error(const EdgeSim3& e) {
    return (e.measurement() * estimate<0>(e) * estimate<1>(e).inverse()).log();
  }
  // Let E = z S₁ S₂⁻¹. A step δ of S₁ changes E to exp(Ad_z δ) E. A step δ of S₂ changes E to E exp(−δ) =
  // exp(−Ad_E δ) E.
  static void linearize(EdgeSim3& e) {
    const Sim3 E = e.measurement() * estimate<0>(e) * estimate<1>(e).inverse();
    const Matrix7 J =
        adapters::left_jacobian_of_log(adapters::similarity(E.rotation(), E.translation(), E.scale()));
    auto &Xi = e.jacobianOplusXn<0>(), &Xj = e.jacobianOplusXn<1>();
    Xi = J * adjoint(e.measurement());
    Xj = -J * adjoint(E);
    if (e.vertexXn<0>()->_fix_scale) Xi.col(6).setZero();
    if (e.vertexXn<1>()->_fix_scale) Xj.col(6).setZero();
  }
  static constexpr int kFields = 7;
  static Sim3 from_file(boxplus::FieldReader& in) {
    const Sim3 measured(Vector7{boxplus::FileFields<boxplus::Vector<double, 7>>::read(in)});
    if (!adapters::is_usable(measured)) throw boxplus::Error(adapters::kExpectedUsableSim3);
    return measured.inverse();
  }
  static void to_file(const EdgeSim3& e, boxplus::FieldWriter& out) {
    boxplus::FileFields<boxplus::Vector<double, 7>>::write(e.measurement().inverse().log(), out);
  }
  static Sim3 measured(const EdgeSim3& e) { return estimate<1>(e) * estimate<0>(e).inverse(); }
  static Sim3 first(const EdgeSim3& e) { return e.measurement().inverse() * estimate<1>(e); }
  static Sim3 second(const EdgeSim3& e) { return e.measurement() * estimate<0>(e); }
};

template struct EdgeFunctions<EdgeSim3>;

}  // namespace internal

EdgeSim3::EdgeSim3() = default;

bool EdgeSim3::write(std::ostream& os) const {
  return adapters::is_usable(_measurement) && ReadyMadeEdge::write(os);
}

}  // namespace g2o
