// SPDX-License-Identifier: BSD-3-Clause
// Progress of a run, on stderr.
#pragma once

#include <string>

#include "boxplus/optimize/options.h"

namespace boxplus::app {

enum class ProgressKind : std::uint8_t {
  kNone,
  kLive,  ///< one line on a terminal, overwritten again and again, and erased at the end
  kLines  ///< a line per iteration, for logs
};

/// Live on a terminal, unless the user chose lines or quiet.
ProgressKind choose_progress(bool quiet, bool verbose);

class Progress {
 public:
  explicit Progress(ProgressKind kind) : kind_(kind) {}
  ~Progress() { erase(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Names the work in progress; on live lines only.
  void stage(const std::string& text);
  void iteration(const IterationRecord& record);
  void erase();

 private:
  void rewrite(const std::string& text);

  ProgressKind kind_;
  bool shown_ = false;
};

}  // namespace boxplus::app
