// SPDX-License-Identifier: BSD-3-Clause
#include "growing/gnuplot.h"

#include <gtest/gtest.h>

#include "boxplus/io/graph_file.h"

namespace boxplus::programs {
namespace {

TEST(GnuplotCommands, DrawEachEdgeAsALine) {
  const GraphFile file = parse_graph(
      "VERTEX_SE2 0 0 0 0\nVERTEX_SE2 1 1 0.5 0\nVERTEX_XY 2 3 4\nEDGE_SE2 0 1 1 0 0 1 0 0 1 0 1\n"
      "EDGE_SE2_XY 1 2 1 1 1 0 1\n",
      "file");
  EXPECT_EQ(gnuplot_commands(file.graph),
            "set size ratio -1\nplot \"-\" using 1:2 with lines title \"2 edges\"\n"
            "0 0 0\n1 0.5 0\n\n1 0.5 0\n3 4 0\n\ne\n");
}

TEST(GnuplotCommands, DrawAGraphInSpaceInSpace) {
  const GraphFile file = parse_graph(
      "VERTEX_SE3:QUAT 0 0 0 1 0 0 0 1\nVERTEX_SE3:QUAT 1 1 0 2 0 0 0 1\n"
      "EDGE_SE3:QUAT 0 1 1 0 0 0 0 0 1 1 0 0 0 0 0 1 0 0 0 0 1 0 0 0 1 0 0 1 0 1\n",
      "file");
  EXPECT_EQ(gnuplot_commands(file.graph),
            "set view equal xyz\nsplot \"-\" using 1:2:3 with lines title \"1 edges\"\n0 0 1\n1 0 2\n\ne\n");
}

}  // namespace
}  // namespace boxplus::programs
