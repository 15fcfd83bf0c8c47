// SPDX-License-Identifier: BSD-3-Clause
// How certain the positions of vertices are.
#pragma once

#include <Eigen/Core>
#include <atomic>
#include <cstdint>
#include <string>
#include <vector>

#include "boxplus/covariance/covariance.h"
#include "viewer/scene/structure.h"

namespace boxplus::viewer {

/// Returns the covariance of the position of a pose or point in the world frame: 2 × 2 or 3 × 3, in m².
/// Throws as Covariance::of() does.
Eigen::MatrixXd position_covariance(const Graph& graph, VertexRef vertex, const Covariance& covariance);

struct Uncertainty {
  std::string note = {};  ///< what was computed, or why nothing was; empty: nothing was wanted
  std::vector<std::uint32_t> vertices = {};  ///< their numbers in the structure, ascending
  std::vector<float> covariances = {};       ///< xx, xy, xz, yy, yz, zz in m² for each of the vertices

  static constexpr std::uint32_t kMostVertices = 2000;
};

/// Computes the covariances of the positions of at most kMostVertices drawn vertices, which are spread evenly
/// over all of them, at the current estimates. `stop` may become true, and then there are none.
Uncertainty read_uncertainty(const Graph& graph, const Structure& structure, const std::atomic<bool>& stop);

}  // namespace boxplus::viewer
