// SPDX-License-Identifier: BSD-3-Clause
// One part of the edges in batches, and its passes over them. One thread at a time works on a part.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/batch_pass.h"
#include "engine/edge_batch.h"
#include "engine/last_type.h"

namespace g2o {
namespace internal {

/// The memory for the numbers of one tile of edges: consecutive edges of a batch, which are evaluated before
/// they are added to H.
struct EdgeTile {
  static constexpr int kEdges = 32;

  std::array<EdgeState, kEdges> state{};
  std::array<double, kEdges> chi2{}, weight{};
  std::array<const double*, kEdges> omegas{};
  std::array<const std::uint32_t*, kEdges> targets{};
  std::vector<double> jacobian, error, omega, unused, jacobian_lanes, error_lanes;
  std::array<double*, 8> jacobian_of{};
  std::array<int, 8> stride{};
  std::vector<std::uint32_t> nowhere;
  std::vector<std::vector<double>> outgrown;  ///< edges may keep pointers into this memory

  /// Gives the tile memory for edges of a batch. The edges keep pointers to their Jacobians in this memory.
  void make_room(const EdgeBatch& batch);
  /// Orders the Jacobians as the kernel expects them. The Jacobians of fixed vertices are not used.
  void place_jacobians(const EdgeBatch& batch);

 private:
  void grow(std::vector<double>& memory, int values);
};

class BatchPart {
 public:
  /// The tile must outlive the edges.
  explicit BatchPart(EdgeTile& memory) : tile_(memory) {}

  std::vector<EdgeBatch> batches;

  /// The sum of the part for one block and its part of the gradient, behind H and behind the gradient.
  struct Sum {
    int vertex, dim;
    std::uint32_t from_value, from_scalar, to_value, to_scalar;
  };
  std::vector<Sum> sums;

  /// Gives the tile memory for the edges of all batches.
  void make_room();
  void compute_errors(BatchPass& pass);
  void linearize(double* values, double* gradient, bool with_errors, BatchPass& pass);

 private:
  EdgeRun run(const EdgeBatch& batch, std::size_t begin);
  void weigh(const EdgeRun& run, BatchPass& pass, const EdgeBatch* linearized = nullptr,
             std::size_t begin = 0);
  void add(const EdgeBatch& batch, int count, double* values, double* gradient);

  EdgeTile& tile_;
  LastType kernel_type_;
};

}  // namespace internal
}  // namespace g2o
