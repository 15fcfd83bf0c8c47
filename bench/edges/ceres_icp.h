// SPDX-License-Identifier: BSD-3-Clause
// Runs Ceres with automatic differentiation on the same problem. Ceres is in a separate library;
// datasets/ceres/ceres_peer.h says why.
#pragma once

#include <memory>

#include "edges/icp_numbers.h"

namespace boxplus::bench {

class __attribute__((visibility("default"))) CeresIcp {
 public:
  explicit CeresIcp(const IcpProblem& problem);
  ~CeresIcp();
  /// Solves the problem from its start with one thread, by DENSE_NORMAL_CHOLESKY or DENSE_QR.
  IcpRun run(bool normal_equations);

 private:
  struct Model;
  std::unique_ptr<Model> model_;
};

}  // namespace boxplus::bench
