// SPDX-License-Identifier: BSD-3-Clause
#include "files/interrupt.h"

#include <csignal>

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

auto install(int signal) {
  const auto old = std::signal(signal, raise_flag);
  if (old == SIG_IGN) std::signal(signal, SIG_IGN);
  return old;
}

}  // namespace

Interrupt::Interrupt() {
  interrupted.store(false);
  old_interrupt_ = install(SIGINT);
  old_terminate_ = install(SIGTERM);
}

Interrupt::~Interrupt() {
  std::signal(SIGINT, old_interrupt_);
  std::signal(SIGTERM, old_terminate_);
}

const std::atomic<bool>* Interrupt::flag() {
  return &interrupted;
}

}  // namespace boxplus::app
