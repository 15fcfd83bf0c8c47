// SPDX-License-Identifier: BSD-3-Clause
// The standard streams of the process, which its parent may have closed.
#pragma once

namespace boxplus::app {

/// Opens /dev/null in place of each closed standard stream, in a mode in which reading (stdin) or writing
/// (stdout, stderr) still fails. Without this, the next file that the process opens would become its standard
/// error, and messages would be written into it. Call it before any file is opened.
void reserve_standard_streams();

}  // namespace boxplus::app
