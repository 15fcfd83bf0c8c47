// SPDX-License-Identifier: BSD-3-Clause
// The order in which an algorithm may call the functions of a System.
#pragma once

#include <cstddef>
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
  void accepted() {
    stage_ = Stage::kNotLinearized;
    has_accepted_ = true;
  }
  void rejected() { stage_ = Stage::kLinearized; }

  void begin_iteration() { has_accepted_ = false; }

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
  void expect_accepted_in_iteration(const char* function) const {
    if (!has_accepted_)
      refuse(function, "a call of System::accept() before the outcome kAccepted or kAcceptedShort");
  }
  /// Expects a linearization and a vector of `entries` entries.
  void expect_vector(const char* function, std::size_t size, std::size_t entries) const {
    expect_linearization(function);
    if (size != entries) refuse_size(function, size, entries);
  }

 private:
  enum class Stage : std::uint8_t { kNotLinearized, kLinearized, kTrying };

  [[noreturn]] static void refuse(const char* function, const char* expected);
  [[noreturn]] static void refuse_size(const char* function, std::size_t size, std::size_t entries);

  Stage stage_ = Stage::kNotLinearized;
  bool has_accepted_ = false;
};

}  // namespace boxplus
