// SPDX-License-Identifier: BSD-3-Clause
// The order in which an algorithm may call the functions of a System.
#pragma once

#include <cstdint>

namespace boxplus {

/// Knows whether the last linearization belongs to the current estimates, and whether try_step() is waiting
/// for accept() or reject(). The functions that check throw InvalidArgument. `function` is the name of the
/// function that was called.
class CallOrder {
 public:
  void forget() { stage_ = Stage::kNotLinearized; }  ///< the estimates or the graph changed
  void linearized() { stage_ = Stage::kLinearized; }
  void moved() { stage_ = Stage::kTrying; }
  void accepted() { stage_ = Stage::kNotLinearized; }
  void rejected() { stage_ = Stage::kLinearized; }

  bool is_trying() const { return stage_ == Stage::kTrying; }
  void expect_no_trial(const char* function) const {
    if (is_trying()) refuse(function, "accept() or reject() after try_step()");
  }
  void expect_linearization(const char* function) const {
    expect_no_trial(function);
    if (stage_ != Stage::kLinearized)
      refuse(function, "linearize() before, at the current estimates; after accept(), call it again");
  }
  void expect_trial(const char* function) const {
    if (!is_trying()) refuse(function, "an earlier try_step() that was neither accepted nor rejected");
  }

 private:
  enum class Stage : std::uint8_t { kNotLinearized, kLinearized, kTrying };

  [[noreturn]] static void refuse(const char* function, const char* expected);

  Stage stage_ = Stage::kNotLinearized;
};

}  // namespace boxplus
