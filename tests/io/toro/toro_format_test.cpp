// SPDX-License-Identifier: BSD-3-Clause
#include "io/toro/toro_format.h"

#include <gmock/gmock.h>

#include <tuple>

#include "boxplus/base/error.h"

namespace boxplus {
namespace {

TEST(ToroFormat, IsRecognizedByTheTagOfTheFirstElement) {
  const FileFormat toro = toro_format();
  EXPECT_TRUE(toro.recognize("VERTEX2 0 0 0 0\n"));
  EXPECT_TRUE(toro.recognize("# a comment\n\n \tEDGE3 0 1"));
  EXPECT_FALSE(toro.recognize("VERTEX_SE2 0 0 0 0\nVERTEX2 1 0 0 0\n"));
  EXPECT_FALSE(toro.recognize(" \n# VERTEX2"));
  EXPECT_FALSE(toro.recognize(""));
}

const std::string kPlane = "VERTEX2 0 0 0 0\nVERTEX2 1 1 0.1 0.5\nFIX 1\nEDGE2 0 1 1 0 0.5 10 1 20 30 2 3\n";
// The angles of the second pose are those of a rotation whose pitch is -π/2.
const std::string kSpace =
    "VERTEX3 0 0 0 0 0 0 0\nVERTEX3 1 1 2 3 0.3 -1.5707963267948966 1.2\nEDGE3 0 1 1 2 3 0.3 -0.4 1.2 "
    "1 0 0 5 0 0 2 0 0 0 0 3 0 0 0 100 0 7 200 0 300\n";

TEST(ToroFormat, WritesPosesOfThePlaneAsItReadsThem) {
  EXPECT_EQ(format_graph(parse_graph(kPlane, "g"), {.format = "TORO"}), kPlane);
}

TEST(ToroFormat, WritesRotationsAndInformationOfSpace) {
  const GraphFile file = parse_graph(kSpace, "g");
  const GraphFile again = parse_graph(format_graph(file, {.format = "TORO"}), "g");
  EXPECT_EQ(again.format, "TORO");
  for (const Id id : {0, 1}) {
    const SE3& expected = file.graph.estimate(file.graph.vertex<SE3>(id));
    const SE3& written = again.graph.estimate(again.graph.vertex<SE3>(id));
    EXPECT_EQ(written.translation(), expected.translation());
    EXPECT_LT((written.rotation() - expected.rotation()).norm(), 1e-15) << id;
  }
  const auto expected = file.graph.information(file.edges[0]),
             written = again.graph.information(again.edges[0]);
  for (int i = 0; i < 6; ++i) {
    for (int j = i; j < 6; ++j) EXPECT_EQ(written(i, j), expected(i, j)) << i << ' ' << j;
  }
  EXPECT_NEAR(again.graph.chi2(), file.graph.chi2(), 1e-12 * file.graph.chi2());
}

TEST(ToroFormat, IsWrittenOnlyOnRequest) {
  EXPECT_EQ(format_graph(parse_graph(kPlane, "g")).substr(0, 11), "VERTEX_SE2 ");
}

TEST(ToroFormat, LeavesOutParametersThatNoEdgeUses) {
  const GraphFile file =
      parse_graph("PARAMS_SE3OFFSET 0 0 0 0 0 0 0 1\nVERTEX_SE3:QUAT 1 1 2 3 0 0 0 1\n", "g");
  EXPECT_EQ(losses("g.graph", file), std::vector<std::string>{"1 parameter"});
  EXPECT_EQ(format_graph(file, {.format = "TORO"}), "VERTEX3 1 1 2 3 0 0 0\n");
}

TEST(ToroFormat, RefusesElementsThatItCannotRepresent) {
  const GraphFile points = parse_graph("VERTEX_XY 0 1 2\n", "g");
  EXPECT_THAT([&] { std::ignore = format_graph(points, {.format = "TORO"}); },
              testing::ThrowsMessage<InvalidArgument>(testing::HasSubstr(
                  "vertices of type VERTEX_XY: no tag is registered for them among EDGE2, ")));
  const GraphFile offset = parse_graph(default_registry().example("EDGE_SE2_OFFSET"), "g");
  EXPECT_THAT([&] { std::ignore = format_graph(offset, {.format = "TORO"}); },
              testing::ThrowsMessage<InvalidArgument>(testing::HasSubstr("edges of type EDGE_SE2_OFFSET: ")));
  EXPECT_EQ(losses("g.graph", parse_graph(kPlane, "g")), std::vector<std::string>{});
}

}  // namespace
}  // namespace boxplus
