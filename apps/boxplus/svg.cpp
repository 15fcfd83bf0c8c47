// SPDX-License-Identifier: BSD-3-Clause
#include "svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <tuple>

namespace boxplus::app {
namespace {

constexpr double kPanelWidth = 620, kPanelHeight = 600, kMargin = 28, kHeader = 86, kFooter = 62;
constexpr int kDepthLayers = 10, kHues = 24;
constexpr const char* kInk = "#1f2937";
constexpr const char* kFaintInk = "#6b7280";
constexpr const char* kLoopColour = "#94a3b8";
constexpr const char* kLandmarkColour = "#ea580c";

using Colour = std::array<double, 3>;

/// From the beginning of the trajectory to its end: indigo, blue, teal, green, gold.
std::string trajectory_colour(double time) {
  constexpr std::array<Colour, 5> kStops{
      {{67, 56, 202}, {37, 99, 235}, {8, 145, 178}, {22, 163, 74}, {217, 164, 6}}};
  const double at = std::clamp(time, 0.0, 1.0) * (kStops.size() - 1);
  const auto first = std::min(static_cast<std::size_t>(at), kStops.size() - 2);
  const double part = at - static_cast<double>(first);
  std::array<int, 3> rgb{};
  for (std::size_t i = 0; i < 3; ++i) {
    rgb[i] = static_cast<int>(std::lround((1 - part) * kStops[first][i] + part * kStops[first + 1][i]));
  }
  return fmt::format("#{:02x}{:02x}{:02x}", rgb[0], rgb[1], rgb[2]);
}

std::string escaped(std::string_view text) {
  std::string result;
  for (char c : text) {
    if (c == '&') {
      result += "&amp;";
    } else if (c == '<') {
      result += "&lt;";
    } else if (static_cast<unsigned char>(c) >= ' ') {
      result += c;
    }
  }
  return result;
}

/// Pixels per metre with which the scene fills a panel.
double fitting_scale(const Scene& scene) {
  const double width = scene.high[0] - scene.low[0], height = scene.high[1] - scene.low[1];
  const double across = width > 0 ? (kPanelWidth - 2 * kMargin) / width : 1e9;
  const double up = height > 0 ? (kPanelHeight - kHeader - kFooter) / height : 1e9;
  const double scale = std::min(across, up);
  return scale < 1e9 ? scale : 1;
}

/// 1, 2 or 5 times a power of ten.
double round_length(double most) {
  const double power = std::pow(10, std::floor(std::log10(most)));
  return most >= 5 * power ? 5 * power : most >= 2 * power ? 2 * power : power;
}

class Panel {
 public:
  Panel(const Scene& scene, double left, double scale, std::string& out)
      : scene_(scene), left_(left), scale_(scale), out_(std::back_inserter(out)) {}

  void draw() {
    fmt::format_to(
        out_,
        "<rect x=\"{}\" y=\"8\" width=\"{}\" height=\"{}\" rx=\"10\" fill=\"#ffffff\" stroke=\"#e5e7eb\"/>\n",
        left_ + 8, kPanelWidth - 16, kPanelHeight - 16);
    header();
    lines();
    landmarks();
    scale_bar();
    legend();
  }

 private:
  double x(const Spot& spot) const {
    return left_ + kPanelWidth / 2 + scale_ * (spot[0] - (scene_.low[0] + scene_.high[0]) / 2);
  }
  double y(const Spot& spot) const {
    const double middle = (kHeader + kPanelHeight - kFooter) / 2;
    return middle - scale_ * (spot[1] - (scene_.low[1] + scene_.high[1]) / 2);
  }
  int layer(double depth) const {
    const double range = scene_.high[2] - scene_.low[2];
    if (!(range > 0)) return kDepthLayers - 1;
    return std::clamp(static_cast<int>((depth - scene_.low[2]) / range * kDepthLayers), 0, kDepthLayers - 1);
  }
  /// What is far is faint.
  static double nearness(int layer) { return 0.3 + 0.7 * (layer + 1) / kDepthLayers; }

  void text(double at_x, double at_y, double size, const char* colour, const char* extra,
            std::string_view words) {
    fmt::format_to(out_, "<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"{}\" fill=\"{}\"{}>{}</text>\n", at_x,
                   at_y, size, colour, extra, escaped(words));
  }

  void header() {
    text(left_ + kMargin, 42, 19, kInk, " font-weight=\"600\"", scene_.title);
    std::string facts = fmt::format("chi2 = {:.6g}   ·   {} poses", scene_.chi2, scene_.poses);
    if (!scene_.landmarks.empty()) facts += fmt::format(", {} landmarks", scene_.landmarks.size());
    facts += fmt::format(", {} edges", scene_.edges);
    text(left_ + kMargin, 65, 13.5, kFaintInk, "", facts);
  }

