// SPDX-License-Identifier: BSD-3-Clause
// Ceres on the same problem, with autodiff, as a library of its own (see datasets/ceres/ceres_peer.h).
#pragma once

#include <memory>

#include "edges/icp_numbers.h"

namespace boxplus::bench {

class __attribute__((visibility("default"))) CeresIcp {
 public:
  explicit CeresIcp(const IcpProblem& problem);
  ~CeresIcp();
  /// From the start, with one thread. `solver`: DENSE_QR, or DENSE_NORMAL_CHOLESKY if it is true.
  IcpRun run(bool normal_equations);

 private:
  struct Model;
  std::unique_ptr<Model> model_;
};

}  // namespace boxplus::bench
