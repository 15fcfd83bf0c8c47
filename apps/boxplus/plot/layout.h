// SPDX-License-Identifier: BSD-3-Clause
// Where the parts of a picture lie, in pixels.
#pragma once

namespace boxplus::app {

inline constexpr double kPanelWidth = 620, kPanelHeight = 592, kMargin = 30, kHeader = 92, kFooter = 50;
inline constexpr double kLegendHeight = 74, kHeight = kPanelHeight + kLegendHeight;

}  // namespace boxplus::app
