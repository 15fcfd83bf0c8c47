// SPDX-License-Identifier: BSD-3-Clause
#include "io/as_printed.h"

#include <gtest/gtest.h>

#include "boxplus/boxplus.h"

namespace boxplus {
namespace {

TEST(AsPrinted, QuaternionsOfMeasurementsAreWrittenAsTheyWereRead) {
  const std::string text =
      "VERTEX_SE3:QUAT 0 0 0 0 0 0 0 1\nVERTEX_SE3:QUAT 1 1 0 0 0 0 0 1\n"
      "EDGE_SE3:QUAT 0 1 1 0 0 -0.139007 0.0806488 0.14657 0.976059 1 0 0 0 0 0 1 0 0 0 0 1 0 0 0 1 0 0 1 0 "
      "1\n"
      "EDGE_SE3:QUAT 0 1 1 0 0 -0.0107791 0.00867285 -0.00190021 0.999902 1 0 0 0 0 0 1 0 0 0 0 1 0 0 0 1 0 "
      "0 1 0 1\n";
  const GraphFile file = parse_graph(text, "g");
  const SE3& z = file.graph.measurement(EdgeHandle<Between<SE3>>{file.edges[0]}).measurement;
  EXPECT_NE(z.quaternion().w, 0.976059) << "the measurement in memory is normalized";
  EXPECT_EQ(format_graph(file), text);
}

TEST(AsPrinted, QuaternionsOfRightAnglesCanBeReadAgain) {
  const GraphFile file = parse_graph(
      "VERTEX_SE3:QUAT 0 0 0 0 0 0 0 1\n"
      "VERTEX_SE3:QUAT 1 1 0 0 0 0 0.70710678118654757 0.70710678118654757\n"
      "EDGE_SE3:QUAT 0 1 1 0 0 0 0 0.70710678118654757 0.70710678118654757 1 0 0 0 0 0 1 0 0 0 0 1 0 0 0 1 0 "
      "0 1 0 "
      "1\n",
      "g");
  const GraphFile again = parse_graph(format_graph(file), "again");
  const EdgeHandle<Between<SE3>> edge{file.edges[0]}, copy{again.edges[0]};
  EXPECT_EQ(again.graph.measurement(copy).measurement.quaternion().w,
            file.graph.measurement(edge).measurement.quaternion().w);
}

TEST(AsPrinted, AnglesBeyondPiAreWrittenAsTheyWereRead) {
  const std::string text = "VERTEX_SE2 0 0 0 3.141593\nVERTEX_SE2 1 0 0 -3.1416\nVERTEX_SE2 2 0 0 3.14159\n";
  EXPECT_EQ(format_graph(parse_graph(text, "g")), text);
}

}  // namespace
}  // namespace boxplus
