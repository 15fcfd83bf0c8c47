// SPDX-License-Identifier: BSD-3-Clause
#include "linear/ordering/nested_dissection.h"

#include <gmock/gmock.h>

#include <numeric>

#include "boxplus/base/error.h"
#include "linear/block_cholesky/symbolic_factor.h"
#include "linear/test_system.h"

namespace boxplus {
namespace {

std::vector<BlockStructure> shapes() {
  std::vector<BlockStructure> all{BlockStructure{}, make_block_structure({3}, {}), cube(9, 6),
                                  random_system(900, 1500, 5).structure,
                                  make_block_structure(std::vector<std::uint32_t>(1500, 3), {})};  // no edges
  std::vector<BlockCoordinate> star, complete, chain;
  for (std::uint32_t k = 1; k < 1000; ++k) star.push_back({k, 0}), chain.push_back({k, k - 1});
  for (std::uint32_t i = 0; i < 250; ++i) {
    for (std::uint32_t j = 0; j < i; ++j) complete.push_back({i, j});
  }
  all.push_back(make_block_structure(std::vector<std::uint32_t>(1000, 3), star));
  all.push_back(make_block_structure(std::vector<std::uint32_t>(1000, 3), chain));
  all.push_back(make_block_structure(std::vector<std::uint32_t>(250, 2), complete));
  std::vector<std::uint32_t> dims(1000, 1);
  dims[500] = 5000;  // heavier than all other blocks together
  all.push_back(make_block_structure(dims, chain));
  return all;
}

TEST(NestedDissection, ContainsEveryBlockOnceForGraphsOfAllShapes) {
  for (const BlockStructure& structure : shapes()) {
    std::vector<std::uint32_t> order = nested_dissection(structure), all(structure.blocks());
    std::iota(all.begin(), all.end(), 0u);
    EXPECT_EQ(order, nested_dissection(structure)) << "the order differs between two runs";
    for (const int threads : {2, 3}) EXPECT_EQ(order, nested_dissection(structure, {}, threads));
    std::sort(order.begin(), order.end());
    EXPECT_EQ(order, all);
  }
}

TEST(NestedDissection, PutsTheBlocksThatMustBeLastAtTheEndInTheGivenOrder) {
  const BlockStructure structure = cube(8, 3);
  const std::vector<std::uint32_t> last{7, 300, 20};
  const auto order = nested_dissection(structure, last);
  EXPECT_THAT(std::vector(order.end() - 3, order.end()), ::testing::ElementsAre(7, 300, 20));
  EXPECT_THROW(nested_dissection(structure, std::vector<std::uint32_t>{512}), InvalidArgument);
  EXPECT_THROW(nested_dissection(structure, std::vector<std::uint32_t>{1, 1}), InvalidArgument);
}

TEST(NestedDissection, NeedsFewerOperationsThanMinimumDegreeForALargeCube) {
  const BlockStructure structure = cube(14, 6);
  const auto flops = [&](Ordering ordering) { return outline_factor(structure, {}, {}, ordering).flops; };
  EXPECT_LT(flops(Ordering::kNestedDissection), 0.8 * flops(Ordering::kMinimumDegree));
}

}  // namespace
}  // namespace boxplus
