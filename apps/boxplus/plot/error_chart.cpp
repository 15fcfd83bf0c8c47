// SPDX-License-Identifier: BSD-3-Clause
#include "plot/error_chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

#include "plot/colors.h"
#include "plot/panel.h"

namespace boxplus::app {
namespace {

constexpr std::size_t kMostBoxes = 120;

double quantile(const std::vector<double>& sorted, double part) {
  return sorted[std::lround(part * static_cast<double>(sorted.size() - 1))];
}

/// The finite errors of each image, by id.
std::map<Id, std::vector<double>> errors_by_image(const Graph& graph, std::size_t& infinite) {
  std::map<Id, std::vector<double>> errors;
  for (const EdgeRef& edge : graph.all_edges()) {
    double square = 0;
    for (const double value : graph.error(edge)) square += value * value;
    std::vector<double>& list = errors[graph.id(graph.vertices(edge).front())];
    if (std::isfinite(square)) {
      list.push_back(std::sqrt(square));
    } else {
      ++infinite;
    }
  }
  return errors;
}

/// A logarithmic axis of errors.
struct Axis {
  double low = 0.1, high = 1;

  explicit Axis(const std::vector<ErrorChart>& charts) {
    double least = std::numeric_limits<double>::infinity(), most = 0;
    for (const ErrorChart& chart : charts) {
      for (const ImageErrors& image : chart.images) {
        if (image.quantiles.front() > 0) least = std::min(least, image.quantiles.front());
        most = std::max(most, image.quantiles.back());
      }
    }
    if (!(most > 0)) return;
    constexpr double kMostDecades = 5;
    high = round_above(most);
    low = std::max(round_below(std::min(least, most)), high * std::pow(10, -kMostDecades));
    if (!(high > low)) low = high / 10;
  }

  /// 0 at the low end, 1 at the high end.
  double part(double value) const {
    return value > low ? std::min(1.0, std::log(value / low) / std::log(high / low)) : 0;
  }

  /// Calls f(value, is_labeled) for 1, 2 and 5 times each power of ten.
  template <class F>
  void for_each_tick(F&& f) const {
    constexpr double kRounding = 1e-9;
    const bool is_short = high / low < 200;
    const double first = std::floor(std::log10(low) + kRounding);
    for (int k = 0; first + k <= std::log10(high) + kRounding; ++k) {
      const double power = std::pow(10, first + k);
      for (const double digit : {1.0, 2.0, 5.0}) {
        const double value = digit * power;
        if (value >= low * (1 - kRounding) && value <= high * (1 + kRounding))
          f(value, digit == 1 || is_short);
      }
    }
  }

 private:
  static double power_below(double value) { return std::pow(10, std::floor(std::log10(value))); }
  static double round_below(double value) {
    const double power = power_below(value);
    return value >= 5 * power ? 5 * power : value >= 2 * power ? 2 * power : power;
  }
  static double round_above(double value) {
    const double power = power_below(value);
    return value <= 2 * power ? 2 * power : value <= 5 * power ? 5 * power : 10 * power;
  }
};

class ChartPainter {
 public:
  ChartPainter(const ErrorChart& chart, const Axis& axis, const Box& plot, const Layout& layout,
               Canvas& canvas)
      : chart_(chart),
        axis_(axis),
        plot_(plot),
        unit_(layout.unit()),
        text_(layout.text()),
        canvas_(canvas) {}

  void draw() {
    grid();
    const double step = plot_.width / static_cast<double>(std::max<std::size_t>(1, chart_.images.size()));
    for (std::size_t i = 0; i < chart_.images.size(); ++i) draw_box(i, step);
    names(step);
  }

 private:
  double height_of(double value) const { return plot_.bottom() - plot_.height * axis_.part(value); }

  void grid() {
    constexpr Rgb kGrid{0xe5, 0xe7, 0xeb}, kFine{0xf3, 0xf4, 0xf6};
    axis_.for_each_tick([&](double value, bool is_labeled) {
      const double y = height_of(value);
      canvas_.line({plot_.left, y}, {plot_.right(), y}, {is_labeled ? kGrid : kFine, std::max(0.5, unit_)});
      if (!is_labeled) return;
      canvas_.text({plot_.left - 8 * text_, y + 4.5 * text_}, {.size = 13 * text_, .anchor = Anchor::kEnd},
                   fmt::format("{:g}", value));
    });
    canvas_.text({plot_.left, plot_.top - 9 * text_}, {.size = 13 * text_, .anchor = Anchor::kEnd}, "px");
  }

  void draw_box(std::size_t i, double step) {
    const auto& q = chart_.images[i].quantiles;
    const double middle = plot_.left + step * (static_cast<double>(i) + 0.5);
    const double width = std::clamp(0.68 * step, 1.0, 34 * unit_),
                 line = std::clamp(width / 7, 0.6, 1.3 * unit_);
    const Rgb color = trajectory_color(
        static_cast<double>(i) / static_cast<double>(std::max<std::size_t>(2, chart_.images.size()) - 1));
    canvas_.line({middle, height_of(q[0])}, {middle, height_of(q[4])}, {color, line, 0.7});
    const double top = height_of(q[3]), bottom = std::max(height_of(q[1]), top + 1);
    canvas_.fill({middle - width / 2, top, width, bottom - top}, std::min(2 * unit_, width / 4), color);
    constexpr Rgb kWhite{0xff, 0xff, 0xff};
    const double y = height_of(q[2]), half = std::max(0.0, width / 2 - line);
    canvas_.line({middle - half, y}, {middle + half, y}, {kWhite, std::max(0.8, 1.3 * unit_)});
  }

