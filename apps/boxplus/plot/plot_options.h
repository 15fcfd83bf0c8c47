// SPDX-License-Identifier: BSD-3-Clause
// The options of `boxplus plot`.
#pragma once

#include <optional>
#include <string>

#include "boxplus/io/graph_file.h"
#include "optimize/optimize_options.h"
#include "plot/picture.h"

namespace boxplus::app {

/// The format of the output: that of a picture or, without a value, a page (.html).
using PlotFormat = std::optional<PictureFormat>;

struct PlotArguments {
  std::string before, after, truth, output;
  std::optional<PlotFormat> format;
  View view;
  PictureOptions picture;
  double resolution = 2;
  bool has_ellipses = false;
  bool has_error_chart = false;
  RunSettings kernel;
  ReadOptions reading;
};

/// Adds all options of the command. They set `arguments`, which must outlive the command.
void add_plot_options(CLI::App& command, PlotArguments& arguments);

/// Returns the format that --format names. Without --format, the extension of the output selects the format;
/// if there is no extension, the format is SVG. Throws InvalidArgument if the extension is unknown or
/// contradicts --format.
PlotFormat format_of(const PlotArguments& arguments);

/// Throws InvalidArgument if the parsed command has an option that only pictures have.
void refuse_options_of_pictures(const CLI::App& command);

}  // namespace boxplus::app
