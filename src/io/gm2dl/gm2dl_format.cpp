// SPDX-License-Identifier: BSD-3-Clause
#include "io/gm2dl/gm2dl_format.h"

#include "io/g2o/g2o_format.h"
#include "io/line_reader.h"
#include "io/toro/toro_format.h"

namespace boxplus {

FileFormat gm2dl_format() {
  return {.name = "Gm2dl",
          .extension = ".gm2dl",
          .recognize =
              [](std::string_view text) {
                const std::string_view tag = first_tag(text);
                return tag == "VERTEX" || tag == "EDGE";
              },
          .read = read_tagged_lines,
          .write = [](const GraphFileView& file, const WriteOptions& /*options*/,
                      TextSink sink) { write_pose_graph(file, gm2dl_registry(), sink); },
          .losses = parameter_losses,
          .written_on_request = true};
}

}  // namespace boxplus
