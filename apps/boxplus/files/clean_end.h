// SPDX-License-Identifier: BSD-3-Clause
// Removes half-written files when a signal ends the process.
#pragma once

namespace boxplus::app {

/// Makes SIGINT, SIGTERM and SIGHUP call end_cleanly(), unless they are ignored.
void end_cleanly_on_signals();

/// A signal handler: removes temporary files, then ends the process as the signal does by default.
extern "C" void end_cleanly(int signal);

}  // namespace boxplus::app
