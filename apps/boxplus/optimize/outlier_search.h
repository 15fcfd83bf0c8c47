// SPDX-License-Identifier: BSD-3-Clause
// The outputs of `boxplus optimize --outliers`.
#pragma once

#include <string>

#include "boxplus/optimize/outliers.h"

namespace boxplus::app {

/// Returns a sentence such as "12 of 50 loop closures are false." with the note of the search.
std::string outliers_text(const OutlierReport& found);

/// Returns a list of the suspects that are no inliers: one line "VERDICT FROM TO CHI2" each, after a line
/// that names the columns.
std::string outliers_list(const OutlierReport& found);

/// Removes the outliers. Undecided closures remain. If all edges are suspects, undecided edges that do not
/// fit are removed, too: they contradict each other.
void remove_outliers(Graph& graph, const OutlierReport& found);

}  // namespace boxplus::app
