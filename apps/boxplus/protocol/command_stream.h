// SPDX-License-Identifier: BSD-3-Clause
// Splits a stream of text into commands, which end with semicolons.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace boxplus::app {

/// A command without its semicolon. Line breaks and comments are blanks.
struct CommandText {
  struct Place {
    std::int64_t line, column;  ///< from 1; columns count bytes
  };
  /// A part of the text that is in one line.
  struct Segment {
    std::size_t begin;  ///< in `text`
    Place place;        ///< in the stream
  };
  std::string text;
  std::vector<Segment> segments;

  /// The place of a character of the text, or of the semicolon if `position` is the size of the text.
  Place place_of(std::size_t position) const;
};

/// Takes a stream in pieces of any size. A # at the beginning of a word begins a comment, which ends with its
/// line. Empty commands are skipped. Uses as much memory as the longest command.
class CommandStream {
 public:
  static constexpr std::size_t kMaxBytes = std::size_t{1} << 20;  ///< of one command

  /// `name` is the name of the stream in messages.
  explicit CommandStream(std::string name) : name_(std::move(name)) {}

  /// Removes characters from the beginning of `received` up to the end of the next command, and returns this
  /// command. If its end has not been received, takes everything and returns nothing. Throws InputError if
  /// the command is longer than kMaxBytes.
  std::optional<CommandText> next(std::string_view& received);
  /// Call it at the end of the stream. Throws InputError if the stream ends within a command.
  void finish() const;

  const std::string& name() const { return name_; }

 private:
  /// Returns true if the character ends a command.
  bool take(char c);
  void append(char c);

  std::string name_;
  CommandText command_;
  CommandText::Place at_{1, 1};
  bool in_comment_ = false, begins_segment_ = true;
};

}  // namespace boxplus::app
