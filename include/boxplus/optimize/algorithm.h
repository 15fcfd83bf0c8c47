// SPDX-License-Identifier: BSD-3-Clause
// One step of a nonlinear least-squares method; it knows the problem only as a System.
#pragma once

#include <cstdint>
#include <string_view>

#include "boxplus/optimize/system.h"

namespace boxplus {

enum class IterationOutcome : std::uint8_t {
  kAccepted,           ///< moved to lower chi2 (Gauss-Newton: moved)
  kAcceptedShort,      ///< the same by a step that damping or a trust radius cut short: that it is small, or
                       ///< lowers chi2 by little, is no sign of a minimum
  kNoFurtherDecrease,  ///< no step lowers chi2, and none is expected to by more than rounding
  kNoStepFound,        ///< no step lowers chi2 although one is expected to
  kNotPositiveDefinite,
  kNotFinite,
  kStopped
};

/// Called as: reset() once, then iterate() until the caller or the outcome stops. Allocates only in reset().
class Algorithm {
 public:
  virtual ~Algorithm() = default;
  virtual std::string_view name() const = 0;
  virtual void reset(const Options& options, std::size_t scalars) = 0;
  /// From estimates with cost `chi2`: linearises, finds a step, takes it. Fills all of the record but
  /// iteration and time; record.chi2 is the cost afterwards.
  virtual IterationOutcome iterate(System& system, double chi2, IterationRecord& record) = 0;
  /// How many steps needed a damped H because H was not positive definite.
  virtual int regularized_steps() const { return 0; }
};

}  // namespace boxplus
