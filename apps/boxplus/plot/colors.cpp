// SPDX-License-Identifier: BSD-3-Clause
#include "plot/colors.h"

#include <algorithm>
#include <cmath>

namespace boxplus::app {
namespace {

using Color = std::array<double, 3>;

Rgb blended(std::span<const Color> stops, double part) {
  const double at = std::clamp(part, 0.0, 1.0) * static_cast<double>(stops.size() - 1);
  const auto first = std::min(static_cast<std::size_t>(at), stops.size() - 2);
  const double rest = at - static_cast<double>(first);
  const auto mixed = [&](std::size_t i) {
    return static_cast<std::uint8_t>(std::lround((1 - rest) * stops[first][i] + rest * stops[first + 1][i]));
  };
  return {mixed(0), mixed(1), mixed(2)};
}

}  // namespace

Rgb trajectory_color(double time) {
  constexpr std::array<Color, 4> kStops{{{49, 46, 129}, {37, 99, 235}, {8, 145, 178}, {52, 190, 140}}};
  return blended(kStops, time);
}

ErrorColors::ErrorColors(std::span<const Scene> scenes) {
  std::vector<double> errors;
  for (const Scene& scene : scenes) {
    for (const Segment& segment : scene.segments) {
      const bool has_error =
          segment.kind == SegmentKind::kLoopClosure || segment.kind == SegmentKind::kObservation;
      if (has_error && std::isfinite(segment.chi2_per_row)) errors.push_back(segment.chi2_per_row);
    }
    for (const SeenPoint& point : scene.points) {
      if (std::isfinite(point.chi2_per_row)) errors.push_back(point.chi2_per_row);
    }
  }
  if (errors.empty()) return;
  constexpr double kShown = 0.99;
  constexpr int kMostDecades = 12;
  const double shown = std::ceil(kShown * static_cast<double>(errors.size()));
  const auto quantile = errors.begin() + static_cast<std::ptrdiff_t>(shown) - 1;
  std::nth_element(errors.begin(), quantile, errors.end());
  if (*quantile > 1)
    decades_ = std::clamp(static_cast<int>(std::ceil(std::log10(*quantile))), 1, kMostDecades);
}

int ErrorColors::bin(double chi2_per_row) const {
  if (chi2_per_row <= 1) return 0;
  const double part = std::log10(chi2_per_row) / decades_;
  return part < 1 ? 1 + static_cast<int>(part * (kBins - 2)) : kBins - 1;
}

Rgb ErrorColors::point_color(int bin) {
  constexpr Rgb kGood{0x64, 0x74, 0x8b};
  return bin == 0 ? kGood : color(bin);
}

Rgb ErrorColors::color(int bin) {
  constexpr std::array<Color, 5> kStops{
      {{166, 178, 194}, {226, 148, 36}, {207, 74, 31}, {157, 18, 80}, {69, 8, 79}}};
  return blended(kStops, static_cast<double>(bin) / (kBins - 1));
}

}  // namespace boxplus::app
