// SPDX-License-Identifier: BSD-3-Clause
#include "plot/panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <span>
#include <tuple>

#include "io/ply/camera_pyramids.h"
#include "plot/ellipses.h"

namespace boxplus::app {
namespace {

constexpr int kDepthLayers = 10, kHues = 24;
constexpr std::size_t kMostLabels = 300;

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
      : scene_(scene),
        map_(map),
        unit_(style.layout.unit()),
        text_(style.layout.text()),
        colors_(style.colors),
        canvas_(canvas) {}

  void draw() {
    scans();
    matches();
    segments();
    landmarks();
    points();
    cameras();
    dots();
    labels();
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

  void scans() {
    std::map<int, Path> paths;
    for (const Spot& spot : scene_.scan_points) paths[layer(spot[2])].move_to(at(spot));
    const double size = scene_.scan_points.size() > 1000 ? 1.2 : 2.4;
    for (const auto& [depth, path] : paths) canvas_.stroke(path, {kScanColor, size * unit_, nearness(depth)});
  }

  void matches() {
    Path path;
    for (const auto& [from, to] : scene_.matches) {
      path.move_to(at(from));
      path.line_to(at(to));
    }
    if (!path.empty()) canvas_.stroke(path, {kFaintInk, 0.6 * unit_, 0.7});
  }

  /// Draws the names of places, except for those that would cover an earlier name.
  void labels() {
    constexpr double kSize = 13;
    const double height = kSize * text_;
    std::vector<Box> taken;
    for (const Label& label : scene_.labels) {
      const Point point = at(label.spot);
      canvas_.dot(point, 4 * unit_, kInk);
      // No letter is wider than its height, and each takes at least one byte.
      const Box box{point.x, point.y - height, height * static_cast<double>(label.text.size()), height};
      const auto covers = [&](const Box& other) {
        return box.left < other.right() && other.left < box.right() && box.top < other.bottom() &&
               other.top < box.bottom();
      };
      if (taken.size() == kMostLabels || std::any_of(taken.begin(), taken.end(), covers)) continue;
      taken.push_back(box);
      canvas_.text({point.x + 4 * unit_, point.y - 3 * unit_}, {.size = height, .color = kInk}, label.text);
    }
  }

  void landmarks() {
    std::map<int, Path> paths;
    for (const Spot& spot : scene_.landmarks) paths[layer(spot[2])].move_to(at(spot));
    const double size = scene_.landmarks.size() > 1000 ? 2.4 : 4.2;
    for (const auto& [depth, path] : paths)
      canvas_.stroke(path, {kLandmarkColor, size * unit_, nearness(depth)});
  }

  /// Draws the points of bundle adjustment, distant layers and small errors first. The more points there are,
  /// the smaller are their dots.
  void points() {
    std::map<std::pair<int, int>, Path> paths;
    for (const SeenPoint& point : scene_.points)
      paths[{layer(point.spot[2]), colors_.bin(point.chi2_per_row)}].move_to(at(point.spot));
    const double area = map_.plot.width * map_.plot.height;
    const double space =
        std::sqrt(area / static_cast<double>(std::max<std::size_t>(1, scene_.points.size())));
    const double size = std::clamp(0.55 * space / unit_, 1.1, 4.5) * unit_;
    for (const auto& [key, path] : paths)
      canvas_.stroke(path, {ErrorColors::point_color(key.second), size, 0.4 + 0.6 * nearness(key.first)});
  }

  void cameras() {
    for (const CameraMark& camera : scene_.cameras) {
      Path path;
      for (const auto& [from, to] : kPyramidLines) {
        path.move_to(at(camera.corners[from]));
        path.line_to(at(camera.corners[to]));
      }
      canvas_.stroke(path, {trajectory_color(camera.time), 1.2 * unit_, 0.9});
    }
  }

  void dots() {
    const double size = scene_.dots.size() > 1000 ? 2.4 : 6;
    for (const Dot& dot : scene_.dots) canvas_.dot(at(dot.spot), size * unit_, trajectory_color(dot.time));
  }

  const Scene& scene_;
  const PlaneMap& map_;
  double unit_, text_;
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

std::string facts_of(const Scene& scene) {
  std::string facts =
      fmt::format("{}  ·  {}", chi2_text(scene), counted(scene.poses, scene.is_bundle ? "camera" : "pose"));
  if (scene.landmark_count > 0)
    facts += ", " + counted(scene.landmark_count, scene.is_bundle ? "point" : "landmark");
  if (scene.outside > 0) facts += fmt::format(" ({} outside)", scene.outside);
  facts += ", " + counted(scene.edges, scene.is_bundle ? "observation" : "edge");
  return scene.scans > 0 ? facts + ", " + counted(scene.scans, "scan") : facts;
}

}  // namespace

void draw_card_with_header(const std::string& title, const std::string& facts, const Box& frame,
                           const Layout& layout, Canvas& canvas) {
  draw_card(frame, layout, canvas);
  const double left = frame.left + 22 * layout.unit(), text = layout.text();
  canvas.text({left, frame.top + 36 * text}, {.size = 21 * text, .color = kInk, .is_bold = true}, title);
  canvas.text({left, frame.top + 61 * text}, {.size = 15 * text}, facts);
}

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
  if (!options.is_bare)
    draw_card_with_header(scene.title, facts_of(scene), place.frame, style.layout, canvas);
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
    draw_scale_bar(box.right() - inset, box.bottom(), scale, scene.is_bundle ? "" : " m", style.layout,
                   canvas);
  }
}

}  // namespace boxplus::app
