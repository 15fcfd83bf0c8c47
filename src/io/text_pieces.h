// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fmt/format.h>

#include <iterator>
#include <string>

#include "boxplus/io/file_format.h"

namespace boxplus {

/// Formats text, and passes it on in pieces. flush() passes on the last piece.
class TextPieces {
 public:
  explicit TextPieces(TextSink sink) : sink_(sink) {}
  template <class... T>
  void add(fmt::format_string<const T&...> format, const T&... values) {
    constexpr std::size_t kPiece = std::size_t{1} << 18;
    fmt::vformat_to(std::back_inserter(text_), format, fmt::make_format_args(values...));
    if (text_.size() >= kPiece) flush();
  }
  void flush() {
    sink_(text_);
    text_.clear();
  }

 private:
  TextSink sink_;
  std::string text_;
};

}  // namespace boxplus
