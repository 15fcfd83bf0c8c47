// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/core/svg_drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <ostream>
#include <utility>

namespace g2o {
namespace {

constexpr double kMargin = 12;  // pixels

/// A parallel projection of the scene, seen from the south-east and from above.
Matrix3 oblique_view() {
  const AngleAxis turn(-0.6, Vector3::UnitZ()), tilt(-1.0, Vector3::UnitX());
  return (tilt * turn).toRotationMatrix();
}

std::string hex(const Color& color) {
  const auto byte = [](double part) { return static_cast<int>(std::lround(255 * std::clamp(part, 0., 1.))); };
  return fmt::format("#{:02x}{:02x}{:02x}", byte(color.red), byte(color.green), byte(color.blue));
}

std::string opacity(const char* of, const Color& color) {
  return color.alpha < 1 ? fmt::format(" {}-opacity=\"{:.2f}\"", of, std::max(color.alpha, 0.))
                         : std::string();
}

std::string escaped(const std::string& words) {
  std::string result;
  for (const char c : words) {
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

/// The approximate width of a text, in units of the height of its characters.
double width_of(const std::string& words) {
  return 0.6 * static_cast<double>(words.size());
}

}  // namespace

/// Projects the world onto the picture.
class SvgDrawing::Page {
 public:
  Page(const SvgDrawing& drawing, const Matrix3& view) : view_(view) {
    const double infinity = std::numeric_limits<double>::infinity();
    Eigen::Array2d low = Eigen::Array2d::Constant(infinity), high = -low;
    for (const Shape& shape : drawing._shapes) {
      for (const Vector3& corner : shape.corners) {
        const Vector3 seen = view_ * corner;
        low = low.min(seen.head<2>().array());
        high = high.max(seen.head<2>().array());
        if (shape.kind == Kind::kText)
          high = high.max(seen.head<2>().array() + Eigen::Array2d(width_of(shape.words), 1) * shape.size);
      }
    }
    if (drawing._shapes.empty()) low = high = Eigen::Array2d::Zero();
    const Eigen::Array2d extent = high - low;
    scale_ = (drawing._size - 2 * kMargin) / std::max(extent.maxCoeff(), 1e-9);
    corner_ = {low[0], high[1]};
    width = static_cast<int>(std::ceil(extent[0] * scale_ + 2 * kMargin));
    height = static_cast<int>(std::ceil(extent[1] * scale_ + 2 * kMargin));
  }

  std::pair<double, double> place(const Vector3& corner) const {
    const Vector3 seen = view_ * corner;
    return {kMargin + (seen[0] - corner_[0]) * scale_, kMargin + (corner_[1] - seen[1]) * scale_};
  }

  std::string path(const Shape& shape) const {
    std::string d;
    for (const Vector3& corner : shape.corners) {
      const auto [x, y] = place(corner);
      fmt::format_to(std::back_inserter(d), "{}{:.1f} {:.1f}", d.empty() ? 'M' : 'L', x, y);
    }
    if (shape.kind == Kind::kPoint) d += "h0";
    if (shape.isClosed) d += 'z';
    return d;
  }

  /// The color and width attributes at the end of an SVG element. Consecutive shapes that differ only in
  /// their corners share one element.
  std::string style(const Shape& shape) const {
    const std::string color = hex(shape.color);
    if (shape.kind == Kind::kFilled) return fmt::format("fill=\"{}\"{}", color, opacity("fill", shape.color));
    return fmt::format("stroke=\"{}\"{} stroke-width=\"{:.2f}\"", color, opacity("stroke", shape.color),
                       shape.size);
  }

  std::string words(const Shape& shape) const {
    const auto [x, y] = place(shape.corners.front());
    return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"{:.1f}\" fill=\"{}\"{}>{}</text>\n", x, y,
                       shape.size * scale_, hex(shape.color), opacity("fill", shape.color),
                       escaped(shape.words));
  }

  int width = 0, height = 0;

 private:
  Matrix3 view_;
  Vector2 corner_;
  double scale_ = 1;
};

SvgDrawing::SvgDrawing(int size) : _size(std::max(size, 16)), _view(Matrix3::Identity()) {}
SvgDrawing::~SvgDrawing() = default;

void SvgDrawing::add(Kind kind, std::vector<Vector3> corners, bool isClosed, const Color& color, double size,
                     const std::string& words) {
  const auto is_finite = [](const Vector3& v) { return v.allFinite(); };
  if (corners.empty() || !std::all_of(corners.begin(), corners.end(), is_finite)) return;
  for (const Vector3& corner : corners) _isFlat = _isFlat && corner.z() == 0;
  _shapes.push_back({kind, std::move(corners), isClosed, color, size, words});
}

void SvgDrawing::polyline(const std::vector<Vector3>& corners, bool isClosed, const Color& color,
                          double width) {
  add(Kind::kLine, corners, isClosed, color, width, {});
}

void SvgDrawing::point(const Vector3& at, const Color& color, double diameter) {
  add(Kind::kPoint, {at}, false, color, diameter, {});
}

void SvgDrawing::pose(const Isometry3& pose, const Color& color, double length, double width) {
  add(Kind::kFilled,
      {pose * Vector3(length, 0, 0), pose * Vector3(-length / 2, width, 0),
       pose * Vector3(-length / 2, -width, 0)},
      true, color, 0, {});
}

void SvgDrawing::text(const Vector3& at, const std::string& words, const Color& color, double height) {
  add(Kind::kText, {at}, false, color, height, words);
}

void SvgDrawing::setView(const Matrix3& view) {
  _view = view;
  _hasView = true;
}

void SvgDrawing::clear() {
  _shapes.clear();
  _isFlat = true;
}

bool SvgDrawing::write(std::ostream& os) const {
  const Page page(*this, _hasView ? _view : _isFlat ? Matrix3::Identity() : oblique_view());
  os << fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\" "
      "fill=\"none\" font-family=\"sans-serif\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n"
      "<rect width=\"{0}\" height=\"{1}\" fill=\"#fff\"/>\n",
      page.width, page.height);
  const auto layer = [](const Shape& s) { return s.kind == Kind::kLine ? 0 : s.kind == Kind::kText ? 2 : 1; };
  for (const int wanted : {0, 1}) {
    std::string style, paths;
    const auto flush = [&] {
      if (!paths.empty()) os << "<path d=\"" << paths << "\" " << style << "/>\n";
      paths.clear();
    };
    for (const Shape& shape : _shapes) {
      if (layer(shape) != wanted) continue;
      if (std::string next = page.style(shape); next != style) {
        flush();
        style = std::move(next);
      }
      paths += page.path(shape);
    }
    flush();
  }
  for (const Shape& shape : _shapes)
    if (layer(shape) == 2) os << page.words(shape);
  os << "</svg>\n";
  return os.good();
}

bool SvgDrawing::save(const std::string& path) const {
  std::ofstream out(path);
  return out.good() && write(out) && out.flush().good();
}

}  // namespace g2o
