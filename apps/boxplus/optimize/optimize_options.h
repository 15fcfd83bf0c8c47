// SPDX-License-Identifier: BSD-3-Clause
// The options of `boxplus optimize`.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "boxplus/io/graph_file.h"
#include "boxplus/optimize/options.h"
#include "boxplus/robust/robust_kernel.h"
#include "command_line/id_ranges.h"

namespace CLI {
class App;
}

namespace boxplus::app {

enum class KernelScope : std::uint8_t { kAll, kLoopClosures };

/// The options for robust kernels.
struct KernelArguments {
  std::string kernel;                  ///< the name of the kernel; empty if edges get no kernel
  std::optional<double> kernel_width;  ///< the width; if absent, the default for the rows of each edge
  KernelScope kernel_scope = KernelScope::kAll;
};
/// Adds --kernel and the options that belong to it. They set `arguments`.
void add_robust_options(CLI::App& command, KernelArguments& arguments);

struct OptimizeArguments : KernelArguments {
  std::string input, output, json;
  bool quiet = false, verbose = false;
  ReadOptions reading;
  Options options;

  std::vector<IdRange> fixed, moving;

  OptimizeArguments() { options.start = Start::kAutomatic; }
};

/// Adds all options of the command. They set `arguments`, which must outlive the command.
void add_optimize_options(CLI::App& command, OptimizeArguments& arguments);

}  // namespace boxplus::app
