// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "boxplus/algorithm/algorithm.h"

namespace boxplus {

/// Takes every Gauss-Newton step, even if it does not lower chi2. Ends when chi2 has only rounding errors
/// along a step.
class GaussNewton final : public Algorithm {
 public:
  std::string_view name() const override { return "Gauss-Newton"; }
  void reset(const Options& options, std::size_t scalars) override;
  IterationOutcome iterate(System& system, double chi2, IterationRecord& record) override;

 private:
  std::vector<double> step_;
};

}  // namespace boxplus
