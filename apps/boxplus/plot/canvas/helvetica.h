// SPDX-License-Identifier: BSD-3-Clause
// The widths of the letters of Helvetica, for centering and right-aligning text.
#pragma once

namespace boxplus::app {

/// Returns the width of a letter of WinAnsiEncoding in thousandths of the text size. Outside of ASCII, only
/// the middle dot and the ellipsis have exact widths; for all other letters, returns the width of an n.
int helvetica_width(unsigned char letter, bool is_bold);

}  // namespace boxplus::app
