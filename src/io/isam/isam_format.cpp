// SPDX-License-Identifier: BSD-3-Clause
#include "io/isam/isam_format.h"

#include "io/isam/isam_graph.h"
#include "io/isam/isam_reader.h"
#include "io/line_reader.h"

namespace boxplus {

FileFormat isam_format() {
  return {.name = "iSAM",
          .extension = ".isam",
          // EDGE2 and EDGE3 are tags of TORO, too, with Ω instead of R.
          .recognize =
              [](std::string_view text) {
                const std::string_view tag = first_tag(text);
                return tag == "ODOMETRY" || tag == "ODOMETRY3" || tag == "LANDMARK" || tag == "POINT3";
              },
          .read =
              [](const TextSource& text, const ReadOptions& options) {
                GraphFile file;
                const IsamMeasurements measurements = read_isam(text, options, file);
                add_isam(measurements, file);
                return file;
              }};
}

}  // namespace boxplus
