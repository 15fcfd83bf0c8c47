// SPDX-License-Identifier: BSD-3-Clause
// Writes PDF 1.4 (Adobe, PDF Reference, third edition): one page, with text in Helvetica, a font that every
// PDF reader has.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

#include "plot/canvas/canvas.h"
#include "plot/canvas/deflate.h"
#include "plot/canvas/helvetica.h"
#include "plot/canvas/letters.h"

namespace boxplus::app {
namespace {

/// Returns the code of a letter in WinAnsiEncoding, or the code of a question mark if there is none.
unsigned char win_ansi(char32_t code) {
  constexpr unsigned char kEnDash = 0x96, kEmDash = 0x97, kEllipsis = 0x85;
  if ((code >= 0x20 && code < 0x7F) || (code >= 0xA0 && code <= 0xFF))
    return static_cast<unsigned char>(code);
  if (code == 0x2212 || code == 0x2013)
    return kEnDash;  // also for the minus sign, which WinAnsiEncoding lacks
  if (code == 0x2014) return kEmDash;
  return code == 0x2026 ? kEllipsis : '?';
}

/// Returns a PDF string literal. Special characters and characters outside of ASCII become octal codes.
std::string literal(std::string_view bytes) {
  std::string result = "(";
  for (const char byte : bytes) {
    const auto value = static_cast<unsigned char>(byte);
    if (value < 0x20 || value >= 0x7F || byte == '(' || byte == ')' || byte == '\\') {
      result += fmt::format("\\{:03o}", value);
    } else {
      result += byte;
    }
  }
  return result + ")";
}

std::string win_ansi(std::string_view text) {
  std::string result;
  for (const Letter& letter : letters_of(text)) result.push_back(static_cast<char>(win_ansi(letter.code)));
  return result;
}

std::string rgb(Rgb color) {
  constexpr double kMost = 255;
  return fmt::format("{:.3f} {:.3f} {:.3f}", color.red / kMost, color.green / kMost, color.blue / kMost);
}

class PdfCanvas final : public Canvas {
 public:
  PdfCanvas(double width, double height, std::string_view title)
      : width_(width), height_(height), title_(title) {
    add("1 0 0 -1 0 {:.2f} cm 1 J 1 j\n", height);  // y points down; ends and joins of lines are round
  }

  void stroke(const Path& path, const Stroke& stroke) override {
    if (path.empty()) return;
    const int percent = std::clamp(static_cast<int>(std::lround(100 * stroke.opacity)), 0, 100);
    opacities_.insert(percent);
    add("/O{} gs {} RG {:.3g} w\n", percent, rgb(stroke.color), stroke.width);
    path.for_each_line([this](std::span<const Point> points) {
      add("{:.2f} {:.2f} m", points[0].x, points[0].y);
      if (points.size() == 1) add(" {:.2f} {:.2f} l", points[0].x, points[0].y);
      for (const Point& point : points.subspan(1)) add(" {:.2f} {:.2f} l", point.x, point.y);
      add("\n");
    });
    add("S\n");
  }

  void fill(const Box& box, double radius, Rgb color) override {
    constexpr double kArc = 0.5523;  // approximates a quarter circle by a Bézier curve
    const double l = box.left, r = box.right(), t = box.top, b = box.bottom(), a = radius,
                 k = (1 - kArc) * radius;
    add("{} rg {:.2f} {:.2f} m {:.2f} {:.2f} l\n", rgb(color), l + a, t, r - a, t);
    add("{:.2f} {:.2f} {:.2f} {:.2f} {:.2f} {:.2f} c {:.2f} {:.2f} l\n", r - k, t, r, t + k, r, t + a, r,
        b - a);
    add("{:.2f} {:.2f} {:.2f} {:.2f} {:.2f} {:.2f} c {:.2f} {:.2f} l\n", r, b - k, r - k, b, r - a, b, l + a,
        b);
    add("{:.2f} {:.2f} {:.2f} {:.2f} {:.2f} {:.2f} c {:.2f} {:.2f} l\n", l + k, b, l, b - k, l, b - a, l,
        t + a);
    add("{:.2f} {:.2f} {:.2f} {:.2f} {:.2f} {:.2f} c f\n", l, t + k, l + k, t, l + a, t);
  }

