// SPDX-License-Identifier: BSD-3-Clause
// Aligned columns of text.
#pragma once

#include <string>
#include <vector>

namespace boxplus::app {

class Table {
 public:
  /// A title that begins with '<' aligns its column to the left.
  explicit Table(std::vector<std::string> titles);
  void add(std::vector<std::string> row);
  /// The titles, then the rows. Every line begins with two blanks.
  std::string text() const;

 private:
  std::vector<bool> left_;
  std::vector<std::vector<std::string>> rows_;
};

/// The number of columns that a terminal needs for UTF-8 text without wide characters.
std::size_t shown_width(const std::string& text);

}  // namespace boxplus::app
