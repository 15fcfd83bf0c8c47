// SPDX-License-Identifier: BSD-3-Clause
// The frames of a run, so that a page that is opened or reloaded later has its time line.
#pragma once

#include <cstddef>
#include <vector>

#include "viewer/protocol/messages.h"

namespace boxplus::viewer {

/// If the frames take too much memory, every second one between the first and the last is forgotten.
class FrameHistory {
 public:
  static constexpr std::size_t kMostBytes = std::size_t{1} << 26;

  explicit FrameHistory(std::size_t most_bytes = kMostBytes) : most_bytes_(most_bytes) {}

  void clear();
  void add(Message frame);
  /// In the order of add().
  const std::vector<Message>& frames() const { return frames_; }

 private:
  std::size_t most_bytes_, bytes_ = 0;
  /// Of the frames that come, only each such one is kept.
  std::size_t stride_ = 1, count_ = 0;
  std::vector<Message> frames_;
};

}  // namespace boxplus::viewer
