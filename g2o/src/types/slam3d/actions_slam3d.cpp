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

  static Vector3 place(const VertexSE3& v) { return v.estimate().translation(); }
  static Vector3 place(const VertexPointXYZ& v) { return v.estimate(); }

  static Sketch sketch(const VertexSE3& v) { return Sketch::of_pose(v.estimate()); }
  static Sketch sketch(const VertexPointXYZ& v) { return Sketch::of_point(v.estimate()); }
  static Sketch sketch(const CacheSE3Offset& cache) { return Sketch::of_sensor(cache.n2w()); }
  static Sketch sketch(const EdgeSE3& e) {
    return internal::sketch_of_motion(e, [](const Isometry3& x) { return x; });
  }
  static Sketch sketch(const EdgeSE3Offset& e) {
    if (!internal::is_complete(e)) return {};
    return internal::sketch_of_edge<Slam3d>(e, internal::kMotionColor);
  }
  /// A prior: from the estimate to where it should be; for the whole pose, of the sensor.
  static Sketch sketch(const EdgeSE3Prior& e) {
    if (!internal::is_complete(e) || e.offsetParameter() == nullptr) return {};
    const Isometry3 sensor = e.vertexXn<0>()->estimate() * e.offsetParameter()->offset();
    return Sketch::of_line(sensor.translation(), e.measurement().translation(), internal::kPriorColor);
  }
  static Sketch sketch(const EdgeSE3XYZPrior& e) { return sketch_of_prior(e); }
  static Sketch sketch(const EdgeXYZPrior& e) { return sketch_of_prior(e); }
  template <class Observation>
  static Sketch sketch(const Observation& e) {
    if (!internal::is_complete(e)) return {};
    return internal::sketch_of_edge<Slam3d>(e, internal::kObservationColor);
  }

  static bool write(const VertexSE3& v, std::ostream& os) {
    os << internal::toVectorMQT(v.estimate()).transpose() << '\n';
    return true;
  }
  static bool write(const VertexPointXYZ& v, std::ostream& os) {
    os << v.estimate().transpose() << '\n';
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

 private:
  template <class Prior>
  static Sketch sketch_of_prior(const Prior& e) {
    if (!internal::is_complete(e)) return {};
    return Sketch::of_line(place(*e.template vertexXn<0>()), e.measurement(), internal::kPriorColor);
  }
};

const internal::RegisterActions<Slam3d, VertexSE3, VertexPointXYZ, EdgeSE3, EdgeSE3PointXYZ, EdgeSE3Prior,
                                EdgeSE3XYZPrior, EdgeSE3Offset, EdgePointXYZ, EdgeXYZPrior>
    actions;
const RegisterActionProxy<internal::DrawElementAction<Slam3d, CacheSE3Offset>> draw_cache;

}  // namespace
}  // namespace g2o
