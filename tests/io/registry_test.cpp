// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/io/registry.h"

#include <gmock/gmock.h>

#include "boxplus/boxplus.h"

namespace boxplus {
namespace {

/// A user's edge type: it measures the distance of a point from the origin.
struct FromOrigin {
  double measurement;
  explicit FromOrigin(double z) : measurement(z) {}
  template <class P>
  auto error(const P& p) const {
    return p.norm() - measurement;
  }
};

TEST(Registry, RegistersANewEdgeTypeInOneLine) {
  Registry registry = default_registry();
  registry.edge<FromOrigin, Vector2>("EDGE_FROM_ORIGIN");
  const char* text = "VERTEX_XY 0 3 4\nEDGE_FROM_ORIGIN 0 4.5 2\n";
  ReadOptions options;
  options.registry = &registry;
  const GraphFile file = parse_graph(text, "g", options);
  EXPECT_DOUBLE_EQ(file.graph.chi2(), 0.5);
  EXPECT_EQ(format_graph(file, {.registry = &registry}), text);
}

TEST(Registry, MakesAFileFromTheExampleOfATag) {
  Registry registry = default_registry();
  registry.edge<FromOrigin, Vector2>("EDGE_FROM_ORIGIN", "7 4.5 2");
  EXPECT_EQ(registry.example("EDGE_FROM_ORIGIN"), "VERTEX_XY 7 2 3\nEDGE_FROM_ORIGIN 7 4.5 2\n");
  EXPECT_EQ(registry.example("EDGE_SE2_POINTXY_OFFSET"),
            "PARAMS_SE2OFFSET 5 1 0 0.25\nVERTEX_SE2 1 1 0.1 0.5\nVERTEX_XY 2 2 3\n"
            "EDGE_SE2_POINTXY_OFFSET 1 2 5 1 1 1 0 1\n");
  EXPECT_EQ(registry.example("EDGE_SE2_LOTSOFXY"),
            "VERTEX_SE2 0 1 0.1 0.5\nVERTEX_XY 2 2 3\nVERTEX_XY 3 2 3\n"
            "EDGE_SE2_LOTSOFXY 0 2 3 || 2 1 2 3 4 1 0 0 0 1 0 0 1 0 1\n");
}

TEST(Registry, MakesNoFileIfAnExampleIsMissing) {
  Registry registry;
  registry.vertex<Vector2>("VERTEX_XY");
  registry.edge<FromOrigin, Vector2>("EDGE_FROM_ORIGIN", "7 4.5 2");
  EXPECT_THROW(registry.example("VERTEX_XY"), InvalidArgument);
  EXPECT_THROW(registry.example("EDGE_FROM_ORIGIN"), InvalidArgument);
  EXPECT_THROW(registry.example("UNKNOWN"), InvalidArgument);
  EXPECT_THAT(registry.names(), testing::ElementsAre("EDGE_FROM_ORIGIN", "VERTEX_XY"));
}

TEST(Registry, RefusesATakenTagAndTextThatCannotBeATag) {
  Registry registry = default_registry();
  EXPECT_THROW(registry.vertex<SE2>("VERTEX_SE2"), InvalidArgument);
  EXPECT_THROW(registry.vertex<SE2>("TWO WORDS"), InvalidArgument);
  EXPECT_THROW(registry.vertex<SE2>("FIX"), InvalidArgument);
  EXPECT_THROW(registry.vertex<SE2>("#X"), InvalidArgument);
}

TEST(Registry, WritesTheTagThatWasRegisteredFirstForAType) {
  const GraphFile file = parse_graph("VERTEX_XYZ 0 1 2 3\nVERTEX2 1 0 0 0\n", "g");
  EXPECT_EQ(format_graph(file), "VERTEX_TRACKXYZ 0 1 2 3\nVERTEX_SE2 1 0 0 0\n");
}

}  // namespace
}  // namespace boxplus
