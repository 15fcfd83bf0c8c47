// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/core/factory.h"
#include "g2o/types/sclam2d/types_sclam2d.h"
#include "types/actions.h"
#include "types/slam2d/lift.h"

namespace g2o {

G2O_REGISTER_TYPE_GROUP(sclam2d_actions)

namespace {

using internal::Sketch;

struct Sclam2d {
  static constexpr int kDimension = 2;

  /// The motion of the robot. The third vertex, a calibration, has no position in the world.
  template <class Edge>
  static Sketch sketch(const Edge& e) {
    const auto *from = e.template vertexXn<0>(), *to = e.template vertexXn<1>();
    if (from == nullptr || to == nullptr) return {};
    return Sketch::of_line(internal::lift(from->estimate().translation()),
                           internal::lift(to->estimate().translation()), internal::kMotionColor);
  }
  template <class Edge>
  static bool write(const Edge&, std::ostream&) {
    return false;
  }
};

const internal::RegisterActions<Sclam2d, EdgeSE2SensorCalib, EdgeSE2OdomDifferentialCalib> actions;

}  // namespace

EdgeSE2SensorCalibDrawAction::EdgeSE2SensorCalibDrawAction()
    : NamedAction(std::make_unique<internal::DrawElementAction<Sclam2d, EdgeSE2SensorCalib>>()) {}
EdgeSE2OdomDifferentialCalibDrawAction::EdgeSE2OdomDifferentialCalibDrawAction()
    : NamedAction(std::make_unique<internal::DrawElementAction<Sclam2d, EdgeSE2OdomDifferentialCalib>>()) {}

}  // namespace g2o
