// SPDX-License-Identifier: BSD-3-Clause
#include "io/edges_to_write.h"

#include <gmock/gmock.h>

#include "boxplus/types/slam2d.h"

namespace boxplus {
namespace {

TEST(EdgesToWrite, AreThoseOfTheFileThenNewOnes) {
  Graph graph;
  const auto a = graph.add_vertex(Vector2(0, 0)), b = graph.add_vertex(Vector2(1, 0));
  const Between z(Vector2(1, 0));
  const EdgeRef first = graph.add_edge(z, a, b), second = graph.add_edge(z, a, b),
                third = graph.add_edge(z, a, b), removed = graph.add_edge(z, a, b);
  const std::vector<EdgeRef> listed{third, removed, first, third};
  graph.remove(removed);
  EXPECT_THAT(edges_to_write({graph, listed}),
              testing::ElementsAre(third, EdgeRef{}, first, EdgeRef{}, second));
  EXPECT_THAT(edges_to_write({graph}), testing::ElementsAre(first, second, third));
}

}  // namespace
}  // namespace boxplus
