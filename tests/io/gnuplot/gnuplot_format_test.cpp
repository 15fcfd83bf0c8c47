// SPDX-License-Identifier: BSD-3-Clause
#include "io/gnuplot/gnuplot_format.h"

#include <gmock/gmock.h>

#include "boxplus/base/error.h"
#include "io/colmap/model_folder.h"

namespace boxplus {
namespace {

using testing::EndsWith;
using testing::HasSubstr;

/// The text after the lines of the header.
std::string data_of(const std::string& text) {
  const std::string written = format_graph(parse_graph(text, "g"), {.format = "gnuplot"});
  return written.substr(written.find("\n\n\n") + 1);
}

TEST(GnuplotFormat, HasADataSetPerKindOfElement) {
  EXPECT_EQ(data_of("VERTEX_SE2 0 0 0 0.5\nVERTEX_SE2 1 1 0 0\nVERTEX_SE2 2 2 0 0\nVERTEX_XY 3 1 2\n"
                    "EDGE_SE2 0 1 1 0 0 1 0 0 1 0 1\nEDGE_SE2 0 2 1 0 0 1 0 0 1 0 1\n"
                    "EDGE_SE2_XY 1 3 0 2 1 0 1\nEDGE_PRIOR_SE2 0 0 0 0 1 0 0 1 0 1\n"),
            "\n\n# poses\n0 0 0 0.5\n1 1 0 0\n2 2 0 0\n"
            "\n\n# points\n3 1 2\n"
            "\n\n# odometry\n0 0\n1 0\n\n"
            "\n\n# closures\n0 0\n2 0\n\n"
            "\n\n# observations\n1 0\n1 2\n\n");
}

TEST(GnuplotFormat, LeavesOutEmptyDataSetsAndHasQuaternionsInSpace) {
  EXPECT_EQ(data_of("VERTEX_SE3:QUAT 4 1 2 3 0 0 0.6 0.8\n"), "\n\n# poses\n4 1 2 3 0 0 0.6 0.8\n");
  EXPECT_EQ(data_of("VERTEX_TRACKXYZ 4 1 2 3\n"), "\n\n# points\n4 1 2 3\n");
}

TEST(GnuplotFormat, DrawsEachPointOfAnEdgeWithSeveral) {
  EXPECT_THAT(data_of("VERTEX_SE2 0 0 0 0\nVERTEX_XY 1 1 0\nVERTEX_XY 2 2 0\n"
                      "EDGE_SE2_TWOPOINTSXY 0 1 2 1 0 2 0 1 0 0 0 1 0 0 1 0 1\n"),
              EndsWith("# observations\n0 0\n1 0\n\n0 0\n2 0\n\n"));
}

TEST(GnuplotFormat, CannotBeReadNorShowAGraphWithoutPositions) {
  const std::string written = format_graph(parse_graph("VERTEX_XY 4 1 2\n", "g"), {.format = "gnuplot"});
  EXPECT_THAT(complaint_of([&] { parse_graph(written, "g"); }),
              EndsWith("got .gnuplot, which boxplus can only write"));
  EXPECT_THAT(complaint_of([] { format_graph(Graph{}, {.format = "gnuplot"}); }),
              HasSubstr("expected poses or points"));
}

}  // namespace
}  // namespace boxplus
