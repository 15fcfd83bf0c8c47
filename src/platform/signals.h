// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <csignal>

namespace boxplus {

/// The signals with which users and systems end a program.
inline constexpr int kEndSignals[] = {SIGINT, SIGTERM, SIGHUP};

/// A set of signals, which is empty at first.
struct SignalSet {
  SignalSet() { sigemptyset(&value); }
  sigset_t value;
};

/// While it exists, kEndSignals wait for next() instead of ending the process. Threads that are created in
/// the meantime do not receive them either.
class HeldEndSignals {
 public:
  HeldEndSignals();
  ~HeldEndSignals();
  HeldEndSignals(const HeldEndSignals&) = delete;
  HeldEndSignals& operator=(const HeldEndSignals&) = delete;

  /// Waits for one of the signals.
  void next() const;
  /// The signals that this thread blocked before.
  const SignalSet& before() const { return before_; }

 private:
  SignalSet signals_, before_;
};

}  // namespace boxplus
