// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/types/slam3d_addons/edge_se3_calib.h"

#include "g2o/core/factory.h"
#include "types/ready_made_edge.h"
#include "types/slam3d/adapters_slam3d.h"

G2O_USE_TYPE_GROUP(slam3d_addons)  // registers the tags for clients that use only these types

namespace g2o {
namespace internal {

template <>
struct EdgeModel<EdgeSE3Calib> : GuessedFromOther<EdgeSE3Calib> {
  using Native = boxplus::OffsetBetween<boxplus::SE3>;
  static Isometry3 measured(const EdgeSE3Calib& e) {
    const Isometry3& sensor = estimate<2>(e);
    return (estimate<0>(e) * sensor).inverse() * (estimate<1>(e) * sensor);
  }
  static bool possible(const EdgeSE3Calib& e, const OptimizableGraph::VertexSet& from,
                       const OptimizableGraph::Vertex* to) {
    return from.count(e.vertices()[2]) > 0 && to != e.vertices()[2];
  }
  static Isometry3 motion(const EdgeSE3Calib& e) {
    return estimate<2>(e) * e.measurement() * estimate<2>(e).inverse();
  }
  static Isometry3 first(const EdgeSE3Calib& e) { return estimate<1>(e) * motion(e).inverse(); }
  static Isometry3 second(const EdgeSE3Calib& e) { return estimate<0>(e) * motion(e); }
};

template struct EdgeFunctions<EdgeSE3Calib>;

}  // namespace internal

EdgeSE3Calib::EdgeSE3Calib() = default;

}  // namespace g2o
