// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/graph_numbers.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "boxplus/types/slam2d.h"
#include "boxplus/types/slam3d.h"

namespace boxplus::bench {
namespace {

/// Returns S with Ω = SᵀS, row by row. S is the transposed Cholesky factor. If Ω is singular, S is √D Vᵀ with
/// the eigenvalues D and eigenvectors V.
template <std::size_t N>
std::array<double, N> root_of(const detail::InformationView& information) {
  const Eigen::MatrixXd omega = information.matrix();
  const Eigen::LLT<Eigen::MatrixXd> cholesky(omega);
  Eigen::MatrixXd root = cholesky.matrixU();
  if (cholesky.info() != Eigen::Success) {
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(omega);
    root = eigen.eigenvalues().cwiseMax(0).cwiseSqrt().asDiagonal() * eigen.eigenvectors().transpose();
  }
  std::array<double, N> rows{};
  Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(rows.data(), root.rows(),
                                                                                     root.cols()) = root;
  return rows;
}

template <class Pose>
bool add_motions(const detail::EdgePool& pool, PlainGraph& out) {
  const auto* motions = dynamic_cast<const detail::TypedEdgePool<Between<Pose>, Pose, Pose>*>(&pool);
  if (motions == nullptr) return false;
  for (std::uint32_t edge = 0; edge < pool.slots(); ++edge) {
    const auto vertices = pool.vertex_slots(edge);
    PlainGraph::Motion motion{vertices[0], vertices[1], {}, root_of<36>(pool.information(edge))};
    std::copy_n(motions->value(edge).measurement.data(), out.pose_size, motion.z.data());
    out.motions.push_back(motion);
  }
  return true;
}

bool add_observations(const detail::EdgePool& pool, PlainGraph& out) {
  const auto* observations =
      dynamic_cast<const detail::TypedEdgePool<PointObservation2, SE2, Vector2>*>(&pool);
  if (observations == nullptr) return false;
  for (std::uint32_t edge = 0; edge < pool.slots(); ++edge) {
    const auto vertices = pool.vertex_slots(edge);
    const Vector2& z = observations->value(edge).measurement;
    out.observations.push_back({vertices[0], vertices[1], {z[0], z[1]}, root_of<4>(pool.information(edge))});
  }
  return true;
}

template <class Pose>
bool add_poses(const detail::VertexPool& pool, PlainGraph& out) {
  const auto* poses = dynamic_cast<const detail::TypedVertexPool<Pose>*>(&pool);
  if (poses == nullptr || pool.slots() == 0) return false;
  out.pose_size = std::is_same_v<Pose, SE2> ? 3 : 7;
  for (std::uint32_t slot = 0; slot < pool.slots(); ++slot) {
    const double* pose = poses->value(slot).data();
    out.poses.insert(out.poses.end(), pose, pose + out.pose_size);
    out.pose_is_fixed.push_back(pool.fixed(slot));
  }
  return true;
}

void add_points(const detail::VertexPool& pool, PlainGraph& out) {
  const auto* points = dynamic_cast<const detail::TypedVertexPool<Vector2>*>(&pool);
  if (points == nullptr) return;
  for (std::uint32_t slot = 0; slot < pool.slots(); ++slot) {
    const Vector2& point = points->value(slot);
    out.points.insert(out.points.end(), {point[0], point[1]});
  }
}

}  // namespace

PlainGraph numbers_of(const Graph& graph) {
  PlainGraph out;
  for (const auto& pool : graph.vertex_pools()) {
    if (!add_poses<SE2>(*pool, out) && !add_poses<SE3>(*pool, out)) add_points(*pool, out);
  }
  for (const auto& pool : graph.edge_pools()) {
    if (pool->slots() == 0 || add_motions<SE2>(*pool, out) || add_motions<SE3>(*pool, out) ||
        add_observations(*pool, out)) {
      continue;
    }
    throw std::runtime_error("the peers have no edge of type " + std::string(pool->type_name()));
  }
  return out;
}

void set_estimates(Graph& graph, const PlainGraph& numbers) {
  for (const auto& pool : graph.vertex_pools()) {
    for (std::uint32_t slot = 0; slot < pool->slots(); ++slot) {
      if (auto* planar = dynamic_cast<detail::TypedVertexPool<SE2>*>(pool.get())) {
        const double* x = &numbers.poses[3 * slot];
        planar->value(slot) = SE2(x[0], x[1], x[2]);
      } else if (auto* spatial = dynamic_cast<detail::TypedVertexPool<SE3>*>(pool.get())) {
        spatial->value(slot) =
            SE3::from_vector(Eigen::Map<const Vector<double, 7>>(&numbers.poses[7 * slot]));
      } else if (auto* points = dynamic_cast<detail::TypedVertexPool<Vector2>*>(pool.get())) {
        points->value(slot) = Vector2(numbers.points[2 * slot], numbers.points[2 * slot + 1]);
      }
    }
  }
}

}  // namespace boxplus::bench
