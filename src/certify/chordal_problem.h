// SPDX-License-Identifier: BSD-3-Clause
// The chordal cost of a pose graph: a quadratic form in stacked poses.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "boxplus/base/matrix.h"
#include "boxplus/certify/certificate.h"

namespace boxplus::certificate {

/// The most columns of a stacked pose.
inline constexpr int kMostRank = 6;

/// (d + 1) × (d + 1)
using Block = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::DontAlign, 4, 4>;
/// X_i = [R_iᵀ; t_iᵀ], (d + 1) × p. Its first d rows are orthonormal. p = d for poses. For larger p, the
/// poses are relaxed: R_i is a p × d matrix.
using StackedPose = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::DontAlign, 4, kMostRank>;
using StackedPoses = std::vector<StackedPose>;

/// The term tr(Dᵀ W D) with D = X_to − B X_from, B = [R_ijᵀ 0; t_ijᵀ 1] and W = diag(M, τ).
struct ChordalEdge {
  std::uint32_t from, to;
  Block motion;  ///< B
  Block weight;  ///< W
};

/// D = X_to − B X_from
StackedPose difference(const ChordalEdge& edge, const StackedPoses& poses);

/// F(X) = Σ tr(Dᵀ W D) = tr(Xᵀ Q X). One pose of each connected component is pinned: it does not move,
/// because F does not change if all poses of a component move together.
struct ChordalProblem {
  static constexpr std::uint32_t kPinned = 0xFFFFFFFFu;

  int dimension = 0;                  ///< d
  std::vector<VertexRef> vertices;    ///< of each pose
  std::vector<std::uint32_t> block;   ///< the index of each pose among those that move, or kPinned
  std::vector<std::uint32_t> moving;  ///< the pose of each block
  std::vector<std::uint32_t> pin;     ///< the pinned pose of the component of each pose
  std::vector<double> offset;         ///< the distance of that pose from the origin of the graph
  std::vector<ChordalEdge> edges;
  std::vector<EdgeRef> refs;  ///< of `edges`
  Certificate::Relation relation = Certificate::Relation::kEqual;

  double cost(const StackedPoses& poses) const;
  /// Q X
  StackedPoses gradient(const StackedPoses& poses) const;
};

/// Returns the estimates of the graph relative to the pinned pose of their component, which therefore is
/// exactly the identity. Rotations are projected, so that rounding in files does not matter.
StackedPoses read_poses(const Graph& graph, const ChordalProblem& problem);
/// Sets the estimates to the nearest rotations of the first d columns. `poses` are relative to the pinned
/// poses, which stay where they are.
void write_poses(const StackedPoses& poses, const ChordalProblem& problem, Graph& graph);
/// The nearest poses of p = d columns.
StackedPoses round_poses(const StackedPoses& poses, const ChordalProblem& problem);

/// Reads the problem. If the graph is no pose graph, returns false, and `complaint` says what is in the way.
bool read_problem(const Graph& graph, const Options& options, ChordalProblem& problem,
                  std::string& complaint);

}  // namespace boxplus::certificate
