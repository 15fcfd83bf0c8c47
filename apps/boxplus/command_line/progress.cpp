// SPDX-License-Identifier: BSD-3-Clause
#include "command_line/progress.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "command_line/message.h"
#include "platform/standard_streams.h"

namespace boxplus::app {
namespace {

/// Returns the number of columns of the terminal. A longer line would wrap, and could not be overwritten.
std::size_t terminal_columns() {
  const std::size_t columns = stderr_columns();
  return columns > 0 ? columns : 80;
}

/// Returns the first `size` bytes of the text, or fewer if the last character would be incomplete.
std::string cut(const std::string& text, std::size_t size) {
  while (size > 0 && size < text.size() && (static_cast<unsigned char>(text[size]) & 0xC0) == 0x80) --size;
  return text.substr(0, size);
}

std::string line_of(const IterationRecord& record) {
  return fmt::format("iteration {:3}  chi2 {:<13.7g}  step {:<10.3e}  {:.2f} s", record.iteration,
                     record.chi2, record.step_max, record.time_s);
}

}  // namespace

ProgressKind choose_progress(bool quiet, bool verbose) {
  if (verbose) return ProgressKind::kLines;
  return !quiet && stderr_is_terminal() ? ProgressKind::kLive : ProgressKind::kNone;
}

Progress::Progress(ProgressKind kind) : kind_(kind) {
  if (kind == ProgressKind::kLive)
    watch_.emplace([this](std::string_view what, double share) { watch(what, share); });
}

void Progress::stage(const std::string& text) {
  later(text);
  if (kind_ == ProgressKind::kLive) rewrite(stage_);
}

void Progress::later(const std::string& text) {
  if (kind_ != ProgressKind::kLive) return;
  stage_ = escaped(text);
  begin_ = Clock::now();
  constexpr auto kPatience = std::chrono::milliseconds(500);
  next_ = begin_ + kPatience;
}

/// Shows how far the stage has come, some times a second.
void Progress::watch(std::string_view what, double share) {
  const Clock::time_point now = Clock::now();
  if (now < next_) return;
  constexpr auto kPause = std::chrono::milliseconds(100);
  next_ = now + kPause;
  const double seconds = std::chrono::duration<double>(now - begin_).count();
  std::string text = stage_;
  if (!what.empty()) text += fmt::format("  {}", what);
  if (share > 0) {
    text += fmt::format("  {:.0f} %, {:.0f} s left", 100 * share, std::ceil(seconds * (1 / share - 1)));
  } else {
    text += fmt::format("  {:.0f} s", seconds);
  }
  rewrite(text);
}

void Progress::iteration(const IterationRecord& record) {
  if (kind_ == ProgressKind::kLines) write_to_stderr(line_of(record) + "\n");
  if (kind_ == ProgressKind::kLive) rewrite(line_of(record));
}

void Progress::erase() {
  if (shown_) write_to_stderr("\r\x1b[K");
  shown_ = false;
}

void Progress::rewrite(const std::string& text) {
  write_to_stderr("\r\x1b[K" + cut(text, terminal_columns() - 1));
  std::fflush(stderr);
  shown_ = true;
}

}  // namespace boxplus::app
