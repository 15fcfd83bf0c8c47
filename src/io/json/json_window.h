// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "boxplus/io/text_source.h"

namespace boxplus {

/// The part of a text that is in memory. It moves from the beginning of the text to its end.
class JsonWindow {
 public:
  /// The place of a character: line and column, from 1.
  struct Place {
    std::int64_t line = 1, column = 1;
  };
  /// A place, and the number of bytes before it.
  struct Position : Place {
    std::size_t offset = 0;
  };

  /// The text must outlive this object. Skips a byte order mark.
  explicit JsonWindow(const TextSource& text);

  /// The characters in memory that have not been dropped. kDecimalRoom bytes after end() are 0.
  const char* begin() const { return memory_.data() + begin_; }
  const char* end() const { return memory_.data() + end_; }
  /// Drops the characters before `to`.
  void drop(const char* to) { begin_ = static_cast<std::size_t>(to - memory_.data()); }
  /// Drops blanks. Afterwards, the window is empty only at the end of the text.
  void drop_blanks();
  /// Reads more of the text. Returns false at its end. Invalidates all pointers. Throws InputError if the
  /// window becomes too large.
  bool more();

  Place place(const char* at) const;
  Position position() const;
  /// Continues at a position that was returned by position().
  void go_to(const Position& position);
  /// The number of bytes of the text from begin() on.
  std::size_t size_of_rest() const { return text_.size() - position_offset(); }

 private:
  std::size_t position_offset() const { return offset_ + begin_; }

  const TextSource& text_;
  std::string memory_, read_;
  std::size_t begin_ = 0, end_ = 0;
  std::size_t offset_ = 0;  // the number of bytes of the text before memory_
  Place place_;             // of the first character of memory_
};

}  // namespace boxplus
