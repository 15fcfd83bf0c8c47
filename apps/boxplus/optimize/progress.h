// SPDX-License-Identifier: BSD-3-Clause
// Shows the progress of a run on stderr.
#pragma once

#include <string>

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
  explicit Progress(ProgressKind kind) : kind_(kind) {}
  ~Progress() { erase(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Shows what the command is doing. Has an effect only with kLive.
  void stage(const std::string& text);
  void iteration(const IterationRecord& record);
  void erase();

 private:
  void rewrite(const std::string& text);

  ProgressKind kind_;
  bool shown_ = false;
};

}  // namespace boxplus::app
