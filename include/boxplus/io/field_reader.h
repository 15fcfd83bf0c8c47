// SPDX-License-Identifier: BSD-3-Clause
// The blank-separated fields of one line of a text file, with exact places for complaints.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "boxplus/base/abi.h"

namespace boxplus {

/// Reads a line from left to right. What cannot be read throws InputError with file, line, column, what was
/// expected and what came. The texts must outlive the reader.
class FieldReader {
 public:
  FieldReader(std::string_view file, std::int64_t line_number, std::string_view line)
      : file_(file), line_(line), line_number_(line_number) {}

  bool at_end();
  /// The next field, any text. `what` names it in complaints.
  std::string_view word(std::string_view what);
  /// The next field, a finite number.
  double number(std::string_view what);
  void numbers(double* out, int count, std::string_view what);
  std::int64_t integer(std::string_view what);
  /// Moves past the next field where it is `text`.
  bool accept(std::string_view text);
  /// Throws unless nothing, or a comment, is left.
  void expect_end();

  /// Column of the next field, from 1.
  std::int64_t column();
  std::int64_t line_number() const { return line_number_; }
  /// Throws InputError at a column of this line.
  [[noreturn]] void fail(std::int64_t column, const std::string& message) const;

 private:
  void skip_blanks();
  [[noreturn]] void fail_at(std::size_t begin, std::string_view expected, std::string_view came) const;

  std::string_view file_, line_;
  std::int64_t line_number_;
  std::size_t position_ = 0;
};

/// The text of a file under construction.
class FieldWriter {
 public:
  explicit FieldWriter(std::string& out) : out_(&out) {}
  void word(std::string_view text);
  /// The shortest text that reads back to the same double.
  void number(double value);
  void integer(std::int64_t value);
  void end_line() { out_->push_back('\n'); }

 private:
  void separate();
  std::string* out_;
};

}  // namespace boxplus
