// SPDX-License-Identifier: BSD-3-Clause
// Results of a search for false edges that must not count as converged, although the final run is.
#pragma once

#include <string>

#include "boxplus/outliers/outliers.h"

namespace boxplus::outliers {

/// The search was ended by Options::stop or the time limit.
void mark_as_stopped(Report& report, const Options& options);

/// The result may be wrong, as `message` says. It becomes the note if there is none.
void doubt(OutlierReport& result, const std::string& message);

/// Loop closures were judged, and most of them take no part.
void doubt_if_most_are_rejected(OutlierReport& result);

}  // namespace boxplus::outliers