  void text(Point point, const TextStyle& style, std::string_view words) override {
    const std::vector<Letter> letters = letters_of(words);
    double width = 0;
    for (const Letter& letter : letters) width += width_of(letter, style);
    const double part = style.anchor == Anchor::kStart ? 0 : style.anchor == Anchor::kMiddle ? 0.5 : 1;
    add("BT {} rg 1 0 0 -1 {:.2f} {:.2f} Tm\n", rgb(style.color), point.x - part * width, point.y);
    for (std::size_t begin = 0, end = 0; begin < letters.size(); begin = end) {
      const bool is_raised = letters[begin].is_raised;
      std::string run;
      for (; end < letters.size() && letters[end].is_raised == is_raised; ++end)
        run.push_back(static_cast<char>(win_ansi(letters[end].code)));
      add("/F{} {:.3g} Tf {:.2f} Ts {} Tj\n", style.is_bold ? 2 : 1,
          style.size * (is_raised ? kRaisedSize : 1), is_raised ? kRaisedBy * style.size : 0, literal(run));
    }
    add("ET\n");
  }

  std::string finish() override {
    std::string states;
    for (const int percent : opacities_)
      states += fmt::format("/O{} <</CA {:.2f}>> ", percent, percent / 100.0);
    object("<</Type /Catalog /Pages 2 0 R>>");
    object("<</Type /Pages /Kids [3 0 R] /Count 1>>");
    object(
        fmt::format("<</Type /Page /Parent 2 0 R /MediaBox [0 0 {:.2f} {:.2f}] /Contents 6 0 R /Resources "
                    "<</Font <</F1 4 0 R /F2 5 0 R>> /ExtGState <<{}>>>>>>",
                    width_, height_, states));
    object(font("Helvetica"));
    object(font("Helvetica-Bold"));
    const std::string packed = zlib_compressed(content_);
    object(fmt::format("<</Length {} /Filter /FlateDecode>>\nstream\n", packed.size()) + packed +
           "\nendstream");
    object(fmt::format("<</Producer (boxplus) /Title {}>>", literal(win_ansi(title_))));
    return with_index();
  }

 private:
  template <class... Arguments>
  void add(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    fmt::format_to(std::back_inserter(content_), format, std::forward<Arguments>(arguments)...);
  }

  static double width_of(const Letter& letter, const TextStyle& style) {
    return style.size * (letter.is_raised ? kRaisedSize : 1) *
           helvetica_width(win_ansi(letter.code), style.is_bold) / 1000;
  }

  static std::string font(const char* name) {
    return fmt::format("<</Type /Font /Subtype /Type1 /BaseFont /{} /Encoding /WinAnsiEncoding>>", name);
  }

  void object(const std::string& body) {
    offsets_.push_back(file_.size());
    file_ += fmt::format("{} 0 obj\n", offsets_.size()) + body + "\nendobj\n";
  }

  /// Appends the table with the offset of each object, which PDF readers read first.
  std::string with_index() {
    const std::size_t begin = file_.size(), count = offsets_.size() + 1;
    file_ += fmt::format("xref\n0 {}\n0000000000 65535 f \n", count);
    for (const std::size_t offset : offsets_) file_ += fmt::format("{:010} 00000 n \n", offset);
    file_ += fmt::format("trailer\n<</Size {} /Root 1 0 R /Info {} 0 R>>\nstartxref\n{}\n%%EOF\n", count,
                         count - 1, begin);
    return std::move(file_);
  }

  double width_, height_;
  std::string title_, content_;
  std::set<int> opacities_;
  std::string file_ = "%PDF-1.4\n%\xE2\xE3\xCF\xD3\n";  // the second line marks the file as binary
  std::vector<std::size_t> offsets_;
};

}  // namespace

std::unique_ptr<Canvas> make_pdf_canvas(double width, double height, std::string_view title) {
  return std::make_unique<PdfCanvas>(width, height, title);
}

}  // namespace boxplus::app
