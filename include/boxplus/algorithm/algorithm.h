// SPDX-License-Identifier: BSD-3-Clause
// The interface of nonlinear least-squares methods. An algorithm accesses the problem only through the
// interface System.
#pragma once

#include <cstdint>
#include <string_view>

#include "boxplus/system/system.h"

namespace boxplus {

enum class IterationOutcome : std::uint8_t {
  kAccepted,       ///< took a step that lowers chi2 (Gauss-Newton: took a step)
  kAcceptedShort,  ///< like kAccepted, but damping or a trust region shortened the step, so a small step or
                   ///< a small decrease does not indicate a minimum
  kNoFurtherDecrease,  ///< no step lowers chi2, except by rounding errors
  kNoStepFound,        ///< no step lowers chi2, although the model predicts a decrease
  kNotPositiveDefinite,
  kNotFinite,
  kStopped
};

/// The caller calls reset() once, and then iterate() until the outcome or the caller itself ends the run. An
/// algorithm allocates memory only in reset().
class Algorithm {
 public:
  virtual ~Algorithm() = default;
  virtual std::string_view name() const = 0;
  virtual void reset(const Options& options, std::size_t scalars) = 0;
  /// Linearizes at the current estimates, whose cost is `chi2`, finds a step and takes it. May fill these
  /// members of the record: predicted_decrease, lambda, radius, tries and linear_iterations. The caller fills
  /// the other ones from the last step that System::accept() accepted and the last linearization. If the
  /// outcome is kAccepted or kAcceptedShort without a call of accept(), it throws InvalidArgument.
  virtual IterationOutcome iterate(System& system, double chi2, IterationRecord& record) = 0;
  /// The number of steps for which H had to be damped because it was not positive definite.
  virtual int regularized_steps() const { return 0; }
};

}  // namespace boxplus
