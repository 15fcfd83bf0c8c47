// SPDX-License-Identifier: BSD-3-Clause
// Optimizes a graph while it grows.
#pragma once

#include <atomic>
#include <cstddef>

#include "boxplus/optimize/optimizer.h"

namespace boxplus::programs {

struct IncrementalOptions {
  int update_every = 10;  ///< one iteration over the whole graph after so many new vertices
  int batch_every = 0;    ///< as many iterations as necessary after so many new vertices; 0: never
  bool pcg = false;       ///< conjugate gradients instead of a factorization
  const std::atomic<bool>* stop = nullptr;  ///< ends an optimization; may be null
};

/// One Optimizer for the life of the graph.
class IncrementalSolver {
 public:
  enum class Work { kNothing, kUpdate, kBatch };

  /// `graph` must outlive this object.
  IncrementalSolver(Graph& graph, const IncrementalOptions& options);

  /// Does what is due since the last call: nothing, one iteration, or iterations until it converges.
  Work solve();
  /// Iterates until it converges. If the estimates turn out to be bad, tries another start, too
  /// (Start::kAutomatic).
  void converge();
  /// The last run.
  const Report& report() const { return report_; }

  /// If nothing determines the place of the graph, its first pose is fixed while it grows. After this call,
  /// the user determines the place.
  void release_gauge();

 private:
  void hold_gauge();
  void run(int iterations, Start start);

  Graph& graph_;
  IncrementalOptions options_;
  Optimizer optimizer_;
  Report report_;
  std::size_t at_update_ = 0, at_batch_ = 0;  // the number of vertices then
  VertexRef held_ = {};
  bool holds_ = false, may_hold_ = true;
};

}  // namespace boxplus::programs
