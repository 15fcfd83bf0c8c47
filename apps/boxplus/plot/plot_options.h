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

/// The format that --format names. Without --format, the output's extension selects the format; without an
/// extension, it is SVG. Throws InvalidArgument if the extension is unknown or contradicts --format.
PictureFormat format_of(const PlotArguments& arguments);

}  // namespace boxplus::app
