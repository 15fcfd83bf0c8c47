// SPDX-License-Identifier: BSD-3-Clause
// Reads and writes the blank-separated fields of a line of a text file. Errors name file, line and column.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "boxplus/base/abi.h"
#include "boxplus/io/graph_file.h"

namespace boxplus {

/// The fields of a line after its tag, if all of them are finite numbers.
struct NumericFields {
  std::span<const double> values;
  std::size_t integers = 0;  ///< the number of leading fields that are written as integers
};

/// The place of a field in its line. It is cheap to store; FieldReader::fail() computes the column from it.
class FieldPlace {
 public:
  /// The first field, which is the tag.
  FieldPlace() = default;

 private:
  friend class FieldReader;
  explicit FieldPlace(std::size_t fields_before) : fields_before_(fields_before) {}
  std::size_t fields_before_ = 0;
};

/// Reads a line from left to right. Throws InputError if a field cannot be read; the message names file,
/// line, column, the expected field, and the text that was found. The texts must outlive the reader.
class FieldReader {
 public:
  FieldReader(std::string_view file, std::int64_t line_number, std::string_view line)
      : file_(file), line_(line), line_number_(line_number) {}
  /// For a line whose fields have been converted already. The reader begins after the tag. When a caller
  /// needs more than the converted values, the reader continues with the text.
  FieldReader(std::string_view file, std::int64_t line_number, std::string_view line, NumericFields fields)
      : file_(file),
        line_(line),
        line_number_(line_number),
        passed_(1),
        first_(fields.values.data()),
        next_(first_),
        end_(first_ + fields.values.size()),
        integers_end_(first_ + fields.integers),
        is_converted_(true) {}

  /// Whether the rest of the line is empty or a comment.
  bool at_end();
  /// The next field, with any text. `what` names the field in errors.
  std::string_view token(std::string_view what);
  /// The next field, which must be a finite number.
  double number(std::string_view what) { return next_ != end_ ? *next_++ : number_from_text(what); }
  void numbers(double* out, int count, std::string_view what);
  /// The next `count` fields, if they have been converted already; otherwise returns an empty span and skips
  /// nothing.
  std::span<const double> converted(std::size_t count) {
    if (static_cast<std::size_t>(end_ - next_) < count) return {};
    return {std::exchange(next_, next_ + count), count};
  }
  std::int64_t integer(std::string_view what) {
    return next_ < integers_end_ ? static_cast<std::int64_t>(*next_++) : integer_from_text(what);
  }
  /// If the next field is `text`, moves past it and returns true.
  bool accept(std::string_view text);
  /// Throws InputError unless the rest of the line is empty or a comment.
  void expect_end();

  /// What to do with an indefinite Ω; kRefuse at first.
  void set_policy(ReadOptions::Indefinite policy) { policy_ = policy; }
  ReadOptions::Indefinite policy() const { return policy_; }
  /// Records that an Ω of this line is indefinite, and was replaced or kept.
  void note_indefinite() { has_indefinite_ = true; }
  bool has_indefinite() const { return has_indefinite_; }

  /// Records that the next field is the first entry of Ω.
  void begin_information() { fields_before_information_ = passed(); }
  /// The number of fields before Ω, with the tag; 0 if the reader has not come to an Ω.
  std::size_t fields_before_information() const { return fields_before_information_; }

  /// The number of fields that were read, with the tag.
  std::size_t passed() const { return passed_ + static_cast<std::size_t>(next_ - first_); }
  /// The place of the next field.
  FieldPlace place() const { return FieldPlace(passed()); }
  std::int64_t line_number() const { return line_number_; }
  /// Records something unusual about this line that is not an error.
  void note(std::string text);
  const std::string& noted() const { return note_; }
  /// Throws InputError at a place of this line.
  [[noreturn]] void fail(FieldPlace place, const std::string& message) const;

 private:
  std::size_t position_of(std::size_t field) const;
  void go_on_with_text();
  double number_from_text(std::string_view what);
  std::int64_t integer_from_text(std::string_view what);
  void skip_blanks();
  [[noreturn]] void fail_at(std::size_t position, const std::string& message) const;
  [[noreturn]] void refuse(std::size_t position, std::string_view expected, std::string_view came) const;

  std::string_view file_, line_;
  std::int64_t line_number_;
  std::size_t position_ = 0;  // position in line_, unless the fields were converted
  std::size_t passed_ = 0;    // number of fields that were read from the text
  std::size_t fields_before_information_ = 0;
  const double *first_ = nullptr, *next_ = nullptr, *end_ = nullptr, *integers_end_ = nullptr;
  bool is_converted_ = false, has_indefinite_ = false;
  ReadOptions::Indefinite policy_ = ReadOptions::Indefinite::kRefuse;
  std::string note_;
};

/// Appends fields to the text of a file.
class FieldWriter {
 public:
  explicit FieldWriter(std::string& out) : out_(&out) {}
  void token(std::string_view text);
  /// Appends the shortest text from which the same double is read.
  void number(double value);
  void integer(std::int64_t value);
  void end_line() { out_->push_back('\n'); }

 private:
  void separate();
  std::string* out_;
};

}  // namespace boxplus
