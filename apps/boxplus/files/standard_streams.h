// SPDX-License-Identifier: BSD-3-Clause
// Guards against standard streams that the parent of the process has closed.
#pragma once

namespace boxplus::app {

/// Opens /dev/null for each standard stream that is closed. The mode is such that reading from stdin and
/// writing to stdout or stderr still fail. Without this function, the next file that the process opens could
/// become its standard error, and messages would be written into that file. Must be called before any file is
/// opened.
void reserve_standard_streams();

}  // namespace boxplus::app
