// SPDX-License-Identifier: BSD-3-Clause
// Edges of poses in the plane.
#include <typeinfo>

#include "g2o/core/cache.h"
#include "g2o/core/thread_safe.h"
#include "g2o/types/slam2d/edge_se2.h"
#include "g2o/types/slam2d/edge_se2_offset.h"
#include "g2o/types/slam2d/edge_se2_prior.h"
#include "g2o/types/slam2d/edge_se2_xyprior.h"
#include "types/ready_made_edge.h"
#include "types/slam2d/adapters_slam2d.h"

namespace g2o {
namespace internal {

template <>
struct EdgeModel<EdgeSE2> {
  using Native = boxplus::Between<boxplus::SE2>;
  static SE2 measured(const EdgeSE2& e) { return estimate<0>(e).inverse() * estimate<1>(e); }
  static SE2 first(const EdgeSE2& e) { return estimate<1>(e) * e.measurement().inverse(); }
  static SE2 second(const EdgeSE2& e) { return estimate<0>(e) * e.measurement(); }
};

template <>
struct EdgeModel<EdgeSE2Offset> {
  using Native = boxplus::OffsetBetween<boxplus::SE2>;
  static auto parameters(const EdgeSE2Offset& e) {
    return std::tuple(adapters::pose(e._offsetFrom->offset()), adapters::pose(e._offsetTo->offset()));
  }
  static SE2 measured(const EdgeSE2Offset& e) {
    return (estimate<0>(e) * e._offsetFrom->offset()).inverse() * (estimate<1>(e) * e._offsetTo->offset());
  }
  static SE2 motion(const EdgeSE2Offset& e) {
    return e._offsetFrom->offset() * e.measurement() * e._offsetTo->offset().inverse();
  }
  static SE2 first(const EdgeSE2Offset& e) { return estimate<1>(e) * motion(e).inverse(); }
  static SE2 second(const EdgeSE2Offset& e) { return estimate<0>(e) * motion(e); }
};

template <>
struct EdgeModel<EdgeSE2Prior> {
  using Native = boxplus::Prior<boxplus::SE2>;
  static SE2 measured(const EdgeSE2Prior& e) { return estimate<0>(e); }
  static SE2 first(const EdgeSE2Prior& e) { return e.measurement(); }
};

template <>
struct EdgeModel<EdgeSE2XYPrior> : NoInitialEstimate {
  using Native = boxplus::PositionPrior<boxplus::Vector2>;
  static Vector2 measured(const EdgeSE2XYPrior& e) { return estimate<0>(e).translation(); }
  static SE2 first(const EdgeSE2XYPrior& e) { return {e.measurement()[0], e.measurement()[1], 0}; }
};

template struct EdgeFunctions<EdgeSE2>;
template struct EdgeFunctions<EdgeSE2Offset>;
template struct EdgeFunctions<EdgeSE2Prior>;
template struct EdgeFunctions<EdgeSE2XYPrior>;

}  // namespace internal

EdgeSE2::EdgeSE2() = default;
EdgeSE2Prior::EdgeSE2Prior() = default;
EdgeSE2XYPrior::EdgeSE2XYPrior() = default;

EdgeSE2Offset::EdgeSE2Offset() {
  resizeParameters(2);
  installParameter(_offsetFrom, 0);
  installParameter(_offsetTo, 1);
}

bool EdgeSE2Offset::resolveCaches() {
  if (typeid(*this) == typeid(EdgeSE2Offset)) return true;
  resolveCache(_cacheFrom, vertexXn<0>(), "CACHE_SE2_OFFSET", {_offsetFrom});
  resolveCache(_cacheTo, vertexXn<1>(), "CACHE_SE2_OFFSET", {_offsetTo});
  return _cacheFrom != nullptr && _cacheTo != nullptr;
}

namespace {

const ThreadSafe<EdgeSE2> kThreadSafeSE2;
const ThreadSafe<EdgeSE2Prior> kThreadSafeSE2Prior;

}  // namespace
}  // namespace g2o
