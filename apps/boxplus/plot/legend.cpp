// SPDX-License-Identifier: BSD-3-Clause
#include "plot/legend.h"

#include <fmt/format.h>

#include <algorithm>

#include "plot/ellipses.h"

namespace boxplus::app {
namespace {

/// Returns 10 to the power of `exponent` as text: 1, 10, 100, 1000, 10⁴, …, 10¹².
std::string power_of_ten(int exponent) {
  if (exponent < 4) return std::string("1000", static_cast<std::size_t>(exponent) + 1);
  constexpr const char* kDigits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  return std::string("10") + (exponent < 10 ? "" : kDigits[1]) + kDigits[exponent % 10];
}

class Legend {
 public:
  Legend(const std::vector<Scene>& scenes, const ErrorColors& colors, const Layout& layout, Canvas& canvas)
      : scenes_(scenes),
        colors_(colors),
        text_(layout.text()),
        start_(30 * layout.unit()),
        left_(start_),
        right_(layout.width() - 30 * layout.unit()),
        middle_(layout.legend_top() + 34 * text_),
        row_(middle_),
        canvas_(canvas) {}

  void draw() {
    is_bundle_ = any([](const Scene& scene) { return scene.is_bundle; });
    if (any([](const Scene& scene) { return scene.poses > 0; })) trajectory();
    if (any([](const Scene& scene) { return !scene.landmarks.empty(); })) landmarks();
    if (any([](const Scene& scene) { return !scene.scan_points.empty(); })) scans();
    if (has(SegmentKind::kTruth)) truth();
    if (any([](const Scene& scene) { return scene.has_ellipses; })) ellipses();
    if (any([](const Scene& scene) { return !scene.points.empty(); })) errors("points (mean)");
    const bool closes = has(SegmentKind::kLoopClosure), observes = has(SegmentKind::kObservation);
    if (closes || observes) {
      errors(closes && observes ? "all edges but odometry" : closes ? "loop closures" : "observations");
    }
  }

 private:
  template <class Predicate>
  bool any(Predicate&& predicate) const {
    return std::any_of(scenes_.begin(), scenes_.end(), predicate);
  }
  bool has(SegmentKind kind) const {
    return any([kind](const Scene& scene) { return scene.has(kind); });
  }

  void swatch(double at, double width, const Stroke& stroke) {
    canvas_.line({at, row_}, {at + width, row_}, stroke);
  }
  /// Begins an entry of this width at left_. If the first row is full, moves to the second row.
  void begin(double width_of_sign, double width_of_name) {
    const double end_of_row = right_ - 250 * text_;
    if (left_ + (width_of_sign + 10 + width_of_name) * text_ <= end_of_row || row_ > middle_) return;
    left_ = start_;
    row_ += 25 * text_;
  }
  /// Writes the name of an entry, and moves left_ to the next entry.
  void name(double width_of_sign, double width_of_name, std::string_view name) {
    canvas_.text({left_ + (width_of_sign + 10) * text_, row_ + 5 * text_}, {.size = 15 * text_}, name);
    left_ += (width_of_sign + 10 + width_of_name + 26) * text_;
  }

  void trajectory() {
    constexpr int kPieces = 10;
    constexpr double kSwatch = 40;
    for (int i = 0; i < kPieces; ++i) {
      swatch(left_ + kSwatch * text_ * i / kPieces, kSwatch * text_ / kPieces,
             {trajectory_color(static_cast<double>(i) / (kPieces - 1)), 3.5 * text_});
    }
    name(kSwatch, 70, is_bundle_ ? "cameras" : "trajectory");
  }

  void landmarks() {
    begin(6, 73);
    canvas_.dot({left_ + 4 * text_, row_}, 7 * text_, kLandmarkColor);
    name(6, 73, "landmarks");
  }

  void scans() {
    constexpr double kSwatch = 16;
    begin(kSwatch, 80);
    for (const double at : {2.0, 6.0, 10.0, 14.0})
      canvas_.dot({left_ + at * text_, row_}, 2.6 * text_, kScanColor);
    name(kSwatch, 80, "laser scans");
  }

  void truth() {
    constexpr double kSwatch = 24;
    begin(kSwatch, 34);
    swatch(left_, kSwatch * text_, {kTruthColor, 6 * text_});
    name(kSwatch, 34, "truth");
  }

  void ellipses() {
    constexpr double kSwatch = 26;
    const bool is_seen = any([](const Scene& scene) { return !scene.ellipses.empty(); });
    const double width = is_seen ? 90 : 200;
    begin(kSwatch, width);
    const Ellipse ellipse{
        {left_ + kSwatch / 2 * text_, -row_}, {kSwatch / 2 * text_, 0}, {0, 6 * text_}, true, 0.4};
    const PlaneMap identity;
    constexpr double kFar = 1e6;
    draw_ellipses({ellipse}, identity, {-kFar, -kFar, 2 * kFar, 2 * kFar}, 1.2 * text_, canvas_);
    name(kSwatch, width, is_seen ? "95 % ellipses" : "95 % ellipses: too small to see");
  }

  void errors(std::string_view what) {
    const double width = 240 * text_, bar = 9 * text_, left = right_ - width, top = middle_ - bar / 2;
    const bool is_robust = any([](const Scene& scene) { return !scene.kernel.empty(); });
    canvas_.text({right_, top - 8 * text_}, {.size = 14 * text_, .anchor = Anchor::kEnd},
                 fmt::format("{}chi2 per row of {}", is_robust ? "robust " : "", what));
    const double bin_width = width / ErrorColors::kBins;
    for (int bin = 0; bin < ErrorColors::kBins; ++bin) {
      canvas_.fill({left + bin_width * bin, top, bin_width + 0.5 * text_, bar}, 0,
                   is_bundle_ ? ErrorColors::point_color(bin) : ErrorColors::color(bin));
    }
    // The first color ends at 1, and the last color begins at the end of the scale.
    const double first = left + bin_width, range = width - 2 * bin_width;
    const int stride = (colors_.decades() + 3) / 4;
    for (int decade = 0; decade <= colors_.decades(); decade += stride) {
      const double at = first + range * decade / colors_.decades();
      canvas_.line({at, top + bar}, {at, top + bar + 4 * text_}, {kFaintInk, text_});
      canvas_.text({at, top + bar + 18 * text_}, {.size = 13 * text_, .anchor = Anchor::kMiddle},
                   power_of_ten(decade));
    }
  }

  const std::vector<Scene>& scenes_;
  const ErrorColors& colors_;
  double text_, start_, left_, right_, middle_, row_;
  bool is_bundle_ = false;
  Canvas& canvas_;
};

}  // namespace

void draw_legend(const std::vector<Scene>& scenes, const ErrorColors& colors, const Layout& layout,
                 Canvas& canvas) {
  Legend(scenes, colors, layout, canvas).draw();
}

}  // namespace boxplus::app
