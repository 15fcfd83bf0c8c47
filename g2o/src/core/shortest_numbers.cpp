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

ShortestNumbers::ShortestNumbers(std::ostream& os) : stream_(os.rdbuf()) {
  stream_.imbue(std::locale(std::locale::classic(), new Facet));
}

}  // namespace g2o
