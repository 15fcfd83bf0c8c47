// SPDX-License-Identifier: BSD-3-Clause
// The widths of Helvetica's letters, to place text by its middle or end.
#pragma once

namespace boxplus::app {

/// In thousandths of the size of the text. Letters beyond ASCII count as an n.
int helvetica_width(unsigned char letter, bool is_bold);

}  // namespace boxplus::app
