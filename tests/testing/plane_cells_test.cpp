// SPDX-License-Identifier: BSD-3-Clause
#include "testing/plane_cells.h"

#include <gmock/gmock.h>

namespace boxplus {
namespace {

std::vector<int> near(const PlaneCells& cells, const Vector2& center, double radius) {
  std::vector<int> found;
  cells.around(center, radius, [&](int index) { found.push_back(index); });
  return found;
}

TEST(PlaneCells, FindsEverythingInTheCellsThatTheSquareTouches) {
  PlaneCells cells(10);
  cells.add({5, 5}, 0);
  cells.add({-5, 5}, 1);
  cells.add({25, 5}, 2);
  cells.add({6, 7}, 3);
  EXPECT_THAT(near(cells, {5, 5}, 1), ::testing::ElementsAre(0, 3));
  EXPECT_THAT(near(cells, {5, 5}, 6), ::testing::ElementsAre(1, 0, 3));
  EXPECT_THAT(near(cells, {5, 5}, 20), ::testing::ElementsAre(1, 0, 3, 2));
  EXPECT_THAT(near(cells, {5, 95}, 9), ::testing::IsEmpty());
}

}  // namespace
}  // namespace boxplus
