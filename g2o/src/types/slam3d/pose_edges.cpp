// SPDX-License-Identifier: BSD-3-Clause
// Edges of poses in space.
#include <tuple>
#include <typeinfo>

#include "g2o/core/cache.h"
#include "g2o/core/thread_safe.h"
#include "g2o/types/slam3d/edge_se3.h"
#include "g2o/types/slam3d/edge_se3_offset.h"
#include "g2o/types/slam3d/edge_se3_prior.h"
#include "g2o/types/slam3d/edge_se3_xyzprior.h"
#include "types/ready_made_edge.h"
#include "types/slam3d/adapters_slam3d.h"

namespace g2o {
namespace internal {

template <>
struct EdgeModel<EdgeSE3> {
  using Native = boxplus::Between<boxplus::SE3>;
  static Isometry3 measured(const EdgeSE3& e) { return estimate<0>(e).inverse() * estimate<1>(e); }
  static Isometry3 first(const EdgeSE3& e) { return estimate<1>(e) * e.measurement().inverse(); }
  static Isometry3 second(const EdgeSE3& e) { return estimate<0>(e) * e.measurement(); }
};

template <>
struct EdgeModel<EdgeSE3Offset> {
  using Native = boxplus::OffsetBetween<boxplus::SE3>;
  static auto parameters(const EdgeSE3Offset& e) {
    return std::tuple(adapters::pose(*e._offsetFrom), adapters::pose(*e._offsetTo));
  }
  static Isometry3 measured(const EdgeSE3Offset& e) {
    return (estimate<0>(e) * e._offsetFrom->offset()).inverse() * (estimate<1>(e) * e._offsetTo->offset());
  }
  static Isometry3 motion(const EdgeSE3Offset& e) {
    return e._offsetFrom->offset() * e.measurement() * e._offsetTo->inverseOffset();
  }
  static Isometry3 first(const EdgeSE3Offset& e) { return estimate<1>(e) * motion(e).inverse(); }
  static Isometry3 second(const EdgeSE3Offset& e) { return estimate<0>(e) * motion(e); }
};

template <>
struct EdgeModel<EdgeSE3Prior> {
  using Native = boxplus::OffsetPrior<boxplus::SE3>;
  static auto parameters(const EdgeSE3Prior& e) { return std::tuple(adapters::pose(*e.offsetParameter())); }
  static Isometry3 measured(const EdgeSE3Prior& e) { return estimate<0>(e) * e.offsetParameter()->offset(); }
  static Isometry3 first(const EdgeSE3Prior& e) {
    return e.measurement() * e.offsetParameter()->inverseOffset();
  }
};

template <>
struct EdgeModel<EdgeSE3XYZPrior> : NoInitialEstimate {
  using Native = boxplus::PositionPrior<boxplus::Vector3>;
  static std::tuple<> parameters(const EdgeSE3XYZPrior&) { return {}; }  // the error does not use the offset
  static Vector3 measured(const EdgeSE3XYZPrior& e) { return estimate<0>(e).translation(); }
  static Isometry3 first(const EdgeSE3XYZPrior& e) {
    Isometry3 moved = estimate<0>(e);
    moved.translation() = e.measurement();
    return moved;
  }
};

template struct EdgeFunctions<EdgeSE3>;
template struct EdgeFunctions<EdgeSE3Offset>;
template struct EdgeFunctions<EdgeSE3Prior>;
template struct EdgeFunctions<EdgeSE3XYZPrior>;

}  // namespace internal

EdgeSE3::EdgeSE3() = default;

EdgeSE3Offset::EdgeSE3Offset() {
  resizeParameters(2);
  installParameter(_offsetFrom, 0);
  installParameter(_offsetTo, 1);
}

bool EdgeSE3Offset::resolveCaches() {
  if (typeid(*this) == typeid(EdgeSE3Offset)) return true;
  resolveCache(_cacheFrom, vertexXn<0>(), "CACHE_SE3_OFFSET", {_offsetFrom});
  resolveCache(_cacheTo, vertexXn<1>(), "CACHE_SE3_OFFSET", {_offsetTo});
  return _cacheFrom != nullptr && _cacheTo != nullptr;
}

EdgeSE3Prior::EdgeSE3Prior() {
  resizeParameters(1);
  installParameter(offsetParam, 0);
}

bool EdgeSE3Prior::resolveCaches() {
  if (typeid(*this) == typeid(EdgeSE3Prior)) return true;
  resolveCache(_cache, vertexXn<0>(), "CACHE_SE3_OFFSET", {offsetParam});
  return _cache != nullptr;
}

EdgeSE3XYZPrior::EdgeSE3XYZPrior() {
  resizeParameters(1);
  installParameter(offsetParam, 0);
}

bool EdgeSE3XYZPrior::resolveCaches() {
  if (typeid(*this) == typeid(EdgeSE3XYZPrior)) return true;
  resolveCache(_cache, vertexXn<0>(), "CACHE_SE3_OFFSET", {offsetParam});
  return _cache != nullptr;
}

namespace {

const ThreadSafe<EdgeSE3> kThreadSafeSE3;

}  // namespace
}  // namespace g2o
