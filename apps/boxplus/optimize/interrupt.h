// SPDX-License-Identifier: BSD-3-Clause
// Ctrl-C (and SIGTERM) as a request to stop soon and keep the result so far.
#pragma once

#include <atomic>
#include <csignal>

namespace boxplus::app {

/// While an Interrupt exists, the first SIGINT or SIGTERM raises flag(), and the second ends the process
/// (end_cleanly). If the process was started with a signal ignored (nohup, background jobs), the signal stays
/// ignored. Only one Interrupt may exist at a time.
class Interrupt {
 public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  static const std::atomic<bool>* flag();
  static bool raised() { return flag()->load(); }

 private:
  using SignalAction = struct sigaction;
  SignalAction old_interrupt_{}, old_terminate_{};
};

}  // namespace boxplus::app
