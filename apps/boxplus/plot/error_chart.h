// SPDX-License-Identifier: BSD-3-Clause
// Charts of the reprojection errors of each image.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "boxplus/graph/graph.h"
#include "plot/picture.h"

namespace boxplus::app {

/// The lengths of the reprojection errors of one image, or of a few consecutive images, in pixels.
struct ImageErrors {
  static constexpr std::array kParts{0.05, 0.25, 0.5, 0.75, 0.95};
  Id first = 0;
  std::array<double, kParts.size()> quantiles{};  ///< for kParts
};

struct ErrorChart {
  std::string title;
  std::vector<ImageErrors> images;  ///< in the order of ids
  double median = 0, mean = 0;      ///< of all finite errors, in pixels
  std::size_t image_count = 0, observations = 0;
  std::size_t infinite = 0;  ///< the number of errors that are not finite, and not in the chart
};

/// Returns the chart of a graph of bundle adjustment (viewer::is_bundle()). An image is the first vertex of a
/// reprojection error. If there are many images, consecutive images share a box.
ErrorChart make_error_chart(const Graph& graph, std::string title);

/// Draws one panel per chart. All panels have the same logarithmic axis. Throws InvalidArgument if a PNG file
/// would have more than 50 million pixels.
std::string draw_error_charts(std::vector<ErrorChart> charts, const PictureOptions& options,
                              PictureFormat format, double resolution);

}  // namespace boxplus::app
