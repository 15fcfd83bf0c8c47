// SPDX-License-Identifier: BSD-3-Clause
// Tells the observers of an object whether the object still exists.
#pragma once

#include <memory>

#include "boxplus/base/abi.h"

namespace boxplus::detail {

/// Shared by an object and its observers. It outlives the object.
struct LifeState {
  bool is_over = false;
  bool is_in_use = false;  ///< set by an observer that needs exclusive access
};

/// A member of the observed object. The life of the object ends when it is destroyed, moved from or assigned
/// to by move. The target of a move begins a new life. A copy of the object gets a new Lifetime.
class Lifetime {
 public:
  Lifetime() = default;
  Lifetime(const Lifetime&) = delete;
  Lifetime(Lifetime&& other) noexcept { other.end(); }
  Lifetime& operator=(const Lifetime&) = delete;
  Lifetime& operator=(Lifetime&& other) noexcept {
    end();
    other.end();
    return *this;
  }
  ~Lifetime() { end(); }

  /// The state of the current life. The first call of each life allocates.
  const std::shared_ptr<LifeState>& state() const {
    if (!state_) state_ = std::make_shared<LifeState>();
    return state_;
  }

 private:
  void end() noexcept {
    if (state_) state_->is_over = true;
    state_.reset();
  }

  mutable std::shared_ptr<LifeState> state_;
};

}  // namespace boxplus::detail
