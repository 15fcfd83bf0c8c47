// SPDX-License-Identifier: BSD-3-Clause
// Sends messages to a sink that the program sets. Until the program sets a sink, errors go to std::cerr and
// other messages are dropped.
//
//     g2o::logging::setSink([](g2o::logging::Level, const std::string& text) { std::cerr << text << '\n'; });
//     G2O_ERROR("vertex {} is missing", id);
#pragma once
#ifndef G2O_LOGGER_H
#define G2O_LOGGER_H

#include <functional>
#include <sstream>
#include <string>

#include "g2o/stuff/g2o_stuff_api.h"

namespace g2o {
namespace logging {

enum class Level { kTrace, kDebug, kInfo, kWarn, kError, kOff };

using Sink = std::function<void(Level, const std::string&)>;

/// Replaces the sink. An empty function drops all messages, including errors. Not thread-safe: no other
/// thread may log at the same time.
G2O_STUFF_API void setSink(Sink sink);
/// Drops messages below this level. The initial level is kWarn. Without a sink, all messages below kError are
/// dropped.
G2O_STUFF_API void setLevel(Level level);
G2O_STUFF_API bool wanted(Level level);
G2O_STUFF_API void log(Level level, const std::string& text);

namespace internal {

inline void append(std::ostringstream& out, const char* format) {
  out << format;
}

/// Replaces each {} (or {:…}) in `format` by the next argument.
template <typename T, typename... Rest>
void append(std::ostringstream& out, const char* format, const T& first, const Rest&... rest) {
  while (*format != '\0' && *format != '{') out << *format++;
  if (*format == '\0') return;
  while (*format != '\0' && *format != '}') ++format;
  out << first;
  append(out, *format == '\0' ? format : format + 1, rest...);
}

}  // namespace internal

template <typename... Args>
void format_and_log(Level level, const char* format, const Args&... args) {
  if (!wanted(level)) return;
  std::ostringstream text;
  internal::append(text, format, args...);
  log(level, text.str());
}

}  // namespace logging
}  // namespace g2o

#define G2O_TRACE(...) ::g2o::logging::format_and_log(::g2o::logging::Level::kTrace, __VA_ARGS__)
#define G2O_DEBUG(...) ::g2o::logging::format_and_log(::g2o::logging::Level::kDebug, __VA_ARGS__)
#define G2O_INFO(...) ::g2o::logging::format_and_log(::g2o::logging::Level::kInfo, __VA_ARGS__)
#define G2O_WARN(...) ::g2o::logging::format_and_log(::g2o::logging::Level::kWarn, __VA_ARGS__)
#define G2O_ERROR(...) ::g2o::logging::format_and_log(::g2o::logging::Level::kError, __VA_ARGS__)
#define G2O_CRITICAL(...) ::g2o::logging::format_and_log(::g2o::logging::Level::kError, __VA_ARGS__)

#endif  // G2O_LOGGER_H
