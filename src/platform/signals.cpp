// SPDX-License-Identifier: BSD-3-Clause
#include "platform/signals.h"

#include <signal.h>

namespace boxplus {

HeldEndSignals::HeldEndSignals() {
  for (const int each : kEndSignals) sigaddset(&signals_.value, each);
  ::pthread_sigmask(SIG_BLOCK, &signals_.value, &before_.value);
}

HeldEndSignals::~HeldEndSignals() {
  ::pthread_sigmask(SIG_SETMASK, &before_.value, nullptr);
}

void HeldEndSignals::next() const {
  int signal = 0;
  while (::sigwait(&signals_.value, &signal) != 0) {
  }
}

}  // namespace boxplus
