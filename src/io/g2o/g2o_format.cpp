// SPDX-License-Identifier: BSD-3-Clause
#include "io/g2o/g2o_format.h"

namespace boxplus {

FileFormat g2o_format() {
  // Accepts any text, even without vertices and edges, because the reader keeps lines with unknown tags.
  const auto recognize = [](std::string_view) { return true; };
  return {.name = "g2o",
          .extension = ".g2o",
          .recognize = recognize,
          .read = read_tagged_lines,
          .write = write_tagged_lines};
}

}  // namespace boxplus
