// SPDX-License-Identifier: BSD-3-Clause
// A picture of the time of each step.
#pragma once

#include <string>
#include <vector>

#include "plot/picture.h"

namespace boxplus::app {

/// Draws a dot per step, over a logarithmic axis of times, and the median as a line. `title` says what was
/// measured, and `facts` is the line below it.
std::string draw_time_chart(const std::vector<double>& seconds, const std::string& title,
                            const std::string& facts, PictureFormat format);

}  // namespace boxplus::app
