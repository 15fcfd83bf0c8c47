// SPDX-License-Identifier: BSD-3-Clause
// How far a run has come, on stderr.
#pragma once

#include <string>

#include "boxplus/optimize/options.h"

namespace boxplus::app {

enum class ProgressKind : std::uint8_t {
  kNone,
  kLive,  ///< one line of a terminal, rewritten and at last erased
  kLines  ///< a line per iteration, for logs
};

/// Live on a terminal, unless it was asked for lines or quiet.
ProgressKind choose_progress(bool quiet, bool verbose);

class Progress {
 public:
  explicit Progress(ProgressKind kind) : kind_(kind) {}
  ~Progress() { erase(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// What is being done; on live lines only.
  void stage(const std::string& text);
  void iteration(const IterationRecord& record);
  void erase();

 private:
  void rewrite(const std::string& text);

  ProgressKind kind_;
  bool shown_ = false;
};

}  // namespace boxplus::app
