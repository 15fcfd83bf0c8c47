// SPDX-License-Identifier: BSD-3-Clause
#include "linear/ordering/nested_dissection.h"

#include <gmock/gmock.h>

#include <numeric>

#include "boxplus/base/error.h"
#include "linear/block_cholesky/symbolic_factor.h"
#include "linear/ordering/vertex_separator.h"
#include "linear/test_system.h"

namespace boxplus {
namespace {

std::vector<BlockStructure> shapes() {
  std::vector<BlockStructure> all{BlockStructure{}, make_block_structure({3}, {}), cube(9, 6),
                                  random_system(900, 1500, 5).structure,
                                  make_block_structure(std::vector<std::uint32_t>(1500, 3), {})};  // no edge
  std::vector<BlockCoordinate> star, complete, chain;
  for (std::uint32_t k = 1; k < 1000; ++k) star.push_back({k, 0}), chain.push_back({k, k - 1});
  for (std::uint32_t i = 0; i < 250; ++i) {
    for (std::uint32_t j = 0; j < i; ++j) complete.push_back({i, j});
  }
  all.push_back(make_block_structure(std::vector<std::uint32_t>(1000, 3), star));
  all.push_back(make_block_structure(std::vector<std::uint32_t>(1000, 3), chain));
  all.push_back(make_block_structure(std::vector<std::uint32_t>(250, 2), complete));
  std::vector<std::uint32_t> dims(1000, 1);
  dims[500] = 5000;  // heavier than all others
  all.push_back(make_block_structure(dims, chain));
  return all;
}

TEST(NestedDissection, NamesEveryBlockOnceForGraphsOfAllShapes) {
  for (const BlockStructure& structure : shapes()) {
    std::vector<std::uint32_t> order = nested_dissection(structure), all(structure.blocks());
    std::iota(all.begin(), all.end(), 0u);
    EXPECT_EQ(order, nested_dissection(structure)) << "another order in the second run";
    for (const int threads : {2, 3}) EXPECT_EQ(order, nested_dissection(structure, {}, threads));
    std::sort(order.begin(), order.end());
    EXPECT_EQ(order, all);
  }
}

TEST(NestedDissection, PutsTheBlocksThatMustBeLastAtTheEndInTheirOrder) {
  const BlockStructure structure = cube(8, 3);
  const std::vector<std::uint32_t> last{7, 300, 20};
  const auto order = nested_dissection(structure, last);
  EXPECT_THAT(std::vector(order.end() - 3, order.end()), ::testing::ElementsAre(7, 300, 20));
  EXPECT_THROW(nested_dissection(structure, std::vector<std::uint32_t>{512}), InvalidArgument);
  EXPECT_THROW(nested_dissection(structure, std::vector<std::uint32_t>{1, 1}), InvalidArgument);
}

TEST(NestedDissection, NeedsFewerOperationsThanMinimumDegreeInThreeDimensions) {
  const BlockStructure structure = cube(14, 6);
  const auto flops = [&](Ordering ordering) { return outline_factor(structure, {}, {}, ordering).flops; };
  EXPECT_LT(flops(Ordering::kNestedDissection), 0.8 * flops(Ordering::kMinimumDegree));
}

TEST(TheAutomaticOrdering, TakesTheDissectionOfLargeCubesAndMinimumDegreeElsewhere) {
  const auto taken = [](const BlockStructure& structure) {
    return outline_factor(structure, {}, {}, Ordering::kAutomatic).ordering;
  };
  EXPECT_EQ(taken(cube(14, 6)), Ordering::kNestedDissection);
  EXPECT_EQ(taken(cube(4, 6)), Ordering::kMinimumDegree);
  EXPECT_EQ(taken(make_block_structure(std::vector<std::uint32_t>(900, 3), grid_edges(30, 30))),
            Ordering::kMinimumDegree);
}

TEST(ASeparator, PartsAGridInHalvesByAboutOneRow) {
  const std::uint32_t height = 30, width = 50;
  WeightedGraph graph;
  std::vector<std::vector<std::uint32_t>> neighbors(height * width);
  for (const auto& [a, b] : grid_edges(height, width)) neighbors[a].push_back(b), neighbors[b].push_back(a);
  for (const auto& list : neighbors) {
    graph.neighbor.insert(graph.neighbor.end(), list.begin(), list.end());
    graph.start.push_back(static_cast<std::uint32_t>(graph.neighbor.size()));
    graph.weight.push_back(3);
  }
  graph.edge_weight.assign(graph.neighbor.size(), 1);
  const std::vector<Side> side = find_separator(graph);
  for (std::uint32_t v = 0; v < graph.vertices(); ++v) {
    for (const std::uint32_t u : graph.neighbors(v))
      EXPECT_FALSE(side[v] == kLeft && side[u] == kRight) << v << " touches " << u;
  }
  const auto count = [&](Side wanted) { return std::count(side.begin(), side.end(), wanted); };
  EXPECT_LE(count(kSeparator), 40);
  EXPECT_LE(std::max(count(kLeft), count(kRight)), 900);
}

}  // namespace
}  // namespace boxplus
