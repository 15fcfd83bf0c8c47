// SPDX-License-Identifier: BSD-3-Clause
// The options of `boxplus optimize`.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "boxplus/io/graph_file.h"
#include "boxplus/outliers/outliers.h"
#include "boxplus/types/ba/bundle_parts.h"
#include "command_line/id_ranges.h"
#include "settings/run_settings.h"
#include "view/serving.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace boxplus::app {

/// Adds --kernel and the options that belong to it. They set `settings`.
void add_robust_options(CLI::App& command, RunSettings& settings);

/// Adds --outliers with this help. It sets `suspects`, which stays empty if the user chooses "none".
CLI::Option* add_suspects_option(CLI::App& command, std::optional<Suspects>& suspects,
                                 const std::string& help);

struct OptimizeArguments : RunSettings, ServingArguments {
  std::string input, output, json, outlier_list;
  bool quiet = false, verbose = false, view = false;
  std::optional<Suspects> suspects;  ///< of --outliers
  bool remove_outliers = false;      ///< leave the outliers out of the output
  bool strict_output = false;        ///< refuse to write another format than that of the output
  bool certify = false;              ///< decide whether the minimum is global
  std::optional<std::string> petsc;  ///< the options of PETSc, which then solves the linear systems
  ReadOptions reading;
  std::vector<IdRange> fixed, moving;
  std::vector<BundlePart> held, freed;  ///< of bundle adjustment
  double pixel_sigma = 0;               ///< 0: Ω stays as it is
  std::string position_priors;          ///< a file; empty: none
};

/// Adds all options of the command. They set `arguments`, which must outlive the command.
void add_optimize_options(CLI::App& command, OptimizeArguments& arguments);

}  // namespace boxplus::app
