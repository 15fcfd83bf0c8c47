// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/core/factory.h"
#include "g2o/types/slam3d/types_slam3d.h"
#include "types/actions.h"

namespace g2o {

G2O_REGISTER_TYPE_GROUP(slam3d_actions)

namespace {

using internal::Sketch;

struct Slam3d {
  static constexpr int kDimension = 3;

  static std::optional<Vector3> place(const HyperGraph::Vertex* v) {
    if (const auto* pose = dynamic_cast<const VertexSE3*>(v)) return pose->estimate().translation();
    if (const auto* point = dynamic_cast<const VertexPointXYZ*>(v)) return point->estimate();
    return {};
  }

  static Sketch sketch(const VertexSE3& v) { return Sketch::of_pose(v.estimate()); }
  static Sketch sketch(const VertexPointXYZ& v) { return Sketch::of_point(v.estimate()); }
  static Sketch sketch(const CacheSE3Offset& cache) { return Sketch::of_sensor(cache.n2w()); }
  static Sketch sketch(const CacheCamera& cache) {
    return Sketch::of_camera(cache.n2w(), internal::kSensorColor);
  }
  static Sketch sketch(const EdgeSE3& e) {
    return internal::sketch_of_motion(e, [](const Isometry3& x) { return x; });
  }
  static Sketch sketch(const EdgeSE3Offset& e) {
    return internal::sketch_of_edge<Slam3d>(e, internal::kMotionColor);
  }
  static Sketch sketch(const EdgeSE3PointXYZ& e) {
    return internal::sketch_of_observation<Slam3d>(e, [&](const Isometry3& x) {
      const auto* sensor = e.offsetParameter();
      return Vector3(sensor == nullptr ? x * e.measurement() : x * (sensor->offset() * e.measurement()));
    });
  }
  /// A line from the sensor to its measured position.
  static Sketch sketch(const EdgeSE3Prior& e) {
    if (!internal::is_complete(e) || e.offsetParameter() == nullptr) return {};
    const Isometry3 sensor = e.vertexXn<0>()->estimate() * e.offsetParameter()->offset();
    return Sketch::of_line(sensor.translation(), e.measurement().translation(), internal::kPriorColor);
  }
  static Sketch sketch(const EdgeSE3XYZPrior& e) {
    return internal::sketch_of_prior<Slam3d>(e, e.measurement());
  }
  static Sketch sketch(const EdgeXYZPrior& e) {
    return internal::sketch_of_prior<Slam3d>(e, e.measurement());
  }
  template <class Observation>
  static Sketch sketch(const Observation& e) {
    return internal::sketch_of_edge<Slam3d>(e, internal::kObservationColor);
  }

  static bool write(const VertexSE3& v, std::ostream& os) {
    internal::write_line(os, internal::toVectorMQT(v.estimate()));
    return true;
  }
  static bool write(const VertexPointXYZ& v, std::ostream& os) {
    internal::write_line(os, v.estimate());
    return true;
  }
  static bool write(const EdgeSE3& e, std::ostream& os) {
    write(*e.vertexXn<0>(), os);
    write(*e.vertexXn<1>(), os);
    os << '\n';
    return true;
  }
  template <class Edge>
  static bool write(const Edge&, std::ostream&) {
    return false;
  }
};

const internal::RegisterActions<Slam3d, VertexSE3, VertexPointXYZ, EdgeSE3, EdgeSE3PointXYZ, EdgeSE3Prior,
                                EdgeSE3XYZPrior, EdgeSE3Offset, EdgePointXYZ, EdgeXYZPrior,
                                EdgeSE3PointXYZDepth, EdgeSE3PointXYZDisparity, EdgeSE3LotsOfXYZ>
    actions;
const RegisterActionProxy<internal::DrawElementAction<Slam3d, CacheSE3Offset>> draw_cache;
const RegisterActionProxy<internal::DrawElementAction<Slam3d, CacheCamera>> draw_camera;

}  // namespace

VertexSE3WriteGnuplotAction::VertexSE3WriteGnuplotAction()
    : NamedAction(std::make_unique<internal::GnuplotAction<Slam3d, VertexSE3>>()) {}
VertexSE3DrawAction::VertexSE3DrawAction()
    : NamedAction(std::make_unique<internal::DrawElementAction<Slam3d, VertexSE3>>()) {}
VertexPointXYZWriteGnuplotAction::VertexPointXYZWriteGnuplotAction()
    : NamedAction(std::make_unique<internal::GnuplotAction<Slam3d, VertexPointXYZ>>()) {}
VertexPointXYZDrawAction::VertexPointXYZDrawAction()
    : NamedAction(std::make_unique<internal::DrawElementAction<Slam3d, VertexPointXYZ>>()) {}
EdgeSE3WriteGnuplotAction::EdgeSE3WriteGnuplotAction()
    : NamedAction(std::make_unique<internal::GnuplotAction<Slam3d, EdgeSE3>>()) {}
EdgeSE3DrawAction::EdgeSE3DrawAction()
    : NamedAction(std::make_unique<internal::DrawElementAction<Slam3d, EdgeSE3>>()) {}
EdgeSE3PointXYZDrawAction::EdgeSE3PointXYZDrawAction()
    : NamedAction(std::make_unique<internal::DrawElementAction<Slam3d, EdgeSE3PointXYZ>>()) {}
EdgeProjectDisparityDrawAction::EdgeProjectDisparityDrawAction()
    : NamedAction(std::make_unique<internal::DrawElementAction<Slam3d, EdgeSE3PointXYZDisparity>>()) {}
CacheSE3OffsetDrawAction::CacheSE3OffsetDrawAction()
    : NamedAction(std::make_unique<internal::DrawElementAction<Slam3d, CacheSE3Offset>>()) {}
CacheCameraDrawAction::CacheCameraDrawAction()
    : NamedAction(std::make_unique<internal::DrawElementAction<Slam3d, CacheCamera>>()) {}

}  // namespace g2o
