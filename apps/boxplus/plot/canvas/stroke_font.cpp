// SPDX-License-Identifier: BSD-3-Clause
#include "plot/canvas/stroke_font.h"

#include <charconv>
#include <cmath>
#include <numbers>
#include <unordered_map>

#include "plot/canvas/letters.h"

namespace boxplus::app {
namespace {

/// A letter on a grid of 20 units per text size. Capital letters are 14 units high, and small letters are 10
/// units high. The command "Mx,y" starts a line; if no other command follows, the line is a dot. "Lx,y"
/// continues with a straight line to (x, y). "Kcx,cy x,y" continues with a quarter of an ellipse to (x, y),
/// whose tangents at both ends pass through the corner (cx, cy).
struct Glyph {
  double advance;
  const char* lines;
};

constexpr double kGrid = 20, kTracking = 0.6;  // kTracking: the space between letters

const std::unordered_map<char32_t, Glyph>& glyphs() {
  static const std::unordered_map<char32_t, Glyph> kGlyphs{
      {' ', {5.5, ""}},
      {'!', {4, "M2,14 L2,4.5 M2,0.3"}},
      {'"', {6, "M1.5,14 L1.5,10.5 M4.5,14 L4.5,10.5"}},
      {'#', {11, "M4,14 L2.6,0 M8.8,14 L7.4,0 M1,9.5 L10.4,9.5 M0.6,4.5 L10,4.5"}},
      {'$',
       {12,
        "M10.5,11.6 K9.5,14 6,14 K1.7,14 1.7,10.6 K1.7,8 6,7.2 K10.9,6.2 10.9,3.6 K10.9,0 6,0 K2,0 1,2.8 "
        "M6,16 L6,-2"}},
      {'%',
       {14,
        "M10.5,14 L3.5,0 M3.6,14 K1,14 1,11 K1,8 3.6,8 K6.2,8 6.2,11 K6.2,14 3.6,14 M10.4,6 K7.8,6 7.8,3 "
        "K7.8,0 10.4,0 K13,0 13,3 K13,6 10.4,6"}},
      {'&',
       {12.5,
        "M11.5,0 L3.4,9.2 K2.4,10.4 2.4,11.5 K2.4,14 5,14 K7.6,14 7.6,11.6 K7.6,9.6 5,8 K1.2,6 1.2,3.6 "
        "K1.2,0 5,0 K9.5,0 10.8,5.8"}},
      {'\'', {3, "M1.5,14 L1.5,10.5"}},
      {'(', {6, "M5,15.5 K2,12 2,6 K2,0 5,-3.5"}},
      {')', {6, "M1,15.5 K4,12 4,6 K4,0 1,-3.5"}},
      {'*', {8, "M4,14 L4,8 M1.4,12.5 L6.6,9.5 M6.6,12.5 L1.4,9.5"}},
      {'+', {11, "M5.5,11 L5.5,2 M1,6.5 L10,6.5"}},
      {',', {4, "M2,0.6 L1.2,-2.6"}},
      {'-', {6.6, "M1,5.2 L5.6,5.2"}},
      {'.', {4, "M2,0.3"}},
      {'/', {6.8, "M6,15 L0.8,-2"}},
      {'0', {11, "M5.5,14 K1.3,14 1.3,7 K1.3,0 5.5,0 K9.7,0 9.7,7 K9.7,14 5.5,14"}},
      {'1', {11, "M2.2,11 L5.9,14 L5.9,0"}},
      {'2', {11, "M1.5,10.6 K1.9,14 5.5,14 K9.3,14 9.3,10.5 K9.3,8.5 6.5,5.6 L1.2,0 L9.7,0"}},
      {'3',
       {11,
        "M1.6,11.4 K2.4,14 5.3,14 K9.1,14 9.1,10.8 K9.1,7.6 5.3,7.6 L4,7.6 M5.3,7.6 K9.7,7.6 9.7,3.8 "
        "K9.7,0 5.4,0 K2.2,0 1.2,3"}},
      {'4', {11, "M7.4,0 L7.4,14 L0.9,4.2 L10,4.2"}},
      {'5', {11, "M8.9,14 L2.6,14 L2,7.6 K3.2,8.8 5.3,8.8 K9.6,8.8 9.6,4.4 K9.6,0 5.2,0 K2.2,0 1.2,2.8"}},
      {'6',
       {11,
        "M8.9,11.8 K8,14 5.8,14 K1.3,14 1.3,6.5 L1.3,4.4 K1.3,0 5.5,0 K9.7,0 9.7,4.4 K9.7,8.7 5.5,8.7 "
        "K1.3,8.7 1.3,4.4"}},
      {'7', {11, "M1.2,14 L9.6,14 L4,0"}},
      {'8',
       {11,
        "M5.5,14 K1.9,14 1.9,10.8 K1.9,7.6 5.5,7.6 K9.1,7.6 9.1,10.8 K9.1,14 5.5,14 M5.5,7.6 K1.3,7.6 "
        "1.3,3.8 K1.3,0 5.5,0 K9.7,0 9.7,3.8 K9.7,7.6 5.5,7.6"}},
      {'9',
       {11,
        "M2.1,2.2 K3,0 5.2,0 K9.7,0 9.7,7.5 L9.7,9.6 K9.7,14 5.5,14 K1.3,14 1.3,9.6 K1.3,5.3 5.5,5.3 "
        "K9.7,5.3 9.7,9.6"}},
      {':', {4, "M2,9 M2,0.3"}},
      {';', {4, "M2,9 M2,0.6 L1.2,-2.6"}},
      {'<', {11, "M9.5,11 L1.5,6.5 L9.5,2"}},
      {'=', {11, "M1,8.5 L10,8.5 M1,4.5 L10,4.5"}},
      {'>', {11, "M1.5,11 L9.5,6.5 L1.5,2"}},
      {'?', {9.4, "M1.2,10.8 K1.6,14 4.8,14 K8.4,14 8.4,10.8 K8.4,8.8 6.4,7.4 K4.8,6.2 4.8,4.2 M4.8,0.3"}},
      {'@',
       {16.6,
        "M13.5,0 K11,-2 8,-2 K1.2,-2 1.2,6 K1.2,14 8.4,14 K15.4,14 15.4,7.4 K15.4,2.6 12.8,2.6 K11,2.6 "
        "11,5 L11,9.4 M11,6 K11,9.4 8.2,9.4 K5.2,9.4 5.2,6 K5.2,2.6 8,2.6 K11,2.6 11,6"}},
      {'A', {13, "M1,0 L6.5,14 L12,0 M2.8,4.6 L10.2,4.6"}},
      {'B',
       {12.5,
        "M6,7.5 L1.5,7.5 M1.5,0 L1.5,14 L6,14 K10,14 10,10.75 K10,7.5 6,7.5 K11,7.5 11,3.75 K11,0 6,0 "
        "L1.5,0"}},
      {'C', {13.5, "M12,11.5 K10.5,14 7,14 K1.2,14 1.2,7 K1.2,0 7,0 K10.5,0 12,2.5"}},
      {'D', {13.5, "M1.5,0 L1.5,14 L5.5,14 K12,14 12,7 K12,0 5.5,0 L1.5,0"}},
      {'E', {11.5, "M10,14 L1.5,14 L1.5,0 L10,0 M1.5,7.3 L9,7.3"}},
      {'F', {11, "M10,14 L1.5,14 L1.5,0 M1.5,7 L8.5,7"}},
      {'G', {14, "M12,11.5 K10.5,14 7,14 K1.2,14 1.2,7 K1.2,0 7,0 K12.5,0 12.5,5 L12.5,6.5 L7.5,6.5"}},
      {'H', {13, "M1.5,0 L1.5,14 M11.5,0 L11.5,14 M1.5,7.3 L11.5,7.3"}},
      {'I', {4, "M2,0 L2,14"}},
      {'J', {10, "M8,14 L8,4 K8,0 4.5,0 K1,0 1,4"}},
      {'K', {12, "M1.5,0 L1.5,14 M10.5,14 L1.5,5.5 M5,8.8 L11,0"}},
      {'L', {10, "M1.5,14 L1.5,0 L9,0"}},
      {'M', {15, "M1.5,0 L1.5,14 L7.5,3 L13.5,14 L13.5,0"}},
      {'N', {13, "M1.5,0 L1.5,14 L11.5,0 L11.5,14"}},
      {'O', {14.4, "M7.2,14 K1.2,14 1.2,7 K1.2,0 7.2,0 K13.2,0 13.2,7 K13.2,14 7.2,14"}},
      {'P', {12, "M1.5,0 L1.5,14 L6.5,14 K11,14 11,10 K11,6 6.5,6 L1.5,6"}},
      {'Q', {14.4, "M7.2,14 K1.2,14 1.2,7 K1.2,0 7.2,0 K13.2,0 13.2,7 K13.2,14 7.2,14 M9,3.5 L13,-1"}},
      {'R', {12.5, "M1.5,0 L1.5,14 L6.5,14 K11,14 11,10 K11,6 6.5,6 L1.5,6 M6.5,6 L11,0"}},
      {'S',
       {12,
        "M10.5,11.6 K9.5,14 6,14 K1.7,14 1.7,10.6 K1.7,8 6,7.2 K10.9,6.2 10.9,3.6 K10.9,0 6,0 K2,0 1,2.8"}},
      {'T', {12, "M0.5,14 L11.5,14 M6,14 L6,0"}},
      {'U', {13, "M1.5,14 L1.5,5 K1.5,0 6.5,0 K11.5,0 11.5,5 L11.5,14"}},
      {'V', {12.6, "M0.8,14 L6.3,0 L11.8,14"}},
      {'W', {17.6, "M0.8,14 L4.8,0 L8.8,13 L12.8,0 L16.8,14"}},
      {'X', {12, "M1,14 L11,0 M11,14 L1,0"}},
      {'Y', {12, "M0.8,14 L6,7 L11.2,14 M6,7 L6,0"}},
      {'Z', {11.5, "M1,14 L10.5,14 L1,0 L10.5,0"}},
      {'[', {6, "M5,15.5 L2,15.5 L2,-3.5 L5,-3.5"}},
      {'\\', {6.8, "M0.8,15 L6,-2"}},
      {']', {6, "M1,15.5 L4,15.5 L4,-3.5 L1,-3.5"}},
      {'^', {11, "M1.5,8.5 L5.5,14 L9.5,8.5"}},
      {'_', {10, "M0,-2.5 L10,-2.5"}},
      {'`', {5, "M1.5,14.5 L3.5,12"}},
      {'a', {10.5, "M8.8,10 L8.8,0 M8.8,5 K8.8,10 5,10 K1.2,10 1.2,5 K1.2,0 5,0 K8.8,0 8.8,5"}},
      {'b', {10.3, "M1.5,14.5 L1.5,0 M1.5,5 K1.5,10 5.3,10 K9.1,10 9.1,5 K9.1,0 5.3,0 K1.5,0 1.5,5"}},
      {'c', {9.5, "M8.6,8 K7.6,10 5,10 K1.2,10 1.2,5 K1.2,0 5,0 K7.6,0 8.6,2"}},
      {'d', {10.3, "M8.8,14.5 L8.8,0 M8.8,5 K8.8,10 5,10 K1.2,10 1.2,5 K1.2,0 5,0 K8.8,0 8.8,5"}},
      {'e', {10, "M1.3,5.2 L8.9,5.2 K8.9,10 5.1,10 K1.2,10 1.2,5 K1.2,0 5.1,0 K7.6,0 8.6,1.9"}},
      {'f', {6.2, "M6.2,14.4 K3,15 3,11.5 L3,0 M0.8,9.6 L5.8,9.6"}},
      {'g',
       {10.3,
        "M8.8,10 L8.8,-0.5 K8.8,-4.2 5,-4.2 K2.4,-4.2 1.6,-2.6 M8.8,5 K8.8,10 5,10 K1.2,10 1.2,5 K1.2,0 "
        "5,0 K8.8,0 8.8,5"}},
      {'h', {9.9, "M1.5,14.5 L1.5,0 M1.5,6 K1.5,10 5,10 K8.4,10 8.4,6.4 L8.4,0"}},
      {'i', {3.6, "M1.8,10 L1.8,0 M1.8,13.6"}},
      {'j', {4, "M2.4,10 L2.4,-1.5 K2.4,-4.2 -0.3,-4.1 M2.4,13.6"}},
      {'k', {9, "M1.5,14.5 L1.5,0 M8,10 L1.5,4 M4,6.3 L8.6,0"}},
      {'l', {3.6, "M1.8,14.5 L1.8,0"}},
      {'m',
       {15,
        "M1.5,10 L1.5,0 M1.5,6 K1.5,10 4.6,10 K7.5,10 7.5,6.6 L7.5,0 M7.5,6 K7.5,10 10.6,10 K13.5,10 "
        "13.5,6.6 L13.5,0"}},
      {'n', {9.9, "M1.5,10 L1.5,0 M1.5,6 K1.5,10 5,10 K8.4,10 8.4,6.4 L8.4,0"}},
      {'o', {10.2, "M5.1,10 K1.2,10 1.2,5 K1.2,0 5.1,0 K9,0 9,5 K9,10 5.1,10"}},
      {'p', {10.3, "M1.5,10 L1.5,-4.2 M1.5,5 K1.5,10 5.3,10 K9.1,10 9.1,5 K9.1,0 5.3,0 K1.5,0 1.5,5"}},
      {'q', {10.3, "M8.8,10 L8.8,-4.2 M8.8,5 K8.8,10 5,10 K1.2,10 1.2,5 K1.2,0 5,0 K8.8,0 8.8,5"}},
      {'r', {6.2, "M1.5,10 L1.5,0 M1.5,5.5 K1.5,10 5.6,9.9"}},
      {'s',
       {9, "M7.6,8.3 K6.8,10 4.5,10 K1.5,10 1.5,7.6 K1.5,5.7 4.5,5.1 K8,4.4 8,2.6 K8,0 4.6,0 K2,0 1,1.9"}},
      {'t', {6.4, "M3,13 L3,3 K3,0 6,0.2 M0.8,9.6 L5.8,9.6"}},
      {'u', {9.9, "M1.5,10 L1.5,3.6 K1.5,0 4.9,0 K8.4,0 8.4,4 M8.4,10 L8.4,0"}},
      {'v', {9.2, "M0.8,10 L4.6,0 L8.4,10"}},
      {'w', {13.6, "M0.8,10 L3.8,0 L6.8,9 L9.8,0 L12.8,10"}},
      {'x', {9, "M1,10 L8,0 M8,10 L1,0"}},
      {'y', {9.3, "M0.8,10 L4.8,0 M8.6,10 L4.3,-1.4 K3.2,-4.2 0.9,-4"}},
      {'z', {8.8, "M1,10 L7.8,10 L1,0 L7.8,0"}},
      {'{', {7, "M6,15.5 K3.5,15.5 3.5,13 L3.5,8.5 K3.5,6 1.2,6 K3.5,6 3.5,3.5 L3.5,-1 K3.5,-3.5 6,-3.5"}},
      {'|', {4, "M2,15.5 L2,-3.5"}},
      {'}', {7, "M1,15.5 K3.5,15.5 3.5,13 L3.5,8.5 K3.5,6 5.8,6 K3.5,6 3.5,3.5 L3.5,-1 K3.5,-3.5 1,-3.5"}},
      {'~', {11, "M1,5.5 K1.6,8 3.6,8 K4.8,8 5.5,6.5 K6.2,5 7.4,5 K9.4,5 10,7.5"}},
      {0xB7, {4, "M2,6"}},                                               // middle dot
      {0xB0, {6, "M3,14 K1,14 1,12 K1,10 3,10 K5,10 5,12 K5,14 3,14"}},  // degrees
      {0xD7, {11, "M2,10 L9,3 M9,10 L2,3"}},                             // times
      {0x2013, {10, "M0.5,5.2 L9.5,5.2"}},                               // en dash
      {0x2014, {16, "M0.5,5.2 L15.5,5.2"}},                              // em dash
      {0x2026, {14, "M2,0.3 M7,0.3 M12,0.3"}},                           // ellipsis
      {0x2212, {11, "M1,6.5 L10,6.5"}},                                  // minus
  };
  return kGlyphs;
}

const Glyph& glyph_of(char32_t code) {
  static constexpr Glyph kBox{10, "M1.5,0 L1.5,12 L8.5,12 L8.5,0 L1.5,0"};
  const auto found = glyphs().find(code);
  return found != glyphs().end() ? found->second : kBox;
}

/// Draws one glyph, translated and scaled.
class Pen {
 public:
  Pen(Path& path, Point origin, double scale) : path_(path), origin_(origin), scale_(scale) {}

