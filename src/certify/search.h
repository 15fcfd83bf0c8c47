// SPDX-License-Identifier: BSD-3-Clause
// Searches the global minimum of the chordal cost.
#pragma once

#include <functional>
#include <optional>

#include "certify/riemannian_newton.h"

namespace boxplus::certificate {

/// Alternates between Newton's method, the lower bound and escapes from minima that are not global. `poses()`
/// are the best that were found, `cost()` is their F, and `bound()` the highest lower bound.
class Search {
 public:
  Search(const ChordalProblem& problem, StackedPoses start, double tolerance, const Resources& resources);

  /// Ends when F is within `tolerance` of the bound or only a rounding error, or after `max_escapes` escapes.
  /// The first escape is a run from `other_start()`, if it is not empty. All others climb the staircase.
  /// Throws Stopped; what was found until then remains.
  void run(int max_escapes, const std::function<StackedPoses()>& other_start = {});

  bool is_global() const;
  /// How much rounding may change F at the best poses.
  double rounding() const;
  const StackedPoses& poses() const { return poses_; }
  double cost() const { return cost_; }
  std::optional<double> bound() const { return bound_; }
  int steps() const { return steps_; }
  int escapes() const { return escapes_; }

 private:
  bool settle(StackedPoses& poses);
  bool climb();
  bool leave(StackedPoses& poses);
  bool has_bound(const StackedPoses& poses);

  const ChordalProblem& problem_;
  double tolerance_;
  Resources resources_;
  StackedPoses poses_;
  double cost_;
  std::optional<double> bound_;
  DualMatrix dual_;
  int steps_ = 0, escapes_ = 0;
};

}  // namespace boxplus::certificate
