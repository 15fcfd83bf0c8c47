// SPDX-License-Identifier: BSD-3-Clause
// Aligned columns of text.
#pragma once

#include <string>
#include <vector>

namespace boxplus::app {

class Table {
 public:
  /// Titles that begin with '<' are of columns aligned to the left.
  explicit Table(std::vector<std::string> titles);
  void add(std::vector<std::string> row);
  /// Every line begins with two blanks; the titles come first.
  std::string text() const;

 private:
  std::vector<bool> left_;
  std::vector<std::vector<std::string>> rows_;
};

/// What a terminal shows of UTF-8, where no character is wide.
std::size_t shown_width(const std::string& text);

}  // namespace boxplus::app
