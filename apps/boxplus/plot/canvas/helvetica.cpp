// SPDX-License-Identifier: BSD-3-Clause
#include "plot/canvas/helvetica.h"

#include <array>
#include <cstdint>

namespace boxplus::app {
namespace {

/// The widths of the ASCII characters from the blank to the tilde.
using Widths = std::array<std::uint16_t, 95>;

constexpr Widths kRegular{278,  278, 355, 556, 556, 889, 667, 191, 333, 333, 389, 584, 278, 333, 278, 278,
                          556,  556, 556, 556, 556, 556, 556, 556, 556, 556, 278, 278, 584, 584, 584, 556,
                          1015, 667, 667, 722, 722, 667, 611, 778, 722, 278, 500, 667, 556, 833, 722, 778,
                          667,  778, 722, 667, 611, 722, 667, 944, 667, 667, 611, 278, 278, 278, 469, 556,
                          333,  556, 556, 500, 556, 556, 278, 556, 556, 222, 222, 500, 222, 833, 556, 556,
                          556,  556, 333, 500, 278, 556, 500, 722, 500, 500, 500, 334, 260, 334, 584};
constexpr Widths kBold{278, 333, 474, 556, 556, 889, 722, 238, 333, 333, 389, 584, 278, 333, 278, 278,
                       556, 556, 556, 556, 556, 556, 556, 556, 556, 556, 333, 333, 584, 584, 584, 611,
                       975, 722, 722, 722, 722, 667, 611, 778, 722, 278, 556, 722, 611, 833, 722, 778,
                       667, 778, 722, 667, 611, 722, 667, 944, 667, 667, 611, 333, 278, 333, 584, 556,
                       333, 556, 611, 556, 611, 556, 333, 611, 611, 278, 278, 556, 278, 889, 611, 611,
                       611, 611, 389, 556, 333, 611, 556, 778, 556, 556, 500, 389, 280, 389, 584};

}  // namespace

int helvetica_width(unsigned char letter, bool is_bold) {
  constexpr unsigned char kFirst = ' ', kMiddleDot = 0xB7, kEllipsis = 0x85;
  const Widths& widths = is_bold ? kBold : kRegular;
  if (letter == kMiddleDot) return widths['.' - kFirst];
  if (letter == kEllipsis) return 1000;
  const auto index = static_cast<std::size_t>(letter - kFirst);
  return letter >= kFirst && index < widths.size() ? widths[index] : widths['n' - kFirst];
}

}  // namespace boxplus::app
