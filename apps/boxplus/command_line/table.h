// SPDX-License-Identifier: BSD-3-Clause
// A table of text with aligned columns.
#pragma once

#include <string>
#include <vector>

namespace boxplus::app {

class Table {
 public:
  /// If a title begins with '<', its column is aligned to the left, and the '<' is not printed. All other
  /// columns are aligned to the right.
  explicit Table(std::vector<std::string> titles);
  void add(std::vector<std::string> row);
  /// Returns the titles, followed by the rows. Every line begins with two blanks.
  std::string text() const;

 private:
  std::vector<bool> left_;
  std::vector<std::vector<std::string>> rows_;
};

/// Returns the number of terminal columns that UTF-8 text takes. Wide characters are not supported.
std::size_t shown_width(const std::string& text);

}  // namespace boxplus::app