  /// One path per layer, kind and hue: far ones first, loop closures below the trajectory of their layer.
  void lines() {
    std::map<std::tuple<int, SegmentKind, int>, std::string> paths;
    for (const Segment& segment : scene_.segments) {
      const bool hued = segment.kind == SegmentKind::kTrajectory;
      const int hue = hued ? std::min(static_cast<int>(segment.time * kHues), kHues - 1) : 0;
      std::string& path = paths[{layer((segment.from[2] + segment.to[2]) / 2), segment.kind, hue}];
      fmt::format_to(std::back_inserter(path), "M{:.1f} {:.1f}L{:.1f} {:.1f}", x(segment.from),
                     y(segment.from), x(segment.to), y(segment.to));
    }
    for (const auto& [key, path] : paths) {
      const auto& [depth, kind, hue] = key;
      const bool hued = kind == SegmentKind::kTrajectory;
      const double opacity = nearness(depth) * (hued ? 1 : kind == SegmentKind::kLoopClosure ? 0.55 : 0.16);
      fmt::format_to(out_, "<path d=\"{}\" stroke=\"{}\" stroke-width=\"{}\" stroke-opacity=\"{:.2f}\"/>\n",
                     path,
                     hued                                ? trajectory_colour((hue + 0.5) / kHues)
                     : kind == SegmentKind::kLoopClosure ? kLoopColour
                                                         : kLandmarkColour,
                     hued ? 1.4 : 0.7, opacity);
    }
  }

  void landmarks() {
    for (const Spot& spot : scene_.landmarks) {
      fmt::format_to(out_,
                     "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"2.2\" fill=\"{}\" fill-opacity=\"{:.2f}\"/>\n",
                     x(spot), y(spot), kLandmarkColour, nearness(layer(spot[2])));
    }
  }

  void scale_bar() {
    const double length = round_length(130 / scale_), right = left_ + kPanelWidth - kMargin,
                 at = kPanelHeight - 34;
    fmt::format_to(out_, "<path d=\"M{:.1f} {:.1f}v6h{:.1f}v-6\" stroke=\"{}\" stroke-width=\"1.4\"/>\n",
                   right - length * scale_, at, length * scale_, kFaintInk);
    text(right - length * scale_ / 2, at - 2, 12.5, kFaintInk, " text-anchor=\"middle\"",
         fmt::format("{:g} m", length));
  }

  void legend() {
    double at = left_ + kMargin;
    const double base = kPanelHeight - 28;
    const auto entry = [&](std::string_view words, double width, auto&& symbol) {
      symbol();
      text(at + 32, base, 12.5, kFaintInk, "", words);
      at += width;
    };
    const auto has = [&](SegmentKind kind) {
      return std::any_of(scene_.segments.begin(), scene_.segments.end(),
                         [&](const Segment& s) { return s.kind == kind; });
    };
    entry("trajectory", 112, [&] {
      for (int i = 0; i < 4; ++i) {
        fmt::format_to(out_, "<path d=\"M{:.1f} {:.1f}h6.5\" stroke=\"{}\" stroke-width=\"3\"/>\n",
                       at + 6.5 * i, base - 4, trajectory_colour(i / 3.0));
      }
    });
    if (has(SegmentKind::kLoopClosure)) {
      entry("loop closures", 130, [&] {
        fmt::format_to(out_, "<path d=\"M{:.1f} {:.1f}h26\" stroke=\"{}\" stroke-width=\"1.6\"/>\n", at,
                       base - 4, kLoopColour);
      });
    }
    if (!scene_.landmarks.empty()) {
      entry("landmarks", 110, [&] {
        fmt::format_to(out_, "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3\" fill=\"{}\"/>\n", at + 14, base - 4,
                       kLandmarkColour);
      });
    }
  }

  const Scene& scene_;
  double left_, scale_;
  std::back_insert_iterator<std::string> out_;
};

}  // namespace

std::string svg_of(std::span<const Scene> scenes) {
  const double width = kPanelWidth * static_cast<double>(scenes.size());
  std::string out = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\" "
      "fill=\"none\" "
      "font-family=\"Inter, 'Helvetica Neue', Helvetica, Arial, sans-serif\" stroke-linecap=\"round\" "
      "stroke-linejoin=\"round\">\n<rect width=\"{0}\" height=\"{1}\" fill=\"#f8fafc\"/>\n",
      width, kPanelHeight);
  double least = 1e300, most = 0;
  for (const Scene& scene : scenes) {
    least = std::min(least, fitting_scale(scene));
    most = std::max(most, fitting_scale(scene));
  }
  constexpr double kTiny = 2.5;  // panels that differ by more have their own scales
  double left = 0;
  for (const Scene& scene : scenes) {
    Panel(scene, left, most > kTiny * least ? fitting_scale(scene) : least, out).draw();
    left += kPanelWidth;
  }
  return out + "</svg>\n";
}

}  // namespace boxplus::app
