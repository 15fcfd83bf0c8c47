// SPDX-License-Identifier: BSD-3-Clause
// Reads the parts of a JSON text (RFC 8259) from left to right.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "boxplus/base/error.h"
#include "io/decimal.h"

namespace boxplus {

/// Something wrong at a place of a JSON text. The reader of the file converts it to an InputError.
struct JsonError : Error {
  /// kSyntax: the text is not JSON. kMeaning: a value is not what the format of graphs has at this place.
  enum class Kind : std::uint8_t { kSyntax, kMeaning };
  JsonError(const char* place, const std::string& message, Kind error_kind)
      : Error(message), at(place), kind(error_kind) {}
  const char* at;
  Kind kind;
};

/// Throws the JsonError "expected …" of Kind::kMeaning.
[[noreturn]] void refuse_meaning(const char* at, const std::string& expected);

/// The end of the JSON number that begins at `at`, or nullptr. A character that is not part of a number must
/// follow the text.
const char* json_number_end(const char* at);

/// All functions skip blanks first, and throw JsonError.
class JsonScanner {
 public:
  /// At least kDecimalRoom bytes after `end` must be 0. An error that is near `end` may only mean that the
  /// text goes on (see kLookahead).
  JsonScanner(const char* begin, const char* end) : at_(begin), end_(end) {}

  /// The largest number of bytes between the place of an error of Kind::kSyntax and the byte that causes it.
  static constexpr std::ptrdiff_t kLookahead = 16;
  static constexpr int kDeepest = 32;

  const char* at() const { return at_; }
  void go_to(const char* at) { at_ = at; }

  /// The next character; 0 at the end of the text.
  char next() {
    while (*at_ == ' ' || *at_ == '\n' || *at_ == '\t' || *at_ == '\r') ++at_;
    return *at_;
  }
  bool accept(char c) {
    if (next() != c) return false;
    ++at_;
    return true;
  }
  void expect(char c, std::string_view what) {
    if (!accept(c)) refuse_syntax(what);
  }

  struct Number {
    const char* text;
    double value;
    bool is_integer;  ///< written as an integer of at most 15 digits, which a double holds exactly
  };
  /// A finite number.
  Number number(std::string_view what);
  /// An integer. A text such as 1e3 is an integer, too.
  std::int64_t integer(std::string_view what);
  bool boolean(std::string_view what);
  /// A string without its escape sequences. May use `memory` to hold it.
  std::string_view string(std::string& memory, std::string_view what);
  /// Any value, with at most kDeepest levels of nesting.
  void skip_value() { skip_value(0); }

  /// Calls item() for each item of an array.
  template <class F>
  void array(std::string_view what, F&& item) {
    expect('[', what);
    if (accept(']')) return;
    do item();
    while (accept(','));
    expect(']', "a comma or ]");
  }
  /// Calls member(name, place) for each member of an object, which must read its value.
  template <class F>
  void object(std::string_view what, F&& member) {
    expect('{', what);
    if (accept('}')) return;
    do {
      next();
      const char* const place = at_;
      std::string memory;
      const std::string_view name = string(memory, "the name of a member (a string)");
      expect(':', "a colon");
      member(name, place);
    } while (accept(','));
    expect('}', "a comma or }");
  }

 private:
  [[noreturn]] void refuse_syntax(std::string_view expected) const;
  [[noreturn]] void refuse(std::string_view expected, std::string_view others) const;
  std::string found() const;
  Number number_of_any_form(std::string_view what);
  std::string_view string_with_escapes(std::string& memory);
  void escape(std::string& out);
  unsigned hexadecimal();
  void skip_value(int depth);

  const char *at_, *end_;
};

}  // namespace boxplus
