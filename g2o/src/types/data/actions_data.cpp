// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "g2o/types/data/types_data.h"
#include "g2o/types/slam2d/vertex_se2.h"
#include "g2o/types/slam3d/vertex_se3.h"
#include "types/data/adapters_data.h"
#include "types/slam2d/lift.h"

namespace g2o {

G2O_REGISTER_TYPE_GROUP(data_actions)

namespace {

using internal::lift;

constexpr Color kScanColor{0.35, 0.45, 0.55, 0.8}, kTagColor{0.12, 0.16, 0.22, 1},
    kEllipseColor{0.11, 0.30, 0.65, 0.8};

/// The pose of the vertex that the data belongs to; no value if the data belongs to no pose.
std::optional<Isometry3> pose_of(const HyperGraph::Data& data) {
  if (const auto* planar = dynamic_cast<const VertexSE2*>(data.dataContainer()))
    return lift(planar->estimate());
  if (const auto* spatial = dynamic_cast<const VertexSE3*>(data.dataContainer())) return spatial->estimate();
  return {};
}

/// The action "draw" of data of type T.
template <class T>
class DataDrawAction : public DrawAction {
 public:
  DataDrawAction() : DrawAction(typeid(T).name()) {}

  HyperGraphElementAction* operator()(HyperGraph::HyperGraphElement* element,
                                      HyperGraphElementAction::Parameters* parameters) override {
    return (*this)(static_cast<const HyperGraph::HyperGraphElement*>(element), parameters);
  }
  HyperGraphElementAction* operator()(const HyperGraph::HyperGraphElement* element,
                                      HyperGraphElementAction::Parameters* parameters) override {
    if (typeid(*element).name() != _typeName || !refreshPropertyPtrs(parameters)) return nullptr;
    if (_show != nullptr && !_show->value()) return this;
    const T& data = dynamic_cast<const T&>(*element);
    if (const std::optional<Isometry3> pose = pose_of(data)) draw(data, *pose, *_previousParams->drawing);
    return this;
  }

 private:
  virtual void draw(const T& data, const Isometry3& pose, Drawing& drawing) = 0;
};

template <class T>
class LaserDraw : public DataDrawAction<T> {
  static SE2 laser_on_robot(const RawLaser& laser) { return laser.laserParams().laserPose; }

  void draw(const T& laser, const Isometry3& pose, Drawing& drawing) override {
    const std::string prefix = this->_typeName + "::";
    const auto* step =
        this->_previousParams->template makeProperty<IntProperty>(prefix + "BEAMS_DOWNSAMPLING", 1);
    const auto stride = static_cast<std::size_t>(std::max(1, step == nullptr ? 1 : step->value()));
    const double size = this->property("POINT_SIZE", 1), max_range = this->property("MAX_RANGE", -1);
    boxplus::LaserScan scan = adapters::scan_of(laser);
    if (max_range >= 0) scan.max_range = std::min(scan.max_range, max_range);
    std::size_t kept = 0;
    for (std::size_t k = 0; k < scan.ranges.size(); k += stride) scan.ranges[kept++] = scan.ranges[k];
    scan.ranges.resize(kept);
    scan.angular_step *= static_cast<double>(stride);
    for (const auto& point : scan.end_points())
      drawing.point(pose * lift(laser_on_robot(laser) * Vector2(point[0], point[1])), kScanColor, size);
  }
};

class TagDraw : public DataDrawAction<VertexTag> {
  void draw(const VertexTag& tag, const Isometry3& pose, Drawing& drawing) override {
    drawing.text(pose * tag.position().cast<double>(), tag.name(), kTagColor, property("TEXT_SIZE", 1));
  }
};

class EllipseDraw : public DataDrawAction<VertexEllipse> {
  void draw(const VertexEllipse& ellipse, const Isometry3& pose, Drawing& drawing) override {
    constexpr int kCorners = 32;
    constexpr double kTurn = 6.283185307179586;
    const double scale = property("SCALING_FACTOR", 1), width = property("LINE_WIDTH", 1);
    const Vector2 axes = scale * ellipse.singularValues().cast<double>().cwiseMax(0).cwiseSqrt();
    std::vector<Vector3> corners;
    for (int k = 0; k < kCorners; ++k) {
      const double angle = kTurn * k / kCorners;
      const Vector2 on_circle(std::cos(angle), std::sin(angle));
      corners.push_back(pose * lift(Vector2(ellipse.U().cast<double>() * axes.cwiseProduct(on_circle))));
    }
    drawing.polyline(corners, true, kEllipseColor, width);
    const double sigma = scale * std::sqrt(std::max(0.0F, ellipse.covariance()(2, 2)));
    for (const double side : {-sigma, sigma}) {
      const Vector2 heading(axes[0] * std::cos(side), axes[0] * std::sin(side));
      drawing.line(pose.translation(), pose * lift(heading), kEllipseColor, width);
    }
    for (const Vector2F& match : ellipse.matchingVertices())
      drawing.line(pose.translation(), pose * lift(Vector2(match.cast<double>())), kScanColor, width);
  }
};

const RegisterActionProxy<LaserDraw<RobotLaser>> draw_robot_laser;
const RegisterActionProxy<LaserDraw<RawLaser>> draw_raw_laser;
const RegisterActionProxy<TagDraw> draw_tag;
const RegisterActionProxy<EllipseDraw> draw_ellipse;

}  // namespace

RobotLaserDrawAction::RobotLaserDrawAction() : NamedAction(std::make_unique<LaserDraw<RobotLaser>>()) {}
VertexTagDrawAction::VertexTagDrawAction() : NamedAction(std::make_unique<TagDraw>()) {}
VertexEllipseDrawAction::VertexEllipseDrawAction() : NamedAction(std::make_unique<EllipseDraw>()) {}

}  // namespace g2o
