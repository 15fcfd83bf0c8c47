// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/core/factory.h"
#include "g2o/types/slam3d_addons/edge_se3_euler.h"
#include "g2o/types/slam3d_addons/vertex_se3_euler.h"
#include "types/slam3d/adapters_slam3d.h"

G2O_USE_TYPE_GROUP(slam3d_addons)  // registers the tags for clients that use only these types

namespace g2o {
namespace {

Isometry3 read_motion(boxplus::FieldReader& in) {
  Vector6 v;
  in.numbers(v.data(), 6, "a coordinate or an angle");
  return internal::fromVectorET(v);
}

void write_motion(const Isometry3& motion, boxplus::FieldWriter& out) {
  const Vector6 v = internal::toVectorET(motion);
  for (const double x : v) out.number(x);
}

void scale_rotation(Matrix6& information, double factor) {
  information.bottomRows<3>() *= factor;
  information.rightCols<3>() *= factor;
}

}  // namespace

bool VertexSE3Euler::read(std::istream& is) {
  return adapters::read_fields(is, 6, [this](boxplus::FieldReader& in) { setEstimate(read_motion(in)); });
}

bool VertexSE3Euler::write(std::ostream& os) const {
  return adapters::write_fields(os, [this](boxplus::FieldWriter& out) { write_motion(_estimate, out); });
}

bool EdgeSE3Euler::read(std::istream& is) {
  return adapters::read_fields(is, 6 + adapters::omega_fields(_information),
                               [this](boxplus::FieldReader& in) {
                                 setMeasurement(read_motion(in));
                                 adapters::read_omega(in, _information);
                                 scale_rotation(_information, 2);
                               });
}

bool EdgeSE3Euler::write(std::ostream& os) const {
  return adapters::write_fields(os, [this](boxplus::FieldWriter& out) {
    write_motion(_measurement, out);
    Matrix6 omega = _information;
    scale_rotation(omega, 0.5);
    adapters::write_omega(omega, out);
  });
}

}  // namespace g2o
