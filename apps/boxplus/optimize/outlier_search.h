// SPDX-License-Identifier: BSD-3-Clause
// The outputs of `boxplus optimize --outliers` and `boxplus info --outliers`.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "boxplus/outliers/outliers.h"

namespace boxplus::app {

/// Returns a text such as "12 of 50 loop closures are false, and 3 are undecided".
std::string verdicts_text(const OutlierReport& found);

/// Returns verdicts_text() as a sentence that says what the report of the run is about, with the time and the
/// note of the search.
std::string outliers_text(const OutlierReport& found);

/// Returns a list of the suspects that are no inliers: one line "VERDICT FROM TO CHI2" each, after a line
/// that names the columns.
std::string outliers_list(const OutlierReport& found);

/// Returns the counts, the note and the verdicts.
nlohmann::ordered_json outliers_json(const OutlierReport& found);

/// Removes the outliers. Undecided closures remain. If all edges are suspects, undecided edges that do not
/// fit are removed, too: they contradict each other.
void remove_outliers(Graph& graph, const OutlierReport& found);

}  // namespace boxplus::app