  /// Writes the ids of some images below the boxes, at equal distances.
  void names(double step) {
    std::size_t longest = 0;
    for (const ImageErrors& image : chart_.images)
      longest = std::max(longest, std::to_string(image.first).size());
    const double width = (8 * static_cast<double>(longest) + 8) * text_;
    const auto stride = static_cast<std::size_t>(std::max(1.0, std::ceil(width / step)));
    for (std::size_t i = 0; i < chart_.images.size(); i += stride) {
      const double middle = plot_.left + step * (static_cast<double>(i) + 0.5);
      canvas_.text({middle, plot_.bottom() + 19 * text_}, {.size = 13 * text_, .anchor = Anchor::kMiddle},
                   std::to_string(chart_.images[i].first));
    }
  }

  const ErrorChart& chart_;
  const Axis& axis_;
  const Box& plot_;
  double unit_, text_;
  Canvas& canvas_;
};

std::string facts_of(const ErrorChart& chart) {
  std::string facts =
      fmt::format("median {:.3g} px, mean {:.3g} px  ·  {} image{}, {} observation{}", chart.median,
                  chart.mean, chart.image_count, chart.image_count == 1 ? "" : "s", chart.observations,
                  chart.observations == 1 ? "" : "s");
  if (chart.infinite > 0) facts += fmt::format(" ({} not finite)", chart.infinite);
  return facts;
}

/// Draws an example of a box that lies on its side, with the meaning of its parts.
void draw_box_legend(const Layout& layout, Canvas& canvas) {
  const double text = layout.text(), left = 30 * layout.unit(), y = layout.legend_top() + 34 * text;
  const Rgb color = trajectory_color(0.4);
  constexpr Rgb kWhite{0xff, 0xff, 0xff};
  canvas.line({left, y}, {left + 46 * text, y}, {color, 1.2 * text, 0.7});
  canvas.fill({left + 12 * text, y - 6 * text, 20 * text, 12 * text}, 2 * text, color);
  canvas.line({left + 22 * text, y - 5 * text}, {left + 22 * text, y + 5 * text}, {kWhite, 1.4 * text});
  canvas.text({left + 58 * text, y + 5 * text}, {.size = 15 * text},
              "reprojection errors by image: median, middle half, middle 90 %");
}

}  // namespace

ErrorChart make_error_chart(const Graph& graph, std::string title) {
  ErrorChart chart;
  chart.title = std::move(title);
  chart.observations = graph.edge_count();
  const std::map<Id, std::vector<double>> by_image = errors_by_image(graph, chart.infinite);
  chart.image_count = by_image.size();
  const std::size_t per_box = (by_image.size() + kMostBoxes - 1) / kMostBoxes;
  std::vector<double> all, box;
  Id first = 0;
  std::size_t count = 0;
  for (const auto& [id, errors] : by_image) {
    if (count % per_box == 0) first = id;
    box.insert(box.end(), errors.begin(), errors.end());
    if (++count % per_box != 0 && count != by_image.size()) continue;
    all.insert(all.end(), box.begin(), box.end());
    std::sort(box.begin(), box.end());
    if (!box.empty()) {
      ImageErrors& image = chart.images.emplace_back();
      image.first = first;
      std::transform(ImageErrors::kParts.begin(), ImageErrors::kParts.end(), image.quantiles.begin(),
                     [&box](double part) { return quantile(box, part); });
    }
    box.clear();
  }
  if (all.empty()) return chart;
  std::sort(all.begin(), all.end());
  chart.median = quantile(all, 0.5);
  chart.mean = std::accumulate(all.begin(), all.end(), 0.0) / static_cast<double>(all.size());
  return chart;
}

std::string draw_error_charts(std::vector<ErrorChart> charts, const PictureOptions& options,
                              PictureFormat format, double resolution) {
  constexpr bool kHasTicks = true;
  const Layout layout(options, charts.size(), kHasTicks);
  const std::unique_ptr<Canvas> canvas = begin_picture(layout, options, format, resolution);
  if (layout.title_height() == 0 && !options.title.empty()) charts.front().title = options.title;
  const Axis axis(charts);
  for (std::size_t i = 0; i < charts.size(); ++i) {
    const PanelLayout place = layout.panel(i);
    if (!options.is_bare)
      draw_card_with_header(charts[i].title, facts_of(charts[i]), place.frame, layout, *canvas);
    ChartPainter(charts[i], axis, place.plot, layout, *canvas).draw();
  }
  if (!options.is_bare) draw_box_legend(layout, *canvas);
  return canvas->finish();
}

}  // namespace boxplus::app
