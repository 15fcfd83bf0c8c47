// SPDX-License-Identifier: BSD-3-Clause
// Removes partly written files when a signal ends the process.
#pragma once

namespace boxplus::app {

/// Makes SIGINT, SIGTERM and SIGHUP call end_cleanly(). Signals that the process ignores stay ignored.
void end_cleanly_on_signals();

/// A signal handler. Removes temporary files, and then ends the process by the default action of the signal.
extern "C" void end_cleanly(int signal);

}  // namespace boxplus::app
