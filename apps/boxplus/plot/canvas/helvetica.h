// SPDX-License-Identifier: BSD-3-Clause
// The widths of Helvetica's letters, for centering and right-aligning text.
#pragma once

namespace boxplus::app {

/// The width in thousandths of the text size. Letters outside ASCII have the width of an n.
int helvetica_width(unsigned char letter, bool is_bold);

}  // namespace boxplus::app
