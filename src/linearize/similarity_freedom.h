// SPDX-License-Identifier: BSD-3-Clause
// The gauge freedom of a component: the similarities of the world that change none of its errors.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <span>
#include <vector>

#include "boxplus/base/stop_token.h"
#include "boxplus/graph/graph.h"
#include "linearize/world_motion.h"

namespace boxplus {

/// One active edge, and one vertex that may move.
struct EdgeSlot {
  std::uint32_t pool, slot;
};
struct VertexSlot {
  std::uint32_t pool, slot;
};

/// The motions z = motions · basis for which J z = 0 for every edge; J is the edge's Jacobian at the current
/// estimates. Each column of `basis` is one free motion. Every combination of them moves some vertex.
struct SimilarityFreedom {
  WorldMotions motions;
  Eigen::MatrixXd basis;  ///< motions.count() × number of free motions
  /// Per vertex pool and slot.
  const std::vector<std::vector<WorldRole>>* roles = nullptr;

  double unit() const { return motions.unit(); }
  int directions() const { return static_cast<int>(basis.cols()); }
  /// The free motions in the tangent space of a vertex: tangent_dim × directions().
  Eigen::MatrixXd of_vertex(const Graph& graph, VertexSlot vertex) const;
};

/// Tests components of one graph. Throws Stopped when the token is raised.
///
/// An edge resists a motion if a row of J z is not zero to within rounding, relative to the sum of the
/// magnitudes of its terms. So weights, Ω and condition numbers have no influence. Disabled edges take part,
/// because enabling an edge does not change the structure of the problem.
class SimilarityTest {
 public:
  /// `movable`: per vertex pool and slot, whether the vertex moves. Vertices of one kind have the same
  /// positions in edges of the same types. They share a role, which is found by trial.
  SimilarityTest(const Graph& graph, const std::vector<std::vector<std::uint8_t>>& movable,
                 const StopToken& stop);

  /// The freedom of one component in a world of 2 or 3 dimensions. O(edges).
  SimilarityFreedom find(std::span<const VertexSlot> vertices, std::span<const EdgeSlot> edges,
                         int dimension);

 private:
  struct Kind;
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  std::vector<Kind> list_kinds(std::span<const VertexSlot> vertices, std::span<const EdgeSlot> edges,
                               int dimension);
  void assign_roles(std::span<const VertexSlot> vertices, const std::vector<Kind>& kinds, unsigned choice);
  WorldMotions motions_for(std::span<const VertexSlot> vertices, int dimension) const;
  Eigen::MatrixXd moving(std::span<const VertexSlot> vertices, const WorldMotions& motions);
  Eigen::MatrixXd unresisted(std::span<const VertexSlot> vertices, std::span<const EdgeSlot> edges,
                             const WorldMotions& world, const Eigen::MatrixXd& candidates) const;
  void tangents_of_edge(const detail::EdgePool& pool, std::uint32_t edge, RowMajor& out) const;
  SimilarityFreedom free_motions(std::span<const VertexSlot> vertices, std::span<const EdgeSlot> edges,
                                 int dimension);

  const Graph& graph_;
  const std::vector<std::vector<std::uint8_t>>& movable_;
  const StopToken& stop_;
  std::vector<std::vector<WorldRole>> roles_;
  std::vector<std::vector<std::uint32_t>> kind_of_;
  /// Per vertex pool and slot, the index in tangents_ of the vertex's motions: dim × count, row-major.
  static constexpr std::size_t kStill = static_cast<std::size_t>(-1);
  std::vector<std::vector<std::size_t>> tangents_of_;
  std::vector<double> tangents_;
};

}  // namespace boxplus
