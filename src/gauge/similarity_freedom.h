// SPDX-License-Identifier: BSD-3-Clause
// The gauge freedom of a component: the similarities of the world that change none of its errors.
#pragma once

#include <Eigen/Core>
#include <span>
#include <utility>
#include <vector>

#include "base/disjoint_sets.h"
#include "boxplus/base/stop_token.h"
#include "gauge/edge_ends.h"
#include "gauge/world_motion.h"

namespace boxplus {

/// The motions z = motions · basis with J z = 0 for the Jacobian J of every edge at the current estimates.
/// Each column of `basis` is one free motion. Every nonzero combination of the columns moves at least one
/// vertex. Vertices without a frame may change along with the world: a scale may be free only together with a
/// focal length.
struct SimilarityFreedom {
  WorldMotions motions;
  Eigen::MatrixXd basis;  ///< motions.count() × number of free motions
  /// The role of each vertex, by vertex pool and slot.
  const std::vector<std::vector<WorldRole>>* roles = nullptr;

  WorldRole role(VertexSlot v) const { return (*roles)[v.pool][v.slot]; }
  double unit() const { return motions.unit(); }
  int directions() const { return static_cast<int>(basis.cols()); }
  Eigen::MatrixXd translations() const { return basis.topRows(motions.translations()); }
  Eigen::MatrixXd rotations() const { return basis.middleRows(motions.translations(), motions.rotations()); }
  Eigen::MatrixXd scale() const { return basis.row(motions.in_world() - 1); }
  /// Keeps only these combinations of the free motions, one per column.
  void keep(const Eigen::MatrixXd& combinations) { basis = (basis * combinations).eval(); }
  /// The free motions in the tangent space of a vertex: tangent_dim × directions().
  Eigen::MatrixXd of_vertex(const Graph& graph, VertexSlot vertex) const {
    return motion_tangents(graph, vertex, role(vertex), motions) * basis;
  }
};

/// Tests components of one graph. Throws Stopped when the token is raised.
///
/// An edge resists a motion if a row of J z is larger than a rounding error, relative to the sum of the
/// magnitudes of its terms. So weights, Ω and condition numbers have no influence. Disabled edges take part,
/// because enabling an edge does not change the structure of the problem.
///
/// All vertices of one kind have the same role. Vertices are of one kind if they have the same type and occur
/// at the same positions in the same types of edges. The test tries combinations of roles on a few edges, and
/// uses the combination with the most free motions. If other edges resist some of these motions, it tries the
/// combinations again on a larger sample.
///
/// Vertices that have no frame are shared by many edges, so the test considers their changes only if they
/// have at most kMostOwn directions in all, and if no edges of other components share them, which would have
/// to leave these changes free, too.
class SimilarityTest {
 public:
  /// kSample tests at most kTestedEdges edges of each pool, and as many of its anchors, evenly spaced. This
  /// is enough if every step is checked later: an edge that resists a motion gives a step along it.
  enum class Extent { kAllEdges, kSample };
  static constexpr std::size_t kTestedEdges = 512;
  static constexpr std::size_t kMostOwn = 8;

  /// `movable` says for each slot of each vertex pool whether the vertex moves, and `shared` for each vertex
  /// whether several components have edges with it, by GraphView::number().
  SimilarityTest(const Graph& graph, const std::vector<std::vector<std::uint8_t>>& movable,
                 const EdgeEnds& ends, std::span<const std::uint8_t> shared, const StopToken& stop);

  /// Selects a component. `anchors` are its edges that tie it to the world. The edges of a pool must be
  /// contiguous. The vertices `left_out` also belong to other components, and do not change.
  void select(std::span<const VertexSlot> vertices, std::span<const EdgeSlot> edges,
              std::span<const EdgeSlot> anchors, std::span<const VertexSlot> left_out);
  /// The number of the kind of a vertex of the selected component.
  std::uint32_t kind(VertexSlot v) { return kind_of_.find(ends_.number(v)); }
  /// The freedom of the component in a world of 2 or 3 dimensions. Takes O(edges).
  SimilarityFreedom find(int dimension, Extent extent);

 private:
  /// A group of vertices of one type that occur at the same positions in the same types of edges.
  struct Kind {
    std::uint32_t id;
    int dimension;
    std::vector<WorldRole> candidates;  // the roles to try, with the most likely one first
    std::size_t choice = 0;
  };

  /// The motions in the tangent space of a vertex, and the norms of their rows; empty if none moves it.
  struct Tangents {
    Eigen::MatrixXd values;
    Eigen::VectorXd norms;
    void set(Eigen::MatrixXd motions) {
      values = std::move(motions);
      norms = values.rowwise().norm();
    }
  };

  void assign_roles(std::span<const VertexSlot> vertices, int dimension);
  SimilarityFreedom find_with_roles(int dimension, Extent extent);
  int choose_roles(int dimension, std::size_t tested_edges);
  std::vector<EdgeSlot> sample(std::size_t count) const;
  std::vector<VertexSlot> moving_ends(std::span<const EdgeSlot> edges) const;
  std::vector<OwnDirection> own_directions(const std::vector<std::vector<std::uint8_t>>& movable,
                                           std::span<const std::uint8_t> shared) const;
  SimilarityFreedom free_motions(std::span<const VertexSlot> vertices, std::span<const EdgeSlot> edges,
                                 int dimension, std::vector<OwnDirection> own);
  WorldMotions motions_about_center(std::span<const VertexSlot> vertices, int dimension) const;
  Eigen::MatrixXd moving(std::span<const VertexSlot> vertices, const WorldMotions& motions);
  Eigen::MatrixXd unresisted(std::span<const VertexSlot> vertices, std::span<const EdgeSlot> edges,
                             const WorldMotions& motions, Eigen::MatrixXd candidates) const;

  const Graph& graph_;
  const EdgeEnds& ends_;
  const StopToken& stop_;
  const std::vector<OwnDirection> all_own_;  // the directions that may change along with the world
  std::vector<OwnDirection> own_;            // those of the selected component
  std::span<const VertexSlot> vertices_;
  std::span<const EdgeSlot> edges_, anchors_;
  DisjointSets kind_of_;  // by GraphView::number()
  std::vector<Kind> kinds_;
  std::vector<std::vector<WorldRole>> roles_;
  std::vector<Tangents> tangents_;  // by GraphView::number()
};

}  // namespace boxplus
