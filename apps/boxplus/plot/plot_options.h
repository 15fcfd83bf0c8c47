// SPDX-License-Identifier: BSD-3-Clause
// The options of `boxplus plot`.
#pragma once

#include <optional>
#include <string>

#include "boxplus/io/graph_file.h"
#include "optimize/optimize_options.h"
#include "plot/picture.h"

namespace boxplus::app {

struct PlotArguments {
  std::string before, after, truth, output;
  std::optional<PictureFormat> format;
  View view;
  PictureOptions picture;
  double resolution = 2;
  bool has_ellipses = false;
  KernelArguments kernel;
  ReadOptions reading;
};

/// Adds all options; they fill `arguments`, which must outlive the command.
void add_plot_options(CLI::App& command, PlotArguments& arguments);

/// The format of --format or, without it, of the ending of the output; SVG if there is neither. Throws
/// InvalidArgument if the ending belongs to another format, or to no known one.
PictureFormat format_of(const PlotArguments& arguments);

}  // namespace boxplus::app
