// SPDX-License-Identifier: BSD-3-Clause
// Optimizes a graph while it grows.
#pragma once

#include <atomic>
#include <cstddef>

#include "boxplus/incremental/smoother.h"
#include "boxplus/optimize/optimizer.h"

namespace boxplus::programs {

struct IncrementalOptions {
  int update_every = 10;  ///< an update after so many new vertices
  int batch_every = 0;    ///< a batch optimization after so many new vertices; 0: never
  bool pcg = false;       ///< batch optimizations use conjugate gradients instead of a factorization
  const std::atomic<bool>* stop = nullptr;  ///< ends an optimization; may be null
};

/// One Smoother for the life of the graph.
class IncrementalSolver {
 public:
  enum class Work { kNothing, kUpdate, kBatch };
  /// What the last optimization did.
  struct Summary {
    double chi2 = 0, time_s = 0;
    int iterations = 0;
    std::size_t moved = 0;  ///< the number of estimates that were computed
    bool converged = true;
    std::string message;
  };

  /// `graph` must outlive this object.
  IncrementalSolver(Graph& graph, const IncrementalOptions& options);

  /// Does what is due since the last call: nothing, an update, or a batch optimization.
  Work solve();
  /// A batch optimization. If the estimates turn out to be bad, tries another start, too
  /// (Start::kAutomatic).
  void converge();
  const Summary& summary() const { return summary_; }

 private:
  Graph& graph_;
  IncrementalOptions options_;
  Smoother smoother_;
  Summary summary_;
  std::size_t at_update_ = 0, at_batch_ = 0;  // the number of vertices then
};

}  // namespace boxplus::programs
