// SPDX-License-Identifier: BSD-3-Clause
// The gauge freedom of a component: the similarities of the world that change none of its errors.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <span>
#include <vector>

#include "boxplus/base/stop_token.h"
#include "boxplus/graph/graph.h"
#include "gauge/world_motion.h"

namespace boxplus {

/// An active edge.
struct EdgeSlot {
  std::uint32_t pool, slot;
};
/// A vertex that may move.
struct VertexSlot {
  std::uint32_t pool, slot;
};

/// One direction of a vertex without a frame: a focal length, or one component of a bias.
struct OwnDirection {
  VertexSlot vertex;
  int component;
};

/// The motions z = motions · basis with J z = 0 for the Jacobian J of every edge at the current estimates.
/// Each column of `basis` is one free motion. Every nonzero combination of the columns moves at least one
/// vertex. Vertices without a frame may change along with the world: a scale may be free only together with a
/// focal length.
struct SimilarityFreedom {
  WorldMotions motions;
  Eigen::MatrixXd basis;  ///< motions.count() × number of free motions
  std::vector<OwnDirection> own;
  Eigen::MatrixXd own_basis;  ///< the changes along the directions `own`: own.size() × number of free motions
  /// The role of each vertex, by vertex pool and slot.
  const std::vector<std::vector<WorldRole>>* roles = nullptr;

  double unit() const { return motions.unit(); }
  int directions() const { return static_cast<int>(basis.cols()); }
  bool has_scale() const { return basis.size() > 0 && basis.bottomRows(1).norm() > 1e-6; }
  /// Keeps only these combinations of the free motions, one per column.
  void keep(const Eigen::MatrixXd& combinations);
  /// The free motions in the tangent space of a vertex: tangent_dim × directions().
  Eigen::MatrixXd of_vertex(const Graph& graph, VertexSlot vertex) const;
};

/// Tests components of one graph. Throws Stopped when the token is raised.
///
/// An edge resists a motion if a row of J z is larger than a rounding error, relative to the sum of the
/// magnitudes of its terms. So weights, Ω and condition numbers have no influence. Disabled edges take part,
/// because enabling an edge does not change the structure of the problem.
///
/// All vertices of one kind have the same role. Vertices are of one kind if they have the same type and occur
/// at the same positions in the same types of edges. The test tries combinations of roles on a sample of the
/// edges, and uses the combination with the most free motions.
///
/// If no scale is free, tests whether one is free together with changes of vertices that have no frame. Such
/// vertices are shared by many edges, so the test considers them only if they have at most kMostOwn
/// directions in all.
class SimilarityTest {
 public:
  /// kSample tests at most kTestedEdges edges of each pool, evenly spaced. This is enough if every step is
  /// checked later: an edge that resists a motion gives a step along it.
  enum class Extent { kAllEdges, kSample };
  static constexpr std::size_t kTestedEdges = 512;
  static constexpr std::size_t kMostOwn = 8;

  /// `movable` says for each slot of each vertex pool whether the vertex moves.
  SimilarityTest(const Graph& graph, const std::vector<std::vector<std::uint8_t>>& movable,
                 const StopToken& stop);

  /// The freedom of one component in a world of 2 or 3 dimensions. Takes O(edges). The edges of a pool must
  /// be contiguous.
  SimilarityFreedom find(std::span<const VertexSlot> vertices, std::span<const EdgeSlot> edges, int dimension,
                         Extent extent);

 private:
  struct Kind;
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  std::vector<Kind> list_kinds(std::span<const VertexSlot> vertices, std::span<const EdgeSlot> edges,
                               int dimension);
  std::vector<VertexSlot> moving_ends(std::span<const EdgeSlot> edges) const;
  void assign_roles(std::span<const VertexSlot> vertices, const std::vector<Kind>& kinds, unsigned choice);
  WorldMotions motions_for(std::span<const VertexSlot> vertices, int dimension) const;
  Eigen::MatrixXd moving(std::span<const VertexSlot> vertices, const WorldMotions& motions);
  Eigen::MatrixXd unresisted(std::span<const VertexSlot> vertices, std::span<const EdgeSlot> edges,
                             const WorldMotions& world, const Eigen::MatrixXd& candidates) const;
  Eigen::Index columns(const WorldMotions& motions) const {
    return motions.count() + static_cast<Eigen::Index>(own_.size());
  }
  void tangents_of_edge(const detail::EdgePool& pool, std::uint32_t edge, RowMajor& out) const;
  SimilarityFreedom find_roles_and_motions(std::span<const VertexSlot> vertices,
                                           std::span<const EdgeSlot> edges, int dimension, Extent extent);
  SimilarityFreedom find_with_roles(std::span<const VertexSlot> vertices, std::span<const EdgeSlot> edges,
                                    int dimension, Extent extent);
  std::vector<OwnDirection> own_directions() const;
  void set_own_tangents(const WorldMotions& motions);
  SimilarityFreedom free_motions(std::span<const VertexSlot> vertices, std::span<const EdgeSlot> edges,
                                 int dimension);

  const Graph& graph_;
  const std::vector<std::vector<std::uint8_t>>& movable_;
  const StopToken& stop_;
  std::vector<std::vector<WorldRole>> roles_;
  std::vector<std::vector<std::uint32_t>> kind_of_;
  /// For each slot of each vertex pool, the index in tangents_ of the vertex's tangents, or kStill if no
  /// motion moves the vertex. The tangents are a row-major matrix of dim × count values.
  static constexpr std::size_t kStill = static_cast<std::size_t>(-1);
  std::vector<std::vector<std::size_t>> tangents_of_;
  std::vector<double> tangents_;
  std::vector<OwnDirection> own_;  // the directions that may change along with the world
};

}  // namespace boxplus
