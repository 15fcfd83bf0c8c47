// SPDX-License-Identifier: BSD-3-Clause
// Shows the progress of a run on stderr.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <string_view>

#include "boxplus/base/progress.h"
#include "boxplus/options/options.h"

namespace boxplus::app {

enum class ProgressKind : std::uint8_t {
  kNone,
  kLive,  ///< one line on a terminal, which is overwritten again and again and erased at the end
  kLines  ///< one line per iteration, for logs
};

/// Returns kLines if `verbose` is true. Otherwise returns kLive if stderr is a terminal and `quiet` is false.
ProgressKind choose_progress(bool quiet, bool verbose);

class Progress {
 public:
  explicit Progress(ProgressKind kind);
  ~Progress() { erase(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Shows what the command is doing, and, if this takes a while, how far it has come (ProgressWatch). Has an
  /// effect only with kLive.
  void stage(const std::string& text);
  /// The same, but shows nothing if this takes less than half a second.
  void later(const std::string& text);
  void iteration(const IterationRecord& record);
  void erase();

 private:
  using Clock = std::chrono::steady_clock;

  void watch(std::string_view what, double share);
  void rewrite(const std::string& text);

  ProgressKind kind_;
  bool shown_ = false;
  std::string stage_;
  Clock::time_point begin_, next_;  // of the stage, and of the next line
  std::optional<ProgressWatch> watch_;
};

}  // namespace boxplus::app
