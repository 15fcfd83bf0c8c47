// SPDX-License-Identifier: BSD-3-Clause
// Ctrl-C (and SIGTERM) as a wish to stop soon, keeping what was found.
#pragma once

#include <atomic>
#include <csignal>

namespace boxplus::app {

/// While one exists, the first SIGINT or SIGTERM raises flag(), and the second ends the process
/// (end_cleanly). A signal that the process was told to ignore (nohup, background jobs) stays ignored. One at
/// a time.
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
