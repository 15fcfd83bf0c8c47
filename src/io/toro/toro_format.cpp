// SPDX-License-Identifier: BSD-3-Clause
#include "io/toro/toro_format.h"

#include <algorithm>
#include <array>

#include "boxplus/io/field_reader.h"
#include "io/g2o/g2o_format.h"

namespace boxplus {
namespace {

/// Whether the first line that is neither blank nor a comment has a tag of TORO.
bool begins_with_tag_of_toro(std::string_view text) {
  constexpr std::array<std::string_view, 4> kTags{"VERTEX2", "EDGE2", "VERTEX3", "EDGE3"};
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    FieldReader line({}, 0, text.substr(0, end));
    if (!line.at_end()) return std::find(kTags.begin(), kTags.end(), line.token("a tag")) != kTags.end();
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return false;
}

}  // namespace

FileFormat toro_format() {
  return {
      .name = "TORO", .extension = ".graph", .recognize = begins_with_tag_of_toro, .read = read_tagged_lines};
}

}  // namespace boxplus
