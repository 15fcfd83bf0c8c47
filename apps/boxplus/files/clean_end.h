// SPDX-License-Identifier: BSD-3-Clause
// Signals that end the process leave no half-written files.
#pragma once

namespace boxplus::app {

/// Has SIGINT, SIGTERM and SIGHUP, where they are not ignored, call end_cleanly().
void end_cleanly_on_signals();

/// A signal handler: ends the process as the signal does by default, and removes temporary files before.
extern "C" void end_cleanly(int signal);

}  // namespace boxplus::app
