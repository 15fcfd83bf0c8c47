// SPDX-License-Identifier: BSD-3-Clause
#include "plot/svg_writer.h"

namespace boxplus::app {
namespace {

std::string escaped_xml(std::string_view text) {
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

const char* word(Anchor anchor) {
  return anchor == Anchor::kStart ? "start" : anchor == Anchor::kMiddle ? "middle" : "end";
}

}  // namespace

void SvgWriter::text(double x, double y, const TextStyle& style, std::string_view words) {
  add("<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"{}\" fill=\"{}\" text-anchor=\"{}\"{}>{}</text>\n", x, y,
      style.size, style.colour, word(style.anchor), style.is_bold ? " font-weight=\"600\"" : "",
      escaped_xml(words));
}

}  // namespace boxplus::app
