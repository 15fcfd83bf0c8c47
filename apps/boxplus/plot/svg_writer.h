// SPDX-License-Identifier: BSD-3-Clause
// The elements of SVG that our pictures use.
#pragma once

#include <fmt/format.h>

#include <iterator>
#include <string>
#include <string_view>

namespace boxplus::app {

inline constexpr const char* kInk = "#1f2937";
inline constexpr const char* kFaintInk = "#6b7280";

enum class Anchor { kStart, kMiddle, kEnd };

struct TextStyle {
  double size = 15;
  const char* colour = kFaintInk;
  Anchor anchor = Anchor::kStart;
  bool is_bold = false;
};

class SvgWriter {
 public:
  template <class... Arguments>
  void add(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    fmt::format_to(std::back_inserter(text_), format, std::forward<Arguments>(arguments)...);
  }

  void text(double x, double y, const TextStyle& style, std::string_view words);
  /// A straight line in the colour.
  void line(double x, double y, double dx, double dy, double width, std::string_view colour) {
    add("<path d=\"M{:.1f} {:.1f}l{:.1f} {:.1f}\" stroke=\"{}\" stroke-width=\"{}\"/>\n", x, y, dx, dy,
        colour, width);
  }

  std::string take() { return std::move(text_); }

 private:
  std::string text_;
};

}  // namespace boxplus::app
