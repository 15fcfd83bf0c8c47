// SPDX-License-Identifier: BSD-3-Clause
#include "files/clean_end.h"

#include <csignal>

#include "boxplus/io/write_file.h"
#include "platform/signals.h"

namespace boxplus::app {

void end_cleanly_on_signals() {
  for (const int each : kEndSignals) {
    if (std::signal(each, end_cleanly) == SIG_IGN) std::signal(each, SIG_IGN);
  }
}

/// May call only async-signal-safe functions.
extern "C" void end_cleanly(int signal) {
  remove_temporary_files();
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

}  // namespace boxplus::app
