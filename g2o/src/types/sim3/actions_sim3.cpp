// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/core/factory.h"
#include "g2o/types/sim3/types_seven_dof_expmap.h"
#include "g2o/types/slam3d/isometry3d_mappings.h"
#include "types/actions.h"

namespace g2o {

G2O_REGISTER_TYPE_GROUP(sim3_actions)

namespace {

using internal::Sketch;

/// The pose of a camera, given the similarity from the world to the camera.
Isometry3 pose_of(const Sim3& similarity) {
  const Sim3 inverse = similarity.inverse();
  Isometry3 pose = Isometry3::Identity();
  pose.linear() = inverse.rotation().toRotationMatrix();
  pose.translation() = inverse.translation();
  return pose;
}

struct Similarities {
  static constexpr int kDimension = 3;

  static std::optional<Vector3> place(const HyperGraph::Vertex* v) {
    if (const auto* cam = dynamic_cast<const VertexSim3Expmap*>(v))
      return pose_of(cam->estimate()).translation();
    if (const auto* point = dynamic_cast<const VertexPointXYZ*>(v)) return point->estimate();
    return {};
  }

  static Sketch sketch(const VertexSim3Expmap& v) {
    return Sketch::of_camera(pose_of(v.estimate()), internal::kPoseColor);
  }
  static Sketch sketch(const EdgeSim3& e) {
    return internal::sketch_of_edge<Similarities>(e, internal::kMotionColor);
  }
  template <class Image>
  static Sketch sketch(const Image& e) {
    return internal::sketch_of_edge<Similarities>(e, internal::kObservationColor);
  }

  /// Writes the pose in the same way as for VertexSE3, and then the scale.
  static bool write(const VertexSim3Expmap& v, std::ostream& os) {
    Vector7 numbers;
    numbers << internal::toVectorMQT(pose_of(v.estimate())), v.estimate().inverse().scale();
    internal::write_line(os, numbers);
    return true;
  }
  template <class Edge>
  static bool write(const Edge&, std::ostream&) {
    return false;
  }
};

const internal::RegisterActions<Similarities, VertexSim3Expmap, EdgeSim3, EdgeSim3ProjectXYZ,
                                EdgeInverseSim3ProjectXYZ>
    actions;

}  // namespace
}  // namespace g2o
