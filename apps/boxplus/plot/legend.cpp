// SPDX-License-Identifier: BSD-3-Clause
#include "plot/legend.h"

#include <algorithm>

#include "plot/layout.h"

namespace boxplus::app {
namespace {

/// As in text: 1, 10, 100, 1000, 10⁴, …, 10¹².
std::string power_of_ten(int exponent) {
  if (exponent < 4) return std::string("1000", static_cast<std::size_t>(exponent) + 1);
  constexpr const char* kDigits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  return std::string("10") + (exponent < 10 ? "" : kDigits[1]) + kDigits[exponent % 10];
}

class Legend {
 public:
  Legend(const std::vector<Scene>& scenes, const ErrorColours& colours, double width, SvgWriter& svg)
      : scenes_(scenes), colours_(colours), width_(width), svg_(svg) {}

  void draw() {
    double at = kMargin;
    if (any([](const Scene& scene) { return scene.poses > 0; })) at = trajectory(at);
    if (any([](const Scene& scene) { return !scene.landmarks.empty(); })) landmarks(at);
    const bool closes = has(SegmentKind::kLoopClosure), observes = has(SegmentKind::kObservation);
    if (closes || observes) {
      errors(closes && observes ? "all but odometry" : closes ? "loop closures" : "observations");
    }
  }

 private:
  static constexpr double kMiddle = kPanelHeight + 34, kSwatch = 40;

  template <class Predicate>
  bool any(Predicate&& predicate) const {
    return std::any_of(scenes_.begin(), scenes_.end(), predicate);
  }
  bool has(SegmentKind kind) const {
    return any([kind](const Scene& scene) { return scene.has(kind); });
  }

  double trajectory(double at) {
    constexpr int kPieces = 10;
    for (int i = 0; i < kPieces; ++i) {
      svg_.line(at + kSwatch * i / kPieces, kMiddle, kSwatch / kPieces, 0, 3.5,
                trajectory_colour(static_cast<double>(i) / (kPieces - 1)));
    }
    svg_.text(at + kSwatch + 10, kMiddle + 5, {}, "trajectory");
    return at + 150;
  }

  void landmarks(double at) {
    svg_.line(at, kMiddle, 0, 0, 7, kLandmarkColour);
    svg_.text(at + 13, kMiddle + 5, {}, "landmarks");
  }

  void errors(std::string_view what) {
    constexpr double kWidth = 240, kBar = 9;
    const double left = width_ - kMargin - kWidth, top = kMiddle - kBar / 2;
    svg_.text(left + kWidth, top - 8, {.size = 14, .anchor = Anchor::kEnd},
              fmt::format("chi2 per row of {}", what));
    for (int bin = 0; bin < ErrorColours::kBins; ++bin) {
      svg_.add("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{}\" fill=\"{}\"/>\n",
               left + kWidth * bin / ErrorColours::kBins, top, kWidth / ErrorColours::kBins + 0.5, kBar,
               ErrorColours::colour(bin));
    }
    // The first colour ends at 1, the last begins at the end of the scale.
    const double bin_width = kWidth / ErrorColours::kBins, first = left + bin_width,
                 range = kWidth - 2 * bin_width;
    const int stride = (colours_.decades() + 3) / 4;
    for (int decade = 0; decade <= colours_.decades(); decade += stride) {
      const double at = first + range * decade / colours_.decades();
      svg_.line(at, top + kBar, 0, 4, 1, kFaintInk);
      svg_.text(at, top + kBar + 18, {.size = 13, .anchor = Anchor::kMiddle}, power_of_ten(decade));
    }
  }

  const std::vector<Scene>& scenes_;
  const ErrorColours& colours_;
  double width_;
  SvgWriter& svg_;
};

}  // namespace

void draw_legend(const std::vector<Scene>& scenes, const ErrorColours& colours, double width,
                 SvgWriter& svg) {
  Legend(scenes, colours, width, svg).draw();
}

}  // namespace boxplus::app
