// SPDX-License-Identifier: BSD-3-Clause
#include "io/toro/toro_format.h"

#include <algorithm>
#include <array>

#include "io/g2o/g2o_format.h"
#include "io/line_reader.h"

namespace boxplus {
namespace {

bool begins_with_tag_of_toro(std::string_view text) {
  constexpr std::array<std::string_view, 4> kTags{"VERTEX2", "EDGE2", "VERTEX3", "EDGE3"};
  return std::find(kTags.begin(), kTags.end(), first_tag(text)) != kTags.end();
}

}  // namespace

FileFormat toro_format() {
  return {
      .name = "TORO", .extension = ".graph", .recognize = begins_with_tag_of_toro, .read = read_tagged_lines};
}

}  // namespace boxplus
