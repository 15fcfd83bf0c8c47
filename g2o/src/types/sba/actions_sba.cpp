// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/core/factory.h"
#include "g2o/types/sba/types_six_dof_expmap.h"
#include "types/actions.h"

namespace g2o {

G2O_REGISTER_TYPE_GROUP(sba_actions)

namespace {

using internal::Sketch;

struct Sba {
  static constexpr int kDimension = 3;

  static std::optional<Vector3> place(const HyperGraph::Vertex* v) {
    if (const auto* cam = dynamic_cast<const VertexCam*>(v)) return cam->estimate().translation();
    if (const auto* cam = dynamic_cast<const VertexSE3Expmap*>(v))
      return cam->estimate().inverse().translation();
    if (const auto* point = dynamic_cast<const VertexPointXYZ*>(v)) return point->estimate();
    return {};
  }

  static Sketch sketch(const VertexCam& v) { return Sketch::of_camera(v.estimate(), internal::kPoseColor); }
  static Sketch sketch(const VertexSE3Expmap& v) {
    return Sketch::of_camera(v.estimate().inverse(), internal::kPoseColor);
  }
  static Sketch sketch(const VertexSBAPointXYZ& v) { return Sketch::of_point(v.estimate()); }
  static Sketch sketch(const EdgeSBACam& e) { return of_motion(e); }
  static Sketch sketch(const EdgeSBAScale& e) { return of_motion(e); }
  static Sketch sketch(const EdgeSE3Expmap& e) { return of_motion(e); }
  static Sketch sketch(const EdgeSE3ProjectXYZOnlyPose& e) { return of_known_point(e); }
  static Sketch sketch(const EdgeStereoSE3ProjectXYZOnlyPose& e) { return of_known_point(e); }
  template <class Image>
  static Sketch sketch(const Image& e) {
    return internal::sketch_of_edge<Sba>(e, internal::kObservationColor);
  }

  static bool write(const VertexCam& v, std::ostream& os) { return write_pose(v.estimate(), os); }
  static bool write(const VertexSE3Expmap& v, std::ostream& os) {
    return write_pose(v.estimate().inverse(), os);
  }
  static bool write(const VertexSBAPointXYZ& v, std::ostream& os) {
    internal::write_line(os, v.estimate());
    return true;
  }
  template <class Edge>
  static bool write(const Edge&, std::ostream&) {
    return false;
  }

 private:
  static Sketch of_motion(const HyperGraph::Edge& e) {
    return internal::sketch_of_edge<Sba>(e, internal::kMotionColor);
  }
  template <class OnlyPose>
  static Sketch of_known_point(const OnlyPose& e) {
    const std::optional<Vector3> from = place(e.vertex(0));
    return from ? Sketch::of_line(*from, e.Xw, internal::kObservationColor) : Sketch();
  }
  static bool write_pose(const SE3Quat& pose, std::ostream& os) {
    internal::write_line(os, pose.toMinimalVector());
    return true;
  }
};

const internal::RegisterActions<Sba, VertexCam, VertexSBAPointXYZ, EdgeProjectP2MC, EdgeProjectP2SC,
                                EdgeSBACam, EdgeSBAScale>
    cameras;
const internal::RegisterActions<Sba, VertexSE3Expmap, EdgeSE3Expmap, EdgeProjectXYZ2UV, EdgeProjectXYZ2UVU,
                                EdgeSE3ProjectXYZ, EdgeSE3ProjectXYZOnlyPose, EdgeStereoSE3ProjectXYZ,
                                EdgeStereoSE3ProjectXYZOnlyPose>
    exponential;

}  // namespace
}  // namespace g2o
