// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include "boxplus/io/file_format.h"

namespace boxplus {
namespace {

TEST(DefaultFormats, AreG2oToroBalColmapAndPly) {
  std::vector<std::string> labels;
  for (const FileFormat& format : default_formats().all()) labels.push_back(format.label());
  EXPECT_THAT(labels, testing::ElementsAre(".g2o", "TORO's .graph", "BAL's .bal", "COLMAP folder",
                                           "COLMAP-text folder", ".ply"));
}

}  // namespace
}  // namespace boxplus
