// SPDX-License-Identifier: BSD-3-Clause
// Solves an IcpProblem by Ceres with automatic differentiation. This code is a separate library;
// datasets/ceres/ceres_peer.h says why.
#pragma once

#include <memory>

#include "edges/icp_numbers.h"

namespace boxplus::bench {

class __attribute__((visibility("default"))) CeresIcp {
 public:
  explicit CeresIcp(const IcpProblem& problem);
  ~CeresIcp();
  /// Solves the problem from IcpProblem::start with one thread. The linear solver is DENSE_NORMAL_CHOLESKY if
  /// `normal_equations` is true, and otherwise DENSE_QR.
  IcpRun run(bool normal_equations);

 private:
  struct Model;
  std::unique_ptr<Model> model_;
};

}  // namespace boxplus::bench
