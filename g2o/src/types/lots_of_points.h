// SPDX-License-Identifier: BSD-3-Clause
// Edges from one pose to any number of points. The Jacobian blocks for each point are the same as for an edge
// to one point.
#pragma once

#include <vector>

#include "g2o/core/hyper_graph.h"
#include "types/adapters.h"

namespace g2o {
namespace adapters {

/// `Types` names three types of the engine: One and Many, the edges to one and to many points, and Pose. It
/// also names the vertices of the g2o API, PoseVertex and PointVertex. Its functions pose() and point()
/// convert the estimates of these vertices.
template <class Types>
struct LotsOfPoints {
  using One = typename Types::One;
  using Many = typename Types::Many;
  using Pose = typename Types::Pose;
  using PoseVertex = typename Types::PoseVertex;
  using PointVertex = typename Types::PointVertex;
  static constexpr int kDim = PointVertex::Dimension;
  using Point = boxplus::Vector<double, kDim>;
  using Vertices = HyperGraph::VertexContainer;

  static bool vertices_fit(const Vertices& vertices) {
    if (vertices.empty() || dynamic_cast<const PoseVertex*>(vertices[0]) == nullptr) return false;
    for (std::size_t i = 1; i < vertices.size(); ++i) {
      if (dynamic_cast<const PointVertex*>(vertices[i]) == nullptr) return false;
    }
    return true;
  }

  static void compute_error(const Vertices& vertices, const VectorX& z, VectorX& error) {
    const Pose x = pose(vertices);
    for (std::size_t i = 1; i < vertices.size(); ++i) rows(error, i) = one(z, i).error(x, point(vertices, i));
  }

  template <class Jacobians>
  static void linearize(const Vertices& vertices, const VectorX& z, Jacobians& J) {
    const Pose x = pose(vertices);
    boxplus::Matrix<double, kDim, PoseVertex::Dimension> J_pose;
    boxplus::Matrix<double, kDim, kDim> J_point;
    for (std::size_t i = 1; i < vertices.size(); ++i) {
      adapters::linearize(one(z, i), Argument<Pose>{x, J_pose.data()},
                          Argument<Point>{point(vertices, i), J_point.data()});
      rows(J[0], i) = J_pose;
      J[i].setZero();
      rows(J[i], i) = J_point;
    }
  }

  /// Reads the fields after the ids and "||". Returns false if the number of points in the line differs from
  /// the number of point vertices.
  template <class Omega>
  static bool read(std::istream& is, Omega& information, VectorX& z) {
    const int fields = 1 + static_cast<int>(z.size());
    return read_fields(is, fields + omega_fields(information), [&](boxplus::FieldReader& in) {
      const boxplus::FieldPlace place = in.place();
      const Many edge = boxplus::EdgeFields<Many>::read(in);
      if (edge.measurement.size() != z.size())
        in.fail(place, "expected as many points as the edge has point vertices");
      read_omega(in, information);
      z = edge.measurement;
    });
  }

  template <class Omega>
  static bool write(std::ostream& os, const Omega& information, const VectorX& z) {
    os << "|| ";
    return write_edge(os, Many(z), information);
  }

 private:
  static Pose pose(const Vertices& vertices) {
    return Types::pose(*static_cast<const PoseVertex*>(vertices[0]));
  }
  static Point point(const Vertices& vertices, std::size_t i) {
    return Types::point(*static_cast<const PointVertex*>(vertices[i]));
  }
  template <class M>
  static auto rows(M& matrix, std::size_t i) {
    return matrix.template middleRows<kDim>(kDim * (static_cast<Eigen::Index>(i) - 1));
  }
  static One one(const VectorX& z, std::size_t i) { return One(Point(rows(z, i))); }
};

}  // namespace adapters
}  // namespace g2o
