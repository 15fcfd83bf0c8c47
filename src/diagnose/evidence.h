// SPDX-License-Identifier: BSD-3-Clause
// What a diagnosis knows about a graph: its structure, and sums over the edges from one linearization.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "boxplus/options/options.h"
#include "plan/active_set.h"

namespace boxplus {

/// The enabled active edges of one pool, in slot order.
struct PoolEvidence {
  std::uint32_t pool = 0;
  std::vector<std::uint32_t> edges;
  std::vector<double> chi2;  ///< eᵀΩe of each edge, without its kernel; may be not finite
  /// Equal for edges with the same vertices and errors; 0 if the Jacobian is zero.
  std::vector<std::uint64_t> signatures;
};

/// A vertex of an active edge that may move. Its parts of H and of the gradient are sums over its finite
/// edges.
struct VertexEvidence {
  VertexRef vertex;
  int dim = 0;
  std::uint32_t edges = 0;                ///< the number of enabled active edges
  std::uint32_t last_pool = 0, last = 0;  ///< the pool and the slot of the last of these edges
  bool is_finite = true;                  ///< whether all of these edges are finite
  std::size_t first_value = 0;   ///< of its block of H, which is column-major; only the lower triangle is set
  std::size_t first_scalar = 0;  ///< of its part of the gradient
};

/// The directions of a vertex that none of its edges determines.
struct FreeDirections {
  std::size_t vertex = 0;  ///< an index into Evidence::vertices
  /// Unit vectors in the tangent space; zero in fixed directions.
  std::vector<std::vector<double>> directions;
};

/// The images of one edge pool. The vectors `seen`, `in_front` and `nearest` have an entry for each slot of
/// the pool of points.
struct CameraViews {
  std::uint32_t point_pool = 0;
  std::vector<std::uint32_t> seen, in_front;  ///< the number of edges; of those whose point has a positive z
  std::vector<double> nearest;                ///< the distance of the point from the nearest of its cameras
  std::size_t edges = 0, edges_in_front = 0;
  std::size_t edges_far_off =
      0;  ///< whose image is more than a hundred standard deviations from the measured one
  /// The largest share of points on the same side of their cameras if the poses are read in another way: with
  /// w at the other end of the quaternions, or as the inverse. Computed only if most edges are far off.
  double one_sided_if_swapped = 0, one_sided_if_inverse = 0;
  std::size_t points = 0;      ///< that are seen
  double median_distance = 0;  ///< of the points from their cameras, over all edges
};

class Evidence {
 public:
  /// Linearizes each enabled active edge once. Throws Stopped when the token is raised.
  Evidence(const Graph& graph, const Options& options, const StopToken& stop);

  const Graph& graph;
  const Options& options;
  const StopToken& stop;
  ActiveSet active;
  std::vector<PoolEvidence> pools;
  std::vector<VertexEvidence> vertices;
  std::vector<EdgeRef> non_finite_errors, non_finite_jacobians;
  double chi2 = 0;  ///< Σ ρ(eᵀΩe) over the finite edges
  std::uint64_t rows = 0;
  bool has_kernels = false;
  std::vector<FreeDirections> free_directions;  ///< in the order of `vertices`
  std::vector<CameraViews> cameras;             ///< find_camera_views() finds them afterwards
  /// The decrease of chi2 if each vertex takes a Gauss-Newton step of its own, summed over the vertices.
  double single_decrease = 0;

  EdgeRef edge_ref(std::uint32_t pool, std::uint32_t slot) const {
    return {pool, slot, graph.edge_pools()[pool]->generation(slot)};
  }
  VertexRef vertex_ref(std::uint32_t pool, std::uint32_t slot) const {
    return {pool, slot, graph.vertex_pools()[pool]->generation(slot)};
  }
  const VertexEvidence* find(std::uint32_t pool, std::uint32_t slot) const {
    const std::uint32_t index = index_of_[pool][slot];
    return index == kNone ? nullptr : &vertices[index];
  }
  std::span<const double> block(const VertexEvidence& vertex) const {
    return {hessian_.data() + vertex.first_value, static_cast<std::size_t>(vertex.dim * vertex.dim)};
  }
  /// Whether chi2 is at a minimum as far as single vertices show.
  bool at_minimum() const;

 private:
  static constexpr std::uint32_t kNone = 0xFFFFFFFFu;

  void list_vertices();
  void linearize_pool(std::uint32_t pool);
  void add_edge(PoolEvidence& evidence, std::uint32_t slot, const double* error, const double* jacobian,
                const detail::EdgeShape& shape);
  void add_to_vertices(const PoolEvidence& evidence, std::uint32_t slot, const double* jacobian,
                       const detail::EdgeShape& shape, double weight);
  std::vector<int> held_directions(VertexRef vertex, std::span<const double> gradient) const;
  void examine_vertices();

  std::vector<std::vector<std::uint32_t>> index_of_;  // into `vertices`, by vertex pool and slot
  std::vector<double> hessian_, gradient_;
  std::vector<double> weighted_;  // ΩJ and Ωe of one edge
};

}  // namespace boxplus
