// SPDX-License-Identifier: BSD-3-Clause
// Ceres on the same problem, with autodiff, as a separate library (see datasets/ceres/ceres_peer.h).
#pragma once

#include <memory>

#include "edges/icp_numbers.h"

namespace boxplus::bench {

class __attribute__((visibility("default"))) CeresIcp {
 public:
  explicit CeresIcp(const IcpProblem& problem);
  ~CeresIcp();
  /// Solves from the start with one thread, by DENSE_NORMAL_CHOLESKY or DENSE_QR.
  IcpRun run(bool normal_equations);

 private:
  struct Model;
  std::unique_ptr<Model> model_;
};

}  // namespace boxplus::bench
