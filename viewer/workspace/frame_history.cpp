// SPDX-License-Identifier: BSD-3-Clause
#include "viewer/workspace/frame_history.h"

#include <utility>

namespace boxplus::viewer {

void FrameHistory::clear() {
  frames_.clear();
  bytes_ = count_ = 0;
  stride_ = 1;
}

void FrameHistory::add(Message frame) {
  if (count_++ % stride_ != 0) return;
  bytes_ += frame->size();
  frames_.push_back(std::move(frame));
  while (bytes_ > most_bytes_ && frames_.size() > 1) {
    stride_ *= 2;
    std::vector<Message> kept;
    bytes_ = 0;
    for (std::size_t k = 0; k < frames_.size(); k += 2) {
      bytes_ += frames_[k]->size();
      kept.push_back(std::move(frames_[k]));
    }
    frames_ = std::move(kept);
  }
}

}  // namespace boxplus::viewer
