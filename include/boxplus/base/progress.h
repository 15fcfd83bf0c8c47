// SPDX-License-Identifier: BSD-3-Clause
// How far a long call has come.
#pragma once

#include <functional>
#include <string_view>

#include "boxplus/base/abi.h"

namespace boxplus {

/// While this object exists, calls on the same thread tell its function how far they have come: reading and
/// writing of files, simulate() and simulate_bundle(), find_outliers(), certify(). Of several objects, the
/// newest one is told.
///
///     const ProgressWatch watch([](std::string_view stage, double share) { … });
///     GraphFile file = read_graph("city.g2o");
///
/// The function is called on the thread that made the object, up to some 10⁷ times a second, so it should
/// look at the time before it does anything. It must not throw.
class ProgressWatch {
 public:
  /// `stage` says what the call is doing; it is empty if there is nothing to say that the caller does not
  /// know. `share` is the part of the work that is done, from 0 to 1, or NaN if nobody knows.
  using Function = std::function<void(std::string_view stage, double share)>;

  explicit ProgressWatch(Function function);
  ~ProgressWatch();
  ProgressWatch(const ProgressWatch&) = delete;
  ProgressWatch& operator=(const ProgressWatch&) = delete;

  const Function& function() const { return function_; }

 private:
  Function function_;
  const ProgressWatch* outer_;
};

namespace detail {

/// Tells the newest ProgressWatch of this thread, if there is one.
void note_progress(double share, std::string_view stage = {});
/// Whether there is one, for callers that have to compute what they tell.
bool is_watched();

}  // namespace detail

}  // namespace boxplus
