// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace g2o {
namespace internal {

/// Saves estimates for a step that may be refused: those of a vertex, or of the active vertices of an
/// optimiser. Whatever leaves the scope without keep(), an exception of client code too, restores them.
template <class Stack>
class PushedEstimates {
 public:
  explicit PushedEstimates(Stack& stack) : stack_(&stack) { stack.push(); }
  PushedEstimates(const PushedEstimates&) = delete;
  PushedEstimates& operator=(const PushedEstimates&) = delete;
  ~PushedEstimates() {
    if (stack_ == nullptr) return;
    try {
      stack_->pop();
    } catch (...) {  // client code that throws once more: the first exception is the one to report
    }
  }
  /// The estimates as they are now stay.
  void keep() { take().discardTop(); }
  /// The saved estimates come back.
  void restore() { take().pop(); }

 private:
  Stack& take() {
    Stack* stack = stack_;
    stack_ = nullptr;
    return *stack;
  }
  Stack* stack_;
};

}  // namespace internal
}  // namespace g2o
