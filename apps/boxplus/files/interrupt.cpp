// SPDX-License-Identifier: BSD-3-Clause
#include "files/interrupt.h"

#include "files/clean_end.h"

namespace boxplus::app {
namespace {

std::atomic<bool> interrupted{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may only touch lock-free atomics");

/// May call only async-signal-safe functions.
extern "C" void raise_flag(int /*signal*/) {
  interrupted.store(true);
  std::signal(SIGINT, end_cleanly);
  std::signal(SIGTERM, end_cleanly);
}

void install(int signal, struct sigaction& old) {
  sigaction(signal, nullptr, &old);
  if (old.sa_handler == SIG_IGN) return;
  struct sigaction action {};
  action.sa_handler = raise_flag;
  action.sa_flags = SA_RESTART;
  sigemptyset(&action.sa_mask);
  sigaction(signal, &action, nullptr);
}

}  // namespace

Interrupt::Interrupt() {
  interrupted.store(false);
  install(SIGINT, old_interrupt_);
  install(SIGTERM, old_terminate_);
}

Interrupt::~Interrupt() {
  sigaction(SIGINT, &old_interrupt_, nullptr);
  sigaction(SIGTERM, &old_terminate_, nullptr);
}

const std::atomic<bool>* Interrupt::flag() {
  return &interrupted;
}

}  // namespace boxplus::app
