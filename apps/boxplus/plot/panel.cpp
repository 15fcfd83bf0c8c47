// SPDX-License-Identifier: BSD-3-Clause
#include "plot/panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <span>
#include <tuple>

#include "plot/ellipses.h"

namespace boxplus::app {
namespace {

constexpr int kDepthLayers = 10, kHues = 24;

std::string counted(std::size_t count, std::string_view what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

std::string chi2_text(const Scene& scene) {
  if (!std::isfinite(scene.chi2)) return "chi2 is not finite";
  return fmt::format("chi2 = {:.6g}{}", scene.chi2, scene.kernel.empty() ? "" : " (" + scene.kernel + ")");
}

/// Returns the stroke for a kind of segment.
Stroke stroke_for(SegmentKind kind, int color, bool is_crowded) {
  const double badness = static_cast<double>(color) / (ErrorColors::kBins - 1);
  switch (kind) {
    case SegmentKind::kTruth:
      return {kTruthColor, 4, 0.85};
    case SegmentKind::kTrajectory:
      return {trajectory_color((color + 0.5) / kHues), 1.5, 1};
    case SegmentKind::kLoopClosure:
      return {ErrorColors::color(color), color == 0 ? 0.7 : 1, 0.6 + 0.3 * badness};
    default:
      return {ErrorColors::color(color), 0.7, is_crowded ? 0.25 + 0.5 * badness : 0.75};
  }
}

class ScenePainter {
 public:
  ScenePainter(const Scene& scene, const PlaneMap& map, const PanelStyle& style, Canvas& canvas)
      : scene_(scene), map_(map), unit_(style.layout.unit()), colors_(style.colors), canvas_(canvas) {}

  void draw() {
    segments();
    landmarks();
    dots();
  }

 private:
  Point at(const Spot& spot) const { return map_(spot[0], spot[1]); }
  int layer(double depth) const {
    const double range = scene_.high[2] - scene_.low[2];
    if (!(range > 0)) return kDepthLayers - 1;
    return std::clamp(static_cast<int>((depth - scene_.low[2]) / range * kDepthLayers), 0, kDepthLayers - 1);
  }
  /// Returns the opacity of a layer. Distant layers are fainter.
  static double nearness(int layer) { return 0.3 + 0.7 * (layer + 1) / kDepthLayers; }

  int color_of(const Segment& segment) const {
    switch (segment.kind) {
      case SegmentKind::kTruth:
        return 0;
      case SegmentKind::kTrajectory:
        return std::min(static_cast<int>(segment.time * kHues), kHues - 1);
      default:
        return colors_.bin(segment.chi2_per_row);
    }
  }

  /// Draws the segments, grouped by layer, kind and color. Distant layers come first. Within a layer, errors
  /// come before the trajectory, and small errors come before large errors.
  void segments() {
    std::map<std::tuple<int, SegmentKind, int>, std::vector<const Segment*>> groups;
    for (const Segment& segment : scene_.segments) {
      groups[{layer((segment.from[2] + segment.to[2]) / 2), segment.kind, color_of(segment)}].push_back(
          &segment);
    }
    for (const auto& [key, group] : groups) {
      const auto& [depth, kind, color] = key;
      Stroke stroke = stroke_for(kind, color, scene_.segments.size() > 500);
      stroke.opacity *= nearness(depth);
      stroke.width *= unit_;
      draw(group, stroke);
    }
  }

  /// Draws the segments as several short paths, because viewers take quadratic time for the crossings within
  /// a path.
  void draw(std::span<const Segment* const> segments, const Stroke& stroke) {
    constexpr std::size_t kPiece = 256;
    for (; !segments.empty(); segments = segments.subspan(std::min(kPiece, segments.size()))) {
      Path path;
      const Segment* last = nullptr;
      for (const Segment* segment : segments.first(std::min(kPiece, segments.size()))) {
        if (!last || last->to != segment->from) path.move_to(at(segment->from));
        path.line_to(at(segment->to));
        last = segment;
      }
      canvas_.stroke(path, stroke);
    }
  }

  void landmarks() {
    std::map<int, Path> paths;
    for (const Spot& spot : scene_.landmarks) paths[layer(spot[2])].move_to(at(spot));
    const double size = scene_.landmarks.size() > 1000 ? 2.4 : 4.2;
    for (const auto& [depth, path] : paths)
      canvas_.stroke(path, {kLandmarkColor, size * unit_, nearness(depth)});
  }

  void dots() {
    const double size = scene_.dots.size() > 1000 ? 2.4 : 6;
    for (const Dot& dot : scene_.dots) canvas_.dot(at(dot.spot), size * unit_, trajectory_color(dot.time));
  }

  const Scene& scene_;
  const PlaneMap& map_;
  double unit_;
  const ErrorColors& colors_;
  Canvas& canvas_;
};

void draw_card(const Box& box, const Layout& layout, Canvas& canvas) {
  constexpr Rgb kEdge{0xe5, 0xe7, 0xeb}, kWhite{0xff, 0xff, 0xff};
  const double radius = 10 * layout.unit(), edge = std::max(0.5, layout.unit());
  canvas.fill({box.left - edge / 2, box.top - edge / 2, box.width + edge, box.height + edge}, radius, kEdge);
  canvas.fill({box.left + edge / 2, box.top + edge / 2, box.width - edge, box.height - edge}, radius - edge,
              kWhite);
}

void draw_header(const Scene& scene, const Box& frame, const Layout& layout, Canvas& canvas) {
  const double left = frame.left + 22 * layout.unit(), text = layout.text();
  canvas.text({left, frame.top + 36 * text}, {.size = 21 * text, .color = kInk, .is_bold = true},
              scene.title);
  std::string facts = fmt::format("{}  ·  {}", chi2_text(scene), counted(scene.poses, "pose"));
  if (scene.landmark_count > 0) facts += ", " + counted(scene.landmark_count, "landmark");
  canvas.text({left, frame.top + 61 * text}, {.size = 15 * text},
              facts + ", " + counted(scene.edges, "edge"));
}

}  // namespace

double fitting_scale(const Scene& scene, const Box& box) {
  constexpr double kMost = 1e9;
  const double width = scene.high[0] - scene.low[0], height = scene.high[1] - scene.low[1];
  const double across = width > 0 ? box.width / width : kMost, up = height > 0 ? box.height / height : kMost;
  const double scale = std::min(across, up);
  return scale < kMost ? scale : 1;
}

bool has_extent(const Scene& scene) {
  return scene.high[0] > scene.low[0] || scene.high[1] > scene.low[1];
}

void draw_panel(const Scene& scene, const PanelLayout& place, double scale, const PanelStyle& style,
                Canvas& canvas) {
  const PictureOptions& options = style.options;
  const PlaneMap map{place.plot, scale, (scene.low[0] + scene.high[0]) / 2,
                     (scene.low[1] + scene.high[1]) / 2};
  if (!options.is_bare) {
    draw_card(place.frame, style.layout, canvas);
    draw_header(scene, place.frame, style.layout, canvas);
  }
  const std::optional<AxisNames> names = axis_names(scene.is_spatial, style.view);
  const bool has_ticks = options.has_axes && names.has_value();
  if (has_ticks && has_extent(scene)) draw_ticks(map, *names, style.layout, canvas);
  ScenePainter(scene, map, style, canvas).draw();
  draw_ellipses(scene.ellipses, map, place.frame, style.layout.unit(), canvas);
  if (!has_extent(scene)) return;
  if (options.has_axes && !has_ticks) draw_arrows(place.plot, style.view, style.layout, canvas);
  const bool has_bar = options.is_bare ? options.has_axes && !has_ticks : !has_ticks;
  if (has_bar) {
    const Box& box = options.is_bare ? place.plot : place.frame;
    const double inset = options.is_bare ? 0 : 22 * style.layout.unit();
    draw_scale_bar(box.right() - inset, box.bottom(), scale, style.layout, canvas);
  }
}

}  // namespace boxplus::app
