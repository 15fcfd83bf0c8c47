// SPDX-License-Identifier: BSD-3-Clause
#include "io/json/json_scanner.h"

#include <fast_float/fast_float.h>
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>
#include <utility>

#include "io/characters.h"
#include "io/json/utf8.h"

namespace boxplus {
namespace {

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

const char* skip_digits(const char* at) {
  while (is_digit(*at)) ++at;
  return at;
}

/// Whether a number, true, false or null may end before c.
bool ends_word(char c) {
  return c == ',' || c == ']' || c == '}' || c == ' ' || c == '\n' || c == '\t' || c == '\r' || c == '\0';
}

}  // namespace

void refuse_meaning(const char* at, const std::string& expected) {
  throw JsonError(at, "expected " + expected, JsonError::Kind::kMeaning);
}

const char* json_number_end(const char* at) {
  at += *at == '-';
  if (!is_digit(*at)) return nullptr;
  at = *at == '0' ? at + 1 : skip_digits(at);
  if (*at == '.') {
    if (!is_digit(at[1])) return nullptr;
    at = skip_digits(at + 1);
  }
  if (*at == 'e' || *at == 'E') {
    at += at[1] == '+' || at[1] == '-' ? 2 : 1;
    if (!is_digit(*at)) return nullptr;
    at = skip_digits(at);
  }
  return at;
}

/// The text at this place, for messages.
std::string JsonScanner::found() const {
  if (at_ == end_) return "the end of the text";
  const char* stop = at_ + 1;
  while (stop != end_ && !ends_word(*stop)) ++stop;
  return in_quotes({at_, static_cast<std::size_t>(stop - at_)});
}

void JsonScanner::refuse_syntax(std::string_view expected) const {
  throw JsonError(at_, fmt::format("expected {}, got {}", expected, found()), JsonError::Kind::kSyntax);
}

/// `others`: the characters with which a value of another type begins.
void JsonScanner::refuse(std::string_view expected, std::string_view others) const {
  if (others.find(*at_) == std::string_view::npos) refuse_syntax(expected);
  refuse_meaning(at_, fmt::format("{}, got {}", expected, found()));
}

JsonScanner::Number JsonScanner::number(std::string_view what) {
  next();
  const Decimal number = read_decimal(at_);
  if (!number.end || !ends_word(*number.end)) return number_of_any_form(what);
  const char* const first = at_ + (*at_ == '-');
  if (*first == '0' && is_digit(first[1])) return number_of_any_form(what);
  return {std::exchange(at_, number.end), number.value, number.is_integer};
}

JsonScanner::Number JsonScanner::number_of_any_form(std::string_view what) {
  constexpr std::ptrdiff_t kMostDigits = 15;
  const char* const stop = json_number_end(at_);
  if (!stop || !ends_word(*stop)) refuse(what, "\"[{tfn");
  Number number{at_, 0, false};
  const auto [stopped, error] = fast_float::from_chars(at_, stop, number.value);
  if (error != std::errc() || stopped != stop || !std::isfinite(number.value))
    refuse_meaning(at_, fmt::format("{} (a finite number), got {}", what, found()));
  number.is_integer = stop - at_ <= kMostDigits && std::all_of(at_ + (*at_ == '-'), stop, is_digit);
  at_ = stop;
  return number;
}

std::int64_t JsonScanner::integer(std::string_view what) {
  constexpr double kMost = 9007199254740992.0;  // 2⁵³; doubles contain all integers up to it
  const Number read = number(what);
  std::int64_t value = 0;
  if (const auto [stopped, error] = std::from_chars(read.text, at_, value);
      error == std::errc() && stopped == at_)
    return value;
  if (std::abs(read.value) <= kMost && read.value == std::floor(read.value))
    return static_cast<std::int64_t>(read.value);
  at_ = read.text;
  refuse_meaning(at_, fmt::format("{} (an integer), got {}", what, found()));
}

bool JsonScanner::boolean(std::string_view what) {
  const bool is_true = next() == 't';
  const std::string_view word = is_true ? "true" : "false";
  if (static_cast<std::size_t>(end_ - at_) >= word.size() && std::string_view(at_, word.size()) == word &&
      ends_word(at_[word.size()])) {
    at_ += word.size();
    return is_true;
  }
  refuse(fmt::format("{} (true or false)", what), "\"[{n-0123456789");
}

std::string_view JsonScanner::string(std::string& memory, std::string_view what) {
  if (next() != '"') refuse(what, "[{tfn-0123456789");
  const char* const begin = ++at_;
  const auto is_plain = [](unsigned char c) { return c >= 0x20 && c < 0x80 && c != '"' && c != '\\'; };
  while (is_plain(static_cast<unsigned char>(*at_))) ++at_;
  const std::string_view plain(begin, static_cast<std::size_t>(at_ - begin));
  if (*at_ == '"') {
    ++at_;
    return plain;
  }
  memory = plain;
  return string_with_escapes(memory);
}

std::string_view JsonScanner::string_with_escapes(std::string& memory) {
  for (;;) {
    if (at_ == end_) refuse_syntax("the end of a string (\")");
    const char c = *at_;
    if (c == '"') break;
    if (c == '\\') {
      escape(memory);
    } else if (static_cast<unsigned char>(c) < 0x20) {
      refuse_syntax("a character of a string (control characters as \\u00XX)");
    } else {
      const std::string_view rest(at_, static_cast<std::size_t>(end_ - at_));
      const std::size_t length = utf8_length(rest, 0);
      if (length == 0) refuse_syntax("a character in UTF-8");
      memory += rest.substr(0, length);
      at_ += length;
    }
  }
  ++at_;
  return memory;
}

void JsonScanner::escape(std::string& out) {
  constexpr std::string_view kNames = "\"\\/bfnrt", kMeanings = "\"\\/\b\f\n\r\t";
  const char name = at_[1];
  if (const std::size_t i = kNames.find(name); name != '\0' && i != std::string_view::npos) {
    out += kMeanings[i];
    at_ += 2;
    return;
  }
  const char* const begin = at_;
  const auto refuse = [&] {
    at_ = begin;
    refuse_syntax("an escape sequence (\\\" \\\\ \\/ \\b \\f \\n \\r \\t or \\uXXXX of a character)");
  };
  constexpr unsigned kInvalid = ~0u;
  unsigned code = name == 'u' ? hexadecimal() : kInvalid;
  if (code >= 0xD800 && code < 0xDC00 && at_[0] == '\\' && at_[1] == 'u') {  // half of a character
    const unsigned low = hexadecimal();
    code = low >= 0xDC00 && low < 0xE000 ? 0x10000 + (code - 0xD800) * 0x400 + (low - 0xDC00) : kInvalid;
  }
  if (code > 0x10FFFF || (code >= 0xD800 && code < 0xE000)) refuse();
  append_utf8(out, code);
}

/// Reads \uXXXX. The result is larger than any character if this is something else.
unsigned JsonScanner::hexadecimal() {
  unsigned code = 0;
  const char* const digits = at_ + 2;
  const auto available = std::min<std::ptrdiff_t>(4, std::max<std::ptrdiff_t>(0, end_ - digits));
  const auto [stopped, error] = std::from_chars(digits, digits + available, code, 16);
  if (error != std::errc() || stopped != digits + 4) return ~0u;
  at_ = digits + 4;
  return code;
}

void JsonScanner::skip_value(int depth) {
  if (depth > kDeepest) refuse_syntax(fmt::format("at most {} levels of nesting", kDeepest));
  const auto skip = [&] { skip_value(depth + 1); };
  std::string memory;
  switch (next()) {
    case '{':
      return object("an object", [&](std::string_view, const char*) { skip(); });
    case '[':
      return array("an array", skip);
    case '"':
      return void(string(memory, "a string"));
    case 't':
    case 'f':
      return void(boolean("a value"));
    default:
      break;
  }
  constexpr std::string_view kNull = "null";
  const char* stop = json_number_end(at_);
  if (static_cast<std::size_t>(end_ - at_) >= kNull.size() && std::string_view(at_, kNull.size()) == kNull)
    stop = at_ + kNull.size();
  if (!stop || !ends_word(*stop)) refuse_syntax("a value");
  at_ = stop;
}

}  // namespace boxplus
