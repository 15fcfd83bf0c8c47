// SPDX-License-Identifier: BSD-3-Clause
// A block of text that consists of numbers only, split into them. Splitting needs no graph, so several
// threads can do it.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "boxplus/io/text_source.h"

namespace boxplus {

class NumberBlock {
 public:
  /// Where a field is, and its text. The line counts from 0 within the block, the column from 1.
  struct Field {
    std::int64_t line = 0, column = 1;
    std::string_view text;
  };

  void read(const TextSource& source, std::size_t k);

  /// The fields, up to the first one that is not a finite number.
  const std::vector<double>& values() const { return values_; }
  /// Whether a field is written as an integer.
  bool is_integer(std::size_t field) const { return is_integer_[field] != 0; }
  /// Whether a field follows values() that is not a finite number.
  bool ends_with_another_field() const { return ends_with_another_field_; }
  std::int64_t line_count() const { return line_count_; }
  /// Looks up a field in the text. O(size of the block).
  Field field(std::size_t index) const;

 private:
  std::string memory_;
  std::string_view text_;
  std::vector<double> values_;
  std::vector<char> is_integer_;
  std::int64_t line_count_ = 0;
  bool ends_with_another_field_ = false;
};

}  // namespace boxplus
