// SPDX-License-Identifier: BSD-3-Clause
#include "io/g2o/g2o_format.h"

namespace boxplus {

FileFormat g2o_format() {
  // Accepts any text, even if it has no vertices and edges, because lines with unknown tags are kept.
  const auto recognize = [](std::string_view) { return true; };
  return {.name = "g2o",
          .extension = ".g2o",
          .recognize = recognize,
          .read = read_tagged_lines,
          .write = write_tagged_lines};
}

}  // namespace boxplus
