// SPDX-License-Identifier: BSD-3-Clause
// Shows how far a long call has come.
#pragma once

#include <pybind11/pybind11.h>

#include <chrono>
#include <optional>
#include <string>
#include <string_view>

#include "boxplus/base/progress.h"

namespace boxplus::python {

/// While this object exists, a line on Python's stderr shows how far calls on this thread have come, if
/// stderr is a terminal (boxplus/_progress.py). Make and destroy it with Python's lock (GIL), and call
/// without it.
class ShownProgress {
 public:
  explicit ShownProgress(const char* what) {
    const pybind11::module_ module = pybind11::module_::import("boxplus._progress");
    if (!module.attr("is_shown")().cast<bool>()) return;
    line_ = module.attr("Line")(what);
    next_ = Clock::now() + seconds(module.attr("PATIENCE_S"));
    pause_ = seconds(module.attr("PAUSE_S"));
    watch_.emplace([this](std::string_view stage, double share) { show(stage, share); });
  }
  ~ShownProgress() {
    if (watch_) quietly([&] { line_.attr("erase")(); });
  }
  ShownProgress(const ShownProgress&) = delete;
  ShownProgress& operator=(const ShownProgress&) = delete;

 private:
  using Clock = std::chrono::steady_clock;

  static Clock::duration seconds(const pybind11::object& value) {
    return std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(value.cast<double>()));
  }
  void show(std::string_view stage, double share) {
    if (Clock::now() < next_) return;
    const pybind11::gil_scoped_acquire acquired;
    quietly([&] { line_.attr("show")(std::string(stage), share); });
    next_ = Clock::now() + pause_;
  }
  /// A line that cannot be shown does not matter.
  template <class F>
  static void quietly(F&& f) {
    try {
      f();
    } catch (pybind11::error_already_set& error) {
      error.discard_as_unraisable("boxplus: progress");
    }
  }

  pybind11::object line_;
  Clock::time_point next_;
  Clock::duration pause_{};
  std::optional<ProgressWatch> watch_;
};

}  // namespace boxplus::python
