// SPDX-License-Identifier: BSD-3-Clause
#include "engine/batch_part.h"

#include <algorithm>
#include <typeinfo>
#include <utility>

#include "g2o/core/robust_kernel_impl.h"

namespace g2o {
namespace internal {

namespace dense = boxplus::dense;

namespace {

/// Whether ρ(chi2) = chi2 because the kernel is a Huber kernel and the error is small. Most edges of visual
/// SLAM are inliers of a Huber kernel, and need no virtual call.
bool is_inlier_of_huber(const RobustKernel& kernel, double chi2) {
  return &typeid(kernel) == &typeid(RobustKernelHuber) && kernel.delta() > 0 &&
         chi2 <= kernel.delta() * kernel.delta();
}

}  // namespace

void EdgeTile::grow(std::vector<double>& memory, int values) {
  if (memory.size() >= static_cast<std::size_t>(values)) return;
  std::vector<double> larger(static_cast<std::size_t>(values));
  memory.swap(larger);
  if (!larger.empty()) outgrown.push_back(std::move(larger));
}

void EdgeTile::make_room(const EdgeBatch& batch) {
  const int rows = batch.kind->rows;
  int largest = 0;
  for (const int dim : batch.kind->dims) largest = std::max(largest, rows * dim);
  grow(jacobian, kEdges * rows * batch.columns);
  grow(jacobian_lanes, kEdges * rows * batch.columns);
  grow(error, kEdges * rows);
  grow(error_lanes, kEdges * rows);
  grow(omega, kEdges * rows * (rows + 1) / 2);
  grow(unused, largest);
  nowhere.resize(std::max(nowhere.size(), batch.targets_per_edge()), dense::kNoTarget);
}

void EdgeTile::place_jacobians(const EdgeBatch& batch) {
  const int rows = batch.kind->rows;
  jacobian_of.fill(unused.data());
  stride.fill(0);
  int column = 0;
  for (const int n : batch.adder.positions) {
    jacobian_of[n] = jacobian.data() + column * rows;
    stride[n] = batch.columns * rows;
    column += batch.kind->dims[n];
  }
  for (int k = 0; k < kEdges; ++k) omegas[k] = omega.data() + k * rows * (rows + 1) / 2;
}

void BatchPart::make_room() {
  for (const EdgeBatch& batch : batches) tile_.make_room(batch);
}

EdgeRun BatchPart::run(const EdgeBatch& batch, std::size_t begin) {
  const int left = static_cast<int>(batch.edges.size() - begin), count = std::min(left, EdgeTile::kEdges);
  return {batch.edges.data() + begin,
          count,
          left - count,
          tile_.state.data(),
          tile_.chi2.data(),
          tile_.jacobian_of.data(),
          tile_.stride.data(),
          tile_.error.data(),
          tile_.omega.data()};
}

/// Adds ρ(chi2) of the edges of a run, and stores their weights ρ′. If the edges are linearized, they are
/// those of `linearized` from `begin` on.
void BatchPart::weigh(const EdgeRun& run, BatchPass& pass, const EdgeBatch* linearized, std::size_t begin) {
  for (int k = 0; k < run.count; ++k) {
    const auto at = static_cast<std::size_t>(k);
    tile_.weight[at] = 1;
    if (run.state[k] == EdgeState::kIncomplete) {
      pass.any_incomplete = true;
      tile_.targets[at] = tile_.nowhere.data();
      continue;
    }
    OptimizableGraph::Edge& edge = *run.edges[k];
    const RobustKernel* kernel = edge.robustKernel();
    const bool is_known = kernel == nullptr || kernel_type_.allowed(typeid(*kernel));
    if (!is_known) {
      pass.with_unknown_kernels.push_back(&edge);
    } else if (kernel == nullptr) {
      pass.chi2 += run.chi2[k];
    } else if (is_inlier_of_huber(*kernel, run.chi2[k])) {
      pass.chi2 += run.chi2[k];
    } else {
      Vector3 rho;
      kernel->robustify(run.chi2[k], rho);
      pass.chi2 += rho[0];
      tile_.weight[at] = std::max(0.0, rho[1]);
    }
    if (linearized == nullptr) continue;
    if (!is_known || run.state[k] == EdgeState::kAsymmetric || !linearized->is_current(begin + at)) {
      pass.not_added.push_back(&edge);
      tile_.targets[at] = tile_.nowhere.data();
    }
  }
}

void BatchPart::compute_errors(BatchPass& pass) {
  for (const EdgeBatch& batch : batches) {
    for (std::size_t begin = 0; begin < batch.edges.size(); begin += EdgeTile::kEdges) {
      const EdgeRun tile_run = run(batch, begin);
      batch.kind->compute_errors(tile_run);
      weigh(tile_run, pass);
    }
  }
}

void BatchPart::linearize(double* values, double* gradient, bool with_errors, BatchPass& pass) {
  for (const EdgeBatch& batch : batches) {
    tile_.place_jacobians(batch);
    const std::size_t size = batch.targets_per_edge();
    for (std::size_t begin = 0; begin < batch.edges.size(); begin += EdgeTile::kEdges) {
      const EdgeRun tile_run = run(batch, begin);
      for (std::size_t k = 0; k < static_cast<std::size_t>(tile_run.count); ++k)
        tile_.targets[k] = batch.targets.data() + (begin + k) * size;
      batch.kind->linearize(tile_run, with_errors);
      weigh(tile_run, pass, &batch, begin);
      add(batch, tile_run.count, values, gradient);
    }
  }
}

/// Adds the first `count` edges of the tile to H and to the gradient.
void BatchPart::add(const EdgeBatch& batch, int count, double* values, double* gradient) {
  constexpr auto kFull = dense::EdgeNumbers::kFull;
  const int rows = batch.kind->rows;
  if (batch.adder.unary != nullptr) {
    batch.adder.unary({count, tile_.jacobian.data(), tile_.error.data(), kFull, tile_.omegas.data(),
                       tile_.weight.data(), tile_.targets.data(), values, gradient});
    return;
  }
  const dense::KernelTable& kernels = dense::kernels();
  kernels.to_lanes(tile_.jacobian.data(), rows * batch.columns, count, tile_.jacobian_lanes.data());
  kernels.to_lanes(tile_.error.data(), rows, count, tile_.error_lanes.data());
  batch.adder.in_lanes({count, tile_.jacobian_lanes.data(), tile_.error_lanes.data(), kFull,
                        tile_.omegas.data(), tile_.weight.data(), tile_.targets.data(), values, gradient});
}

}  // namespace internal
}  // namespace g2o
