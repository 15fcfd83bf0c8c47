// SPDX-License-Identifier: BSD-3-Clause
#include "core/shortest_numbers.h"

#include <array>
#include <charconv>
#include <locale>

namespace g2o {
namespace {

class Facet final : public std::num_put<char> {
 protected:
  iter_type do_put(iter_type out, std::ios_base&, char_type, double value) const override {
    std::array<char, 32> text;
    const std::to_chars_result result = std::to_chars(text.data(), text.data() + text.size(), value);
    for (const char* c = text.data(); c != result.ptr; ++c) *out++ = *c;
    return out;
  }
};

}  // namespace

// Sets the locale before it attaches the buffer. If a buffer is attached, imbue() passes the locale on to the
// buffer, and the buffer flushes. If that fails, the stream becomes unusable.
ShortestNumbers::ShortestNumbers(std::ostream& os) : to_(os), stream_(nullptr) {
  stream_.imbue(std::locale(std::locale::classic(), new Facet));
  stream_.rdbuf(os.rdbuf());
}

ShortestNumbers::~ShortestNumbers() {
  if (!stream_.bad()) return;
  try {
    to_.setstate(std::ios::badbit);
  } catch (const std::ios::failure&) {  // setstate() has set badbit before it throws
  }
}

}  // namespace g2o
