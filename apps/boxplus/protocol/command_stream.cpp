// SPDX-License-Identifier: BSD-3-Clause
#include "protocol/command_stream.h"

#include <algorithm>
#include <utility>

#include "boxplus/base/error.h"

namespace boxplus::app {
namespace {

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\v' || c == '\f';
}

}  // namespace

CommandText::Place CommandText::place_of(std::size_t position) const {
  const auto after =
      std::upper_bound(segments.begin(), segments.end(), position,
                       [](std::size_t at, const Segment& segment) { return at < segment.begin; });
  if (after == segments.begin()) return {1, 1};
  const Segment& segment = *std::prev(after);
  return {segment.place.line, segment.place.column + static_cast<std::int64_t>(position - segment.begin)};
}

std::optional<CommandText> CommandStream::next(std::string_view& received) {
  while (!received.empty()) {
    const char c = received.front();
    received.remove_prefix(1);
    if (!take(c)) continue;
    begins_segment_ = true;
    return std::exchange(command_, {});
  }
  return std::nullopt;
}

bool CommandStream::take(char c) {
  const bool is_first = command_.text.empty(), follows_blank = is_first || command_.text.back() == ' ';
  bool ends = false;
  if (c == '\n') {
    in_comment_ = false;
    if (!is_first) append(' ');
    begins_segment_ = true;
  } else if (in_comment_ || (c == '#' && follows_blank)) {
    in_comment_ = true;
  } else if (c == ';') {
    ends = !is_first;
    if (ends) command_.segments.push_back({command_.text.size(), at_});
  } else if (!is_first || !is_blank(c)) {
    append(is_blank(c) ? ' ' : c);
  }
  at_ = c == '\n' ? CommandText::Place{at_.line + 1, 1} : CommandText::Place{at_.line, at_.column + 1};
  return ends;
}

void CommandStream::append(char c) {
  if (begins_segment_) command_.segments.push_back({command_.text.size(), at_});
  begins_segment_ = false;
  if (command_.text.size() == kMaxBytes) {
    const auto [line, column] = command_.place_of(0);
    throw InputError(
        name_, line, column,
        "expected a command of at most " + std::to_string(kMaxBytes) + " bytes, got a longer one");
  }
  command_.text += c;
}

void CommandStream::finish() const {
  if (command_.text.empty()) return;
  throw InputError(name_, at_.line, at_.column, "expected a ; after the command, got the end of the input");
}

}  // namespace boxplus::app
