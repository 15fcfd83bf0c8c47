// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/stuff/string_tools.h"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <limits>

namespace g2o {
namespace {

constexpr char kBlanks[] = " \t\n\r";

int print_to(std::string& text, const char* format, std::va_list arguments) {
  std::va_list again;
  va_copy(again, arguments);
  const int length = std::vsnprintf(nullptr, 0, format, again);
  va_end(again);
  if (length < 0) return -1;
  text.resize(static_cast<size_t>(length) + 1);
  std::vsnprintf(text.data(), text.size(), format, arguments);
  text.pop_back();
  return length;
}

std::string with_case(std::string s, int (*change)(int)) {
  for (char& c : s) {
    if (static_cast<unsigned char>(c) < 128) c = static_cast<char>(change(c));
  }
  return s;
}

std::string environment(const std::string& name) {
  const char* value = std::getenv(name.c_str());
  return value == nullptr ? "" : value;
}

bool is_name(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

}  // namespace

std::string trim(const std::string& s) {
  return trimLeft(trimRight(s));
}

std::string trimLeft(const std::string& s) {
  const size_t first = s.find_first_not_of(kBlanks);
  return first == std::string::npos ? std::string() : s.substr(first);
}

std::string trimRight(const std::string& s) {
  return s.substr(0, s.find_last_not_of(kBlanks) + 1);
}

std::string strToLower(const std::string& s) {
  return with_case(s, &std::tolower);
}

std::string strToUpper(const std::string& s) {
  return with_case(s, &std::toupper);
}

std::string formatString(const char* fmt, ...) {
  std::string text;
  std::va_list arguments;
  va_start(arguments, fmt);
  print_to(text, fmt, arguments);
  va_end(arguments);
  return text;
}

int strPrintf(std::string& str, const char* fmt, ...) {
  std::va_list arguments;
  va_start(arguments, fmt);
  const int length = print_to(str, fmt, arguments);
  va_end(arguments);
  return length;
}

std::vector<std::string> strSplit(const std::string& s, const std::string& delim) {
  std::vector<std::string> parts;
  for (size_t begin = 0; begin < s.size();) {
    const size_t end = s.find_first_of(delim, begin);
    parts.push_back(s.substr(begin, end - begin));
    if (end == std::string::npos) break;
    begin = end + 1;
  }
  return parts;
}

bool strStartsWith(const std::string& s, const std::string& start) {
  return s.compare(0, start.size(), start) == 0;
}

bool strEndsWith(const std::string& s, const std::string& end) {
  return s.size() >= end.size() && s.compare(s.size() - end.size(), end.size(), end) == 0;
}

std::string strExpandFilename(const std::string& filename) {
  std::string result;
  size_t i = 0;
  if (!filename.empty() && filename[0] == '~' && (filename.size() == 1 || filename[1] == '/')) {
    result = environment("HOME");
    i = 1;
  }
  while (i < filename.size()) {
    if (filename[i] != '$') {
      result += filename[i++];
      continue;
    }
    const bool braces = i + 1 < filename.size() && filename[i + 1] == '{';
    const size_t begin = i + (braces ? 2 : 1);
    size_t end = begin;
    while (end < filename.size() && is_name(filename[end])) ++end;
    const bool closed = !braces || (end < filename.size() && filename[end] == '}');
    if (end == begin || !closed) {  // not a variable name: keep the text
      result += filename[i++];
      continue;
    }
    result += environment(filename.substr(begin, end - begin));
    i = end + (braces ? 1 : 0);
  }
  return result;
}

int readLine(std::istream& is, std::stringstream& currentLine) {
  currentLine.str("");
  currentLine.clear();
  std::string line;
  if (!std::getline(is, line)) return -1;
  currentLine << line;
  return static_cast<int>(line.size());
}

void skipLine(std::istream& is) {
  is.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
}

}  // namespace g2o
