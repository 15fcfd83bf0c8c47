// SPDX-License-Identifier: BSD-3-Clause
#include "plot/axes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace boxplus::app {
namespace {

constexpr Rgb kFrameColor{0x9c, 0xa3, 0xaf};

/// Returns the largest number ≤ `most` that is 1, 2 or 5 times a power of ten.
double round_length(double most) {
  const double power = std::pow(10, std::floor(std::log10(most)));
  return most >= 5 * power ? 5 * power : most >= 2 * power ? 2 * power : power;
}
/// Returns the smallest number ≥ `least` that is 1, 2 or 5 times a power of ten.
double round_length_above(double least) {
  const double power = std::pow(10, std::floor(std::log10(least)));
  return least <= power       ? power
         : least <= 2 * power ? 2 * power
         : least <= 5 * power ? 5 * power
                              : 10 * power;
}

/// Returns `value` with as many decimals as the step needs. The minus sign is as wide as a digit.
std::string value_text(double value, double step) {
  constexpr double kLong = 1e7;
  constexpr int kMostDecimals = 6;
  const int decimals = std::max(0, -static_cast<int>(std::floor(std::log10(step) + 1e-9)));
  const double magnitude = std::abs(value) < step / 2 ? 0 : std::abs(value);
  const std::string digits = magnitude >= kLong || decimals > kMostDecimals
                                 ? fmt::format("{:.6g}", magnitude)
                                 : fmt::format("{:.{}f}", magnitude, decimals);
  return (value < 0 && magnitude > 0 ? "−" : "") + digits;
}

/// Calls f(value) for each multiple of the step in [low, high]. If the values are so large that rounding
/// hides the step, does not call f.
template <class F>
void for_each_multiple(double low, double high, double step, F&& f) {
  constexpr double kMost = 1e15;
  const double first = std::ceil(low / step), last = std::floor(high / step);
  if (!(std::max(std::abs(first), std::abs(last)) < kMost)) return;
  for (double k = first; k <= last; ++k) f(k * step);
}

}  // namespace

std::optional<AxisNames> axis_names(bool is_spatial, const View& view) {
  if (!is_spatial || view == View{0, 90}) return AxisNames{"x", "y"};
  if (view == View{0, 0}) return AxisNames{"x", "z"};
  return std::nullopt;
}

void draw_ticks(const PlaneMap& map, const AxisNames& names, const Layout& layout, Canvas& canvas) {
  const Box& plot = map.plot;
  const double text = layout.text(), length = 5 * text, half_width = plot.width / 2 / map.scale,
               half_height = plot.height / 2 / map.scale;
  const Stroke pen{kFrameColor, std::max(0.5, layout.unit())};
  const double step = round_length_above(std::max(58 * text, 1.0) / map.scale);
  Path path;
  path.move_to({plot.left, plot.top});
  path.line_to({plot.left, plot.bottom()});
  path.line_to({plot.right(), plot.bottom()});
  for_each_multiple(map.center_x - half_width, map.center_x + half_width, step, [&](double x) {
    const double at = map(x, 0).x;
    path.move_to({at, plot.bottom()});
    path.line_to({at, plot.bottom() + length});
    canvas.text({at, plot.bottom() + length + 14 * text}, {.size = 13 * text, .anchor = Anchor::kMiddle},
                value_text(x, step));
  });
  for_each_multiple(map.center_y - half_height, map.center_y + half_height, step, [&](double y) {
    const double at = map(0, y).y;
    path.move_to({plot.left - length, at});
    path.line_to({plot.left, at});
    canvas.text({plot.left - length - 4 * text, at + 4.5 * text}, {.size = 13 * text, .anchor = Anchor::kEnd},
                value_text(y, step));
  });
  canvas.stroke(path, pen);
  canvas.text({plot.right(), plot.bottom() - 7 * text}, {.size = 13 * text, .anchor = Anchor::kEnd},
              fmt::format("{} [m]", names.across));
  canvas.text({plot.left + 6 * text, plot.top + 3 * text}, {.size = 13 * text},
              fmt::format("{} [m]", names.up));
}

void draw_arrows(const Box& plot, const View& view, const Layout& layout, Canvas& canvas) {
  const double text = layout.text(), length = 38 * text;
  const Point origin{plot.left + length, plot.bottom() - length / 2};
  constexpr std::array<const char*, 3> kNames{"x", "y", "z"};
  const Stroke pen{kFaintInk, std::max(0.5, 1.4 * layout.unit())};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::array<double, 3> unit{};
    unit[axis] = 1;
    const Spot seen = project(unit, 3, view);
    const double shown = std::hypot(seen[0], seen[1]);
    if (shown < 0.05) continue;  // the axis points at the viewer
    const double dx = seen[0] / shown, dy = -seen[1] / shown, tip = length * shown,
                 head = std::min(6 * text, tip / 2);
    const auto at = [&](double along, double beside) {
      return Point{origin.x + along * dx - beside * dy, origin.y + along * dy + beside * dx};
    };
    Path arrow;
    arrow.move_to(origin);
    arrow.line_to(at(tip, 0));
    arrow.move_to(at(tip - head, head / 2));
    arrow.line_to(at(tip, 0));
    arrow.line_to(at(tip - head, -head / 2));
    canvas.stroke(arrow, pen);
    const Point name = at(tip + 9 * text, 0);
    canvas.text({name.x, name.y + 4 * text}, {.size = 13 * text, .anchor = Anchor::kMiddle}, kNames[axis]);
  }
}

void draw_scale_bar(double right, double bottom, double scale, const char* unit_of_length,
                    const Layout& layout, Canvas& canvas) {
  const double unit = layout.unit(), text = layout.text();
  const double length = round_length(130 * unit / scale), left = right - length * scale,
               at = bottom - 26 * text;
  Path bar;
  bar.move_to({left, at});
  bar.line_to({left, at + 6 * text});
  bar.line_to({right, at + 6 * text});
  bar.line_to({right, at});
  canvas.stroke(bar, {kFaintInk, std::max(0.5, 1.4 * unit)});
  canvas.text({(left + right) / 2, at - 2 * text}, {.size = 14 * text, .anchor = Anchor::kMiddle},
              fmt::format("{:g}{}", length, unit_of_length));
}

}  // namespace boxplus::app
