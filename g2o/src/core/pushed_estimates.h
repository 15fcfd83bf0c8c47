// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace g2o {
namespace internal {

/// Saves the estimates of a vertex, or of the active vertices of an optimizer, before a step that may be
/// rejected. The destructor restores the estimates unless keep() or restore() was called, so that the
/// estimates are also restored when client code throws.
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
    } catch (...) {  // client code threw; a destructor must not throw
    }
  }
  /// Keeps the current estimates.
  void keep() { take().discardTop(); }
  /// Restores the saved estimates.
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
