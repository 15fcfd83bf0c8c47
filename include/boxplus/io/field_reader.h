// SPDX-License-Identifier: BSD-3-Clause
// The blank-separated fields of one line of a text file, with exact places for complaints.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "boxplus/base/abi.h"

namespace boxplus {

/// The fields of a line after its word, where all of them are finite numbers.
struct NumericFields {
  std::span<const double> values;
  std::size_t integers = 0;  ///< the first so many are written as integers
};

/// Reads a line from left to right. What cannot be read throws InputError with file, line, column, what was
/// expected and what came. The texts must outlive the reader.
class FieldReader {
 public:
  /// What a reader over NumericFields throws where it is asked for something else, or for more: the line is
  /// then read from its text, which finds out what is wrong with it, if anything.
  struct NotNumeric {};

  FieldReader(std::string_view file, std::int64_t line_number, std::string_view line)
      : file_(file), line_(line), line_number_(line_number) {}
  /// The same line, its word passed, with its fields converted already.
  FieldReader(std::string_view file, std::int64_t line_number, std::string_view line, NumericFields fields)
      : file_(file),
        line_(line),
        line_number_(line_number),
        next_(fields.values.data()),
        end_(next_ + fields.values.size()),
        integers_end_(next_ + fields.integers),
        is_numeric_(true) {}

  bool at_end();
  /// The next field, any text. `what` names it in complaints.
  std::string_view word(std::string_view what);
  /// The next field, a finite number.
  double number(std::string_view what) { return next_ != end_ ? *next_++ : number_from_text(what); }
  void numbers(double* out, int count, std::string_view what);
  /// The next `count` fields where they have been converted already; none otherwise.
  std::span<const double> converted(std::size_t count) {
    if (static_cast<std::size_t>(end_ - next_) < count) return {};
    return {std::exchange(next_, next_ + count), count};
  }
  std::int64_t integer(std::string_view what) {
    return next_ < integers_end_ ? static_cast<std::int64_t>(*next_++) : integer_from_text(what);
  }
  /// Moves past the next field where it is `text`.
  bool accept(std::string_view text);
  /// Throws unless nothing, or a comment, is left.
  void expect_end();

  /// Column of the next field, from 1; 0 where the line is not read from its text.
  std::int64_t column();
  std::int64_t line_number() const { return line_number_; }
  /// Remembers what is odd about this line, but no error.
  void note(std::string text);
  const std::string& noted() const { return note_; }
  /// Throws InputError at a column of this line.
  [[noreturn]] void fail(std::int64_t column, const std::string& message) const;

 private:
  double number_from_text(std::string_view what);
  std::int64_t integer_from_text(std::string_view what);
  void skip_blanks();
  void require_text() const;
  [[noreturn]] void fail_at(std::size_t begin, std::string_view expected, std::string_view came) const;

  std::string_view file_, line_;
  std::int64_t line_number_;
  std::size_t position_ = 0;
  const double *next_ = nullptr, *end_ = nullptr, *integers_end_ = nullptr;  // the fields, where numeric
  bool is_numeric_ = false;
  std::string note_;
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