  void draw(const char* lines) {
    while (*lines != '\0') {
      const char command = *lines++;
      if (command == 'K') {
        const Point corner = point(lines);
        arc(corner, point(lines));
      } else {
        const Point to = point(lines);
        command == 'M' ? path_.move_to(placed(to)) : path_.line_to(placed(to));
        at_ = to;
      }
    }
  }

 private:
  Point placed(Point p) const { return {origin_.x + scale_ * p.x, origin_.y - scale_ * p.y}; }

  /// Removes "x,y " from the front of the text, and returns the point.
  static Point point(const char*& lines) {
    Point result;
    for (double* value : {&result.x, &result.y}) {
      const char* end = lines;
      while (*end != ',' && *end != ' ' && *end != '\0') ++end;
      std::from_chars(lines, end, *value);
      lines = *end == '\0' ? end : end + 1;
    }
    return result;
  }

  void arc(Point corner, Point to) {
    constexpr int kPieces = 8;
    for (int i = 1; i <= kPieces; ++i) {
      const double angle = std::numbers::pi / 2 * i / kPieces, s = 1 - std::sin(angle),
                   c = 1 - std::cos(angle);
      path_.line_to(placed({corner.x + (at_.x - corner.x) * s + (to.x - corner.x) * c,
                            corner.y + (at_.y - corner.y) * s + (to.y - corner.y) * c}));
    }
    at_ = to;
  }

  Path& path_;
  Point origin_, at_;
  double scale_;
};

}  // namespace

StrokedText stroked_text(Point point, const TextStyle& style, std::string_view words) {
  const std::vector<Letter> letters = letters_of(words);
  const double unit = style.size / kGrid;
  const auto scale = [unit](const Letter& letter) { return unit * (letter.is_raised ? kRaisedSize : 1); };
  double width = 0;
  for (const Letter& letter : letters) width += scale(letter) * (glyph_of(letter.code).advance + kTracking);
  const double part = style.anchor == Anchor::kStart ? 0 : style.anchor == Anchor::kMiddle ? 0.5 : 1;
  constexpr double kRegular = 1.5, kBold = 2.4;
  StrokedText result{{}, unit * (style.is_bold ? kBold : kRegular)};
  double x = point.x - part * width;
  for (const Letter& letter : letters) {
    const Glyph& glyph = glyph_of(letter.code);
    const double y = point.y - (letter.is_raised ? kRaisedBy * style.size : 0);
    Pen(result.path, {x, y}, scale(letter)).draw(glyph.lines);
    x += scale(letter) * (glyph.advance + kTracking);
  }
  return result;
}

}  // namespace boxplus::app
