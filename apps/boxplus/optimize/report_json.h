// SPDX-License-Identifier: BSD-3-Clause
// Formats a Report as JSON, for scripts.
#pragma once

#include <optional>
#include <string>

#include "boxplus/certify/certificate.h"
#include "boxplus/outliers/outliers.h"
#include "optimize/position_priors.h"
#include "settings/run_settings.h"

namespace boxplus::app {

/// Facts about the run that are not in the Report.
struct RunFacts {
  std::string input;
  std::string output;     ///< where the result was written; empty if it was not
  std::size_t edges = 0;  ///< the number of edges in the file
  std::int64_t skipped_lines = 0;
  std::int64_t indefinite_edges = 0;
  KernelFacts kernel;
  std::optional<PositionPriors> priors;    ///< of --position-priors
  std::optional<OutlierReport> outliers;   ///< of --outliers
  std::optional<Certificate> certificate;  ///< of --certify
  std::optional<Certificate> of_better;    ///< of the better minimum that it has found
  double load_s = 0, total_s = 0;
};

/// Returns an indented JSON object that ends with a newline. Values that are not finite become null.
/// chi2_final and the values that follow from it are those of the written result; chi2_final_of_run is that
/// of the run, before --certify replaced a local minimum.
std::string report_json(const Report& run, const RunFacts& facts);

}  // namespace boxplus::app
