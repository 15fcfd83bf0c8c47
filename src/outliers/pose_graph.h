// SPDX-License-Identifier: BSD-3-Clause
// A view of a graph for the search for outliers: poses in the order of their ids, odometry and closures.
#pragma once

#include <cstdint>
#include <vector>

#include "boxplus/base/function_ref.h"
#include "boxplus/graph/graph.h"
#include "boxplus/options/options.h"
#include "outliers/motion.h"

namespace boxplus::outliers {

/// The variances of a measured or predicted motion, per axis: translation in m², rotation in rad².
struct Spread {
  double translation = 0, rotation = 0;

  Spread operator+(const Spread& other) const {
    return {translation + other.translation, rotation + other.rotation};
  }
};

/// An edge that measures the full motion between two poses: T_from⁻¹ T_to ≈ motion, with from < to.
struct PoseEdge {
  EdgeRef edge;
  std::uint32_t from = 0, to = 0;  ///< ranks of the poses
  Motion motion;
  Spread spread;
  int rows = 0;
  std::size_t order = 0;  ///< among all links and closures of the graph
};

struct PoseGraph {
  /// Reads the enabled edges of options.level among options.edges.
  PoseGraph(const Graph& graph, const Options& options);

  int dimension = 0;             ///< 2 or 3; 0 if there are no poses
  bool is_mixed = false;         ///< there are poses in the plane and in space; then all edges are `others`
  std::vector<VertexRef> poses;  ///< the trajectory, by id
  std::vector<PoseEdge> links;   ///< between poses with consecutive ranks
  std::vector<PoseEdge> closures;
  std::vector<EdgeRef> others;  ///< all other edges, which are trusted

  /// The number of translation axes and of rotation axes.
  int translations() const { return dimension; }
  int rotations() const { return dimension == 2 ? 1 : 3; }
  std::vector<Motion> estimates(const Graph& graph) const;
  /// Makes the links for which is_suspect(index) holds closures, so that they are judged. The odometry then
  /// has a gap there, unless another link remains.
  void suspect(detail::FunctionRef<bool(std::size_t)> is_suspect);
};

}  // namespace boxplus::outliers
