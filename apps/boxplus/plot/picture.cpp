// SPDX-License-Identifier: BSD-3-Clause
#include "plot/picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "boxplus/base/error.h"
#include "plot/colors.h"
#include "plot/ellipses.h"
#include "plot/legend.h"
#include "plot/panel.h"
#include "plot/thinning.h"

namespace boxplus::app {
namespace {

void require_few_pixels(const Layout& layout, double resolution) {
  constexpr double kMost = 5e7, kLongestSide = 32'767;  // the second is Cairo's
  const double pixels = layout.width() * layout.height() * resolution * resolution,
               side = std::max(layout.width(), layout.height()) * resolution;
  if (pixels > kMost) {
    throw InvalidArgument(
        fmt::format("--size and --resolution: expected at most {:g} pixels, got {:.3g}", kMost, pixels));
  }
  if (side > kLongestSide) {
    throw InvalidArgument(fmt::format(
        "--size and --resolution: expected at most {} pixels per side, got {:.0f}", kLongestSide, side));
  }
}

std::unique_ptr<Canvas> make_canvas(const Layout& layout, const std::string& title, PictureFormat format,
                                    double resolution) {
  switch (format) {
    case PictureFormat::kPdf:
      return make_pdf_canvas(layout.width(), layout.height(), title);
    case PictureFormat::kPng:
      require_few_pixels(layout, resolution);
      return make_png_canvas(layout.width(), layout.height(), resolution);
    default:
      return make_svg_canvas(layout.width(), layout.height(), title);
  }
}

/// Returns the pixels per meter of each panel.
std::vector<double> scales_of(const std::vector<Scene>& scenes, const Layout& layout, bool has_one_scale) {
  // If the scales differ by more than this factor, each panel has its own scale.
  constexpr double kTiny = 2.5;
  double least = std::numeric_limits<double>::infinity(), most = 0;
  std::vector<double> scales;
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    scales.push_back(fitting_scale(scenes[i], layout.panel(i).fit));
    if (!has_extent(scenes[i])) continue;
    least = std::min(least, scales[i]);
    most = std::max(most, scales[i]);
  }
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    if (has_extent(scenes[i]) && (has_one_scale || most <= kTiny * least)) scales[i] = least;
  }
  return scales;
}

}  // namespace

std::unique_ptr<Canvas> begin_picture(const Layout& layout, const PictureOptions& options,
                                      PictureFormat format, double resolution) {
  constexpr Rgb kBackground{0xf8, 0xfa, 0xfc};
  std::unique_ptr<Canvas> canvas = make_canvas(layout, options.title, format, resolution);
  if (!options.is_bare) canvas->fill({0, 0, layout.width(), layout.height()}, 0, kBackground);
  if (layout.title_height() > 0) {
    canvas->text({layout.width() / 2, layout.title_height() - 14 * layout.text()},
                 {.size = 24 * layout.text(), .color = kInk, .anchor = Anchor::kMiddle, .is_bold = true},
                 options.title);
  }
  return canvas;
}

std::string draw_picture(std::vector<Scene> scenes, const View& view, const PictureOptions& options,
                         PictureFormat format, double resolution) {
  constexpr double kVisible = 0.4;        // in pixels
  constexpr std::size_t kMost = 120'000;  // the largest number of elements to draw
  const bool has_ticks =
      options.has_axes && std::all_of(scenes.begin(), scenes.end(), [&](const Scene& scene) {
        return axis_names(scene.is_spatial, view).has_value();
      });
  const Layout layout(options, scenes.size(), has_ticks);
  const std::unique_ptr<Canvas> canvas = begin_picture(layout, options, format, resolution);
  if (layout.title_height() == 0 && !options.title.empty()) scenes.front().title = options.title;
  const ErrorColors colors(scenes);
  const std::vector<double> scales = scales_of(scenes, layout, options.has_one_scale);
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    scenes[i] = thinned(std::move(scenes[i]), kVisible / scales[i], kMost / scenes.size());
    scenes[i].ellipses = legible(scenes[i].ellipses, 1 / scales[i]);
    draw_panel(scenes[i], layout.panel(i), scales[i], {options, layout, colors, view}, *canvas);
  }
  if (!options.is_bare) draw_legend(scenes, colors, layout, *canvas);
  return canvas->finish();
}

}  // namespace boxplus::app
