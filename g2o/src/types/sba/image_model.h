// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "types/ready_made_edge.h"
#include "types/sba/adapters_sba.h"

namespace g2o {
namespace internal {

/// The base of the model of an edge that measures the image of a point in a camera T. The point is vertex 0,
/// or the member Xw. The model has a function camera(), which returns the pinhole camera of an edge.
template <class Edge>
struct ImageModel {
  static constexpr int kRows = Edge::Dimension;
  static constexpr bool kIsPointVertex = Edge::_nr_of_vertices == 2;

  static Vector3 point_in_camera(const Edge& e) {
    if constexpr (kIsPointVertex) {
      return adapters::transformed(estimate<1>(e), estimate<0>(e));
    } else {
      return adapters::transformed(estimate<0>(e), e.Xw);
    }
  }
  static typename Edge::Measurement image(const Edge& e, const Vector3& point_in_camera) {
    return EdgeModel<Edge>::camera(e).template image<kRows>(point_in_camera);
  }
  static typename Edge::Measurement error(const Edge& e) {
    return e.measurement() - EdgeModel<Edge>::image(e, point_in_camera(e));
  }
  static void linearize(Edge& e) {
    const adapters::ImageDerivatives<kRows> by(EdgeModel<Edge>::camera(e), point_in_camera(e));
    if constexpr (kIsPointVertex)
      adapters::negative_by_point(by, estimate<1>(e).rotation(), e.template jacobianOplusXn<0>());
    adapters::negative_by_step(by, e.template jacobianOplusXn < kIsPointVertex ? 1 : 0 > ());
  }
};

}  // namespace internal
}  // namespace g2o
