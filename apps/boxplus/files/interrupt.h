// SPDX-License-Identifier: BSD-3-Clause
// Turns Ctrl-C (SIGINT) and SIGTERM into requests to stop soon and to keep the result so far.
#pragma once

#include <atomic>

namespace boxplus::app {

/// While an Interrupt exists, the first SIGINT or SIGTERM sets flag(), and the second one calls
/// end_cleanly(), which ends the process. A signal that the process ignored at its start (because of nohup or
/// as a background job) stays ignored. Only one Interrupt may exist at a time.
class Interrupt {
 public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  static const std::atomic<bool>* flag();
  static bool raised() { return flag()->load(); }

 private:
  using Handler = void (*)(int);
  Handler old_interrupt_, old_terminate_;
};

}  // namespace boxplus::app
