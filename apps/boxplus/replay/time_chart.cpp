// SPDX-License-Identifier: BSD-3-Clause
#include "replay/time_chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "plot/colors.h"
#include "plot/panel.h"

namespace boxplus::app {
namespace {

constexpr double kWidth = 900, kHeight = 560, kResolution = 2;

std::string time_text(double seconds) {
  if (seconds >= 0.999) return fmt::format("{:.3g} s", seconds);
  if (seconds >= 0.999e-3) return fmt::format("{:.3g} ms", 1e3 * seconds);
  return fmt::format("{:.3g} µs", 1e6 * seconds);
}

/// Whole decades that contain all times.
struct Decades {
  int low = -6, high = -3;

  explicit Decades(const std::vector<double>& seconds) {
    const auto [least, most] = std::minmax_element(seconds.begin(), seconds.end());
    if (least == seconds.end() || !(*least > 0)) return;
    low = static_cast<int>(std::floor(std::log10(*least)));
    high = std::max(low + 1, static_cast<int>(std::ceil(std::log10(*most))));
  }
  /// 0 at the low end, 1 at the high end.
  double part(double value) const { return (std::log10(std::max(value, 1e-12)) - low) / (high - low); }
};

/// Numbers of steps for the axis below.
std::size_t step_between_ticks(std::size_t steps) {
  double tick = std::pow(10, std::floor(std::log10(std::max<double>(1, static_cast<double>(steps) / 2))));
  return std::max<std::size_t>(1, static_cast<std::size_t>(tick));
}

}  // namespace

std::string draw_time_chart(const std::vector<double>& seconds, const std::string& title,
                            const std::string& facts, PictureFormat format) {
  PictureOptions options;
  options.width = kWidth;
  options.height = kHeight;
  const Layout layout(options, 1, true);
  const std::unique_ptr<Canvas> canvas = begin_picture(layout, options, format, kResolution);
  const PanelLayout place = layout.panel(0);
  draw_card_with_header(title, facts, place.frame, layout, *canvas);
  const Box& plot = place.plot;
  const double text = layout.text();
  const Decades decades(seconds);
  const auto y_of = [&](double value) { return plot.bottom() - plot.height * decades.part(value); };
  for (int power = decades.low; power <= decades.high; ++power) {
    const double value = std::pow(10, power), y = y_of(value);
    canvas->line({plot.left, y}, {plot.right(), y}, {kFaintInk, 1, 0.25});
    canvas->text({plot.left - 8 * text, y + 5 * text}, {.size = 14 * text, .anchor = Anchor::kEnd},
                 time_text(value));
  }
  const double step = plot.width / static_cast<double>(std::max<std::size_t>(1, seconds.size()));
  const std::size_t tick = step_between_ticks(seconds.size());
  for (std::size_t k = 0; k <= seconds.size(); k += tick) {
    canvas->text({plot.left + step * static_cast<double>(k), plot.bottom() + 22 * text},
                 {.size = 14 * text, .anchor = Anchor::kMiddle}, fmt::format("{}", k));
  }
  const Rgb color = trajectory_color(0.4);
  Path dots;
  for (std::size_t k = 0; k < seconds.size(); ++k)
    dots.move_to({plot.left + step * (static_cast<double>(k) + 0.5), y_of(seconds[k])});
  canvas->stroke(dots, {color, 3, 0.6});
  canvas->text({plot.left, layout.legend_top() + 40 * text}, {.size = 15 * text}, "time of each step");
  return canvas->finish();
}

}  // namespace boxplus::app
