// SPDX-License-Identifier: BSD-3-Clause
// Functions that trim, split, join, convert and read text.
#pragma once
#ifndef G2O_STRING_TOOLS_H
#define G2O_STRING_TOOLS_H

#include <cstdarg>
#include <istream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string>
#if __cplusplus >= 201703L
#include <string_view>
#include <type_traits>
#endif
#include <vector>

#include "g2o/stuff/g2o_stuff_api.h"
#include "g2o/stuff/macros.h"

namespace g2o {

/// Remove blanks (space, tab, line feed, carriage return) at both ends, on the left, or on the right.
G2O_STUFF_API std::string trim(const std::string& s);
G2O_STUFF_API std::string trimLeft(const std::string& s);
G2O_STUFF_API std::string trimRight(const std::string& s);

/// Convert the case of ASCII letters.
G2O_STUFF_API std::string strToLower(const std::string& s);
G2O_STUFF_API std::string strToUpper(const std::string& s);

/// Format like printf. strPrintf returns the number of characters, or −1 if the format is invalid.
G2O_STUFF_API std::string formatString(const char* fmt, ...) G2O_ATTRIBUTE_FORMAT12;
G2O_STUFF_API int strPrintf(std::string& str, const char* fmt, ...) G2O_ATTRIBUTE_FORMAT23;

/// Splits a string at each character of `delim`. Keeps empty parts, except an empty part at the end.
G2O_STUFF_API std::vector<std::string> strSplit(const std::string& s, const std::string& delim);

/// Writes the elements of a range as text, separated by a delimiter.
template <typename Iterator, typename = typename std::iterator_traits<Iterator>::value_type>
std::string strJoin(Iterator begin, Iterator end, const std::string& delimiter = "") {
  std::ostringstream out;
  for (Iterator element = begin; element != end; ++element) {
    if (element != begin) out << delimiter;
    out << *element;
  }
  return out.str();
}
template <typename Range>
std::string strJoin(const Range& range, const std::string& delimiter = "") {
  return strJoin(std::begin(range), std::end(range), delimiter);
}

G2O_STUFF_API bool strStartsWith(const std::string& s, const std::string& start);
G2O_STUFF_API bool strEndsWith(const std::string& s, const std::string& end);

/// Expands a leading ~ to the home directory. Replaces $NAME and ${NAME} by the values of environment
/// variables, or by nothing if a variable is not set.
G2O_STUFF_API std::string strExpandFilename(const std::string& filename);

/// Reads the next line, without the line break, into currentLine. Clears currentLine first. Returns the
/// number of characters, or −1 at the end of the stream.
G2O_STUFF_API int readLine(std::istream& is, std::stringstream& currentLine);
/// Skips the rest of the line.
G2O_STUFF_API void skipLine(std::istream& is);

/// Reads x from text. Returns false if the text does not begin with a value. If failIfLeftoverChars is true,
/// also returns false if other text follows the value.
template <typename T>
bool convertString(const std::string& s, T& x, bool failIfLeftoverChars = true) {
  std::istringstream in(s);
  T value;
  if (!(in >> value)) return false;
  char rest;
  if (failIfLeftoverChars && in >> rest) return false;
  x = value;
  return true;
}

/// Returns the value that the text contains. Throws std::runtime_error if convertString() would return false.
template <typename T>
T stringToType(const std::string& s, bool failIfLeftoverChars = true) {
  T x{};
  if (!convertString(s, x, failIfLeftoverChars))
    throw std::runtime_error("stringToType: expected a value, got \"" + s + "\"");
  return x;
}

#if __cplusplus >= 201703L
// Overloads for std::string_view. For a string literal, the compiler still chooses the std::string version.
namespace internal {
template <typename View>
using IfView = std::enable_if_t<std::is_same<View, std::string_view>::value, int>;
}  // namespace internal

template <typename View, internal::IfView<View> = 0>
std::string trim(View s) {
  return trim(std::string(s));
}
template <typename View, internal::IfView<View> = 0>
std::string trimLeft(View s) {
  return trimLeft(std::string(s));
}
template <typename View, internal::IfView<View> = 0>
std::string trimRight(View s) {
  return trimRight(std::string(s));
}
template <typename View, internal::IfView<View> = 0>
std::string strToLower(View s) {
  return strToLower(std::string(s));
}
template <typename View, internal::IfView<View> = 0>
std::string strToUpper(View s) {
  return strToUpper(std::string(s));
}
template <typename View, internal::IfView<View> = 0>
std::string strExpandFilename(View filename) {
  return strExpandFilename(std::string(filename));
}
template <typename View, typename Text, internal::IfView<View> = 0>
std::vector<std::string> strSplit(View s, const Text& delim) {
  return strSplit(std::string(s), std::string(delim));
}
template <typename View, typename Text, internal::IfView<View> = 0>
bool strStartsWith(View s, const Text& start) {
  return strStartsWith(std::string(s), std::string(start));
}
template <typename View, typename Text, internal::IfView<View> = 0>
bool strEndsWith(View s, const Text& end) {
  return strEndsWith(std::string(s), std::string(end));
}
template <typename View, typename T, internal::IfView<View> = 0>
bool convertString(View s, T& x, bool failIfLeftoverChars = true) {
  return convertString(std::string(s), x, failIfLeftoverChars);
}
#endif

}  // namespace g2o

#endif  // G2O_STRING_TOOLS_H
