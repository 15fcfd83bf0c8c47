// SPDX-License-Identifier: BSD-3-Clause
// The widths of the letters of Helvetica, for centering and right-aligning text.
#pragma once

namespace boxplus::app {

/// Returns the width of a letter of WinAnsiEncoding in thousandths of the text size. Outside of ASCII, only
/// the middle dot and the ellipsis have their own widths; all other letters have the width of an n.
int helvetica_width(unsigned char letter, bool is_bold);

}  // namespace boxplus::app
