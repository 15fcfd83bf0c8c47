// SPDX-License-Identifier: BSD-3-Clause
#include "io/json/json_window.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "boxplus/base/error.h"
#include "io/characters.h"
#include "io/decimal.h"

namespace boxplus {
namespace {

constexpr std::size_t kPiece = std::size_t{1} << 18;
/// The largest element. 256 MiB hold an observation of a million points.
constexpr std::size_t kMost = std::size_t{1} << 28;

}  // namespace

JsonWindow::JsonWindow(const TextSource& text) : text_(text) {
  more();
  const std::string_view beginning(begin(), end_);
  begin_ = beginning.size() - without_byte_order_mark(beginning).size();
}

void JsonWindow::drop_blanks() {
  do {
    while (begin_ != end_ && (is_blank(memory_[begin_]) || memory_[begin_] == '\n') &&
           memory_[begin_] != '\v' && memory_[begin_] != '\f')
      ++begin_;
  } while (begin_ == end_ && more());
}

bool JsonWindow::more() {
  const std::size_t rest = end_ - begin_, wanted = std::max(kPiece, rest);
  const std::string_view piece = text_.bytes(offset_ + end_, wanted, read_);
  if (piece.empty()) return false;
  if (rest > kMost) {
    const Place at = place(begin());
    throw InputError(text_.name(), at.line, at.column,
                     fmt::format("expected an element of at most {} MiB, got a longer one", kMost >> 20));
  }
  place_ = place(begin());
  offset_ += begin_;
  if (memory_.size() < rest + wanted + kDecimalRoom) {
    std::string larger(rest + wanted + kDecimalRoom, '\0');
    std::memcpy(larger.data(), begin(), rest);
    memory_.swap(larger);
  } else {
    std::memmove(memory_.data(), begin(), rest);
  }
  begin_ = 0;
  end_ = rest + piece.size();
  std::memcpy(memory_.data() + rest, piece.data(), piece.size());
  std::memset(memory_.data() + end_, 0, kDecimalRoom);
  return true;
}

JsonWindow::Place JsonWindow::place(const char* at) const {
  const char* const first = memory_.data();
  const auto lines = std::count(first, at, '\n');
  if (lines == 0) return {place_.line, place_.column + (at - first)};
  const char* newline = at;
  while (*--newline != '\n') {
  }
  return {place_.line + lines, at - newline};
}

JsonWindow::Position JsonWindow::position() const {
  return {place(begin()), position_offset()};
}

void JsonWindow::go_to(const Position& position) {
  begin_ = end_ = 0;
  offset_ = position.offset;
  place_ = position;
  more();
}

}  // namespace boxplus
