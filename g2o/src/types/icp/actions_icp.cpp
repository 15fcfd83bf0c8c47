// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/core/factory.h"
#include "g2o/types/icp/types_icp.h"
#include "types/actions.h"

namespace g2o {

G2O_REGISTER_TYPE_GROUP(icp_actions)

namespace {

using internal::Sketch;

struct Icp {
  static constexpr int kDimension = 3;

  static std::optional<Vector3> place(const HyperGraph::Vertex* v) {
    if (const auto* pose = dynamic_cast<const VertexSE3*>(v)) return pose->estimate().translation();
    if (const auto* point = dynamic_cast<const VertexPointXYZ*>(v)) return point->estimate();
    return {};
  }

  static Sketch sketch(const VertexSCam& v) { return Sketch::of_camera(v.estimate(), internal::kPoseColor); }
  /// A line between the two matched points.
  static Sketch sketch(const Edge_V_V_GICP& e) {
    if (!internal::is_complete(e)) return {};
    return Sketch::of_line(e.vertexXn<0>()->estimate() * e.measurement().pos0,
                           e.vertexXn<1>()->estimate() * e.measurement().pos1, internal::kObservationColor);
  }
  static Sketch sketch(const Edge_XYZ_VSC& e) {
    return internal::sketch_of_edge<Icp>(e, internal::kObservationColor);
  }

  static bool write(const VertexSCam& v, std::ostream& os) {
    internal::write_line(os, internal::toVectorMQT(v.estimate()));
    return true;
  }
  template <class Edge>
  static bool write(const Edge&, std::ostream&) {
    return false;
  }
};

const internal::RegisterActions<Icp, VertexSCam, Edge_V_V_GICP, Edge_XYZ_VSC> actions;

}  // namespace
}  // namespace g2o
