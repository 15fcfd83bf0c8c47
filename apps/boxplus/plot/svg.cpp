// SPDX-License-Identifier: BSD-3-Clause
#include "plot/svg.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <span>
#include <tuple>

#include "plot/colours.h"
#include "plot/layout.h"
#include "plot/legend.h"
#include "plot/svg_writer.h"
#include "plot/thinning.h"

namespace boxplus::app {
namespace {

constexpr int kDepthLayers = 10, kHues = 24;

/// Pixels per metre with which the scene fills a panel.
double fitting_scale(const Scene& scene) {
  constexpr double kMost = 1e9;
  const double width = scene.high[0] - scene.low[0], height = scene.high[1] - scene.low[1];
  const double across = width > 0 ? (kPanelWidth - 2 * kMargin) / width : kMost;
  const double up = height > 0 ? (kPanelHeight - kHeader - kFooter) / height : kMost;
  const double scale = std::min(across, up);
  return scale < kMost ? scale : 1;
}

bool has_extent(const Scene& scene) {
  return scene.high[0] > scene.low[0] || scene.high[1] > scene.low[1];
}

/// 1, 2 or 5 times a power of ten.
double round_length(double most) {
  const double power = std::pow(10, std::floor(std::log10(most)));
  return most >= 5 * power ? 5 * power : most >= 2 * power ? 2 * power : power;
}

std::string counted(std::size_t count, std::string_view what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

/// How a kind of segment is drawn.
struct Pen {
  double width, opacity;
};
Pen pen_for(SegmentKind kind, int bin, bool is_crowded) {
  const double badness = static_cast<double>(bin) / (ErrorColours::kBins - 1);
  switch (kind) {
    case SegmentKind::kTrajectory:
      return {1.5, 1};
    case SegmentKind::kLoopClosure:
      return {bin == 0 ? 0.7 : 1, 0.6 + 0.3 * badness};
    default:
      return {0.7, is_crowded ? 0.25 + 0.5 * badness : 0.75};
  }
}

class Panel {
 public:
  Panel(const Scene& scene, double left, double scale, const ErrorColours& colours, SvgWriter& svg)
      : scene_(scene), left_(left), scale_(scale), colours_(colours), svg_(svg) {}

  void draw() {
    svg_.add(
        "<rect x=\"{}\" y=\"8\" width=\"{}\" height=\"{}\" rx=\"10\" fill=\"#fff\" stroke=\"#e5e7eb\"/>\n",
        left_ + 8, kPanelWidth - 16, kPanelHeight - 8);
    header();
    segments();
    landmarks();
    dots();
    if (has_extent(scene_)) scale_bar();
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

  void header() {
    svg_.text(left_ + kMargin, 44, {.size = 21, .colour = kInk, .is_bold = true}, scene_.title);
    std::string facts = fmt::format("chi2 = {:.6g}  ·  {}", scene_.chi2, counted(scene_.poses, "pose"));
    if (scene_.landmark_count > 0) facts += ", " + counted(scene_.landmark_count, "landmark");
    svg_.text(left_ + kMargin, 69, {}, facts + ", " + counted(scene_.edges, "edge"));
  }

  /// Paths of one layer, kind and colour: far ones first; below the trajectory the errors, small ones first.
  void segments() {
    std::map<std::tuple<int, SegmentKind, int>, std::vector<const Segment*>> groups;
    for (const Segment& segment : scene_.segments) {
      const int colour = segment.kind == SegmentKind::kTrajectory
                             ? std::min(static_cast<int>(segment.time * kHues), kHues - 1)
                             : colours_.bin(segment.chi2_per_row);
      groups[{layer((segment.from[2] + segment.to[2]) / 2), segment.kind, colour}].push_back(&segment);
    }
    for (const auto& [key, group] : groups) {
      const auto& [depth, kind, colour] = key;
      const bool is_trajectory = kind == SegmentKind::kTrajectory;
      Pen pen = pen_for(kind, colour, scene_.segments.size() > 500);
      pen.opacity *= nearness(depth);
      path(group, pen,
           is_trajectory ? trajectory_colour((colour + 0.5) / kHues) : ErrorColours::colour(colour));
    }
  }

  /// In pieces, because viewers take quadratic time for the crossings within a path.
  void path(std::span<const Segment* const> segments, const Pen& pen, std::string_view colour) {
    constexpr std::size_t kPiece = 256;
    for (; !segments.empty(); segments = segments.subspan(std::min(kPiece, segments.size()))) {
      svg_.add("<path d=\"");
      const Segment* last = nullptr;
      for (const Segment* segment : segments.first(std::min(kPiece, segments.size()))) {
        if (!last || last->to != segment->from)
          svg_.add("M{:.1f} {:.1f}", x(segment->from), y(segment->from));
        svg_.add("L{:.1f} {:.1f}", x(segment->to), y(segment->to));
        last = segment;
      }
      svg_.add("\" stroke=\"{}\" stroke-width=\"{}\" stroke-opacity=\"{:.2f}\"/>\n", colour, pen.width,
               pen.opacity);
    }
  }

  /// Round ends of lines without length: the shortest way to write many dots.
  void landmarks() {
    std::map<int, std::string> paths;
    for (const Spot& spot : scene_.landmarks) {
      fmt::format_to(std::back_inserter(paths[layer(spot[2])]), "M{:.1f} {:.1f}h0", x(spot), y(spot));
    }
    const double size = scene_.landmarks.size() > 1000 ? 2.4 : 4.2;
    for (const auto& [depth, path] : paths) {
      svg_.add("<path d=\"{}\" stroke=\"{}\" stroke-width=\"{}\" stroke-opacity=\"{:.2f}\"/>\n", path,
               kLandmarkColour, size, nearness(depth));
    }
  }

  void dots() {
    for (const Dot& dot : scene_.dots) {
      svg_.line(x(dot.spot), y(dot.spot), 0, 0, scene_.dots.size() > 1000 ? 2.4 : 6,
                trajectory_colour(dot.time));
    }
  }

  void scale_bar() {
    const double length = round_length(130 / scale_), right = left_ + kPanelWidth - kMargin,
                 at = kPanelHeight - 26;
    svg_.add("<path d=\"M{:.1f} {:.1f}v6h{:.1f}v-6\" stroke=\"{}\" stroke-width=\"1.4\"/>\n",
             right - length * scale_, at, length * scale_, kFaintInk);
    svg_.text(right - length * scale_ / 2, at - 2, {.size = 14, .anchor = Anchor::kMiddle},
              fmt::format("{:g} m", length));
  }

  const Scene& scene_;
  double left_, scale_;
  const ErrorColours& colours_;
  SvgWriter& svg_;
};

}  // namespace

std::string svg_of(std::vector<Scene> scenes) {
  const double width = kPanelWidth * static_cast<double>(scenes.size());
  const ErrorColours colours(scenes);
  SvgWriter svg;
  svg.add(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\" "
      "fill=\"none\" font-family=\"Inter, 'Helvetica Neue', Helvetica, Arial, sans-serif\" "
      "stroke-linecap=\"round\" stroke-linejoin=\"round\">\n<rect width=\"{0}\" height=\"{1}\" "
      "fill=\"#f8fafc\"/>\n",
      width, kHeight);
  double least = std::numeric_limits<double>::infinity(), most = 0;
  for (const Scene& scene : scenes) {
    if (!has_extent(scene)) continue;
    least = std::min(least, fitting_scale(scene));
    most = std::max(most, fitting_scale(scene));
  }
  constexpr double kTiny = 2.5;           // panels that differ by more have their own scales
  constexpr double kVisible = 0.4;        // pixels
  constexpr std::size_t kMost = 120'000;  // things to draw
  double left = 0;
  for (Scene& scene : scenes) {
    const double scale = most > kTiny * least || !has_extent(scene) ? fitting_scale(scene) : least;
    scene = thinned(std::move(scene), kVisible / scale, kMost / scenes.size());
    Panel(scene, left, scale, colours, svg).draw();
    left += kPanelWidth;
  }
  draw_legend(scenes, colours, width, svg);
  svg.add("</svg>\n");
  return svg.take();
}

}  // namespace boxplus::app
