// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/graph/id_map.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <map>

namespace boxplus {
namespace {

RC_GTEST_PROP(IdMap, AgreesWithAnOrderedMapOverRandomInsertionsAndRemovals, ()) {
  // Few different low digits, so that entries are contested; high ones too.
  const auto any_id = rc::gen::map(rc::gen::pair(rc::gen::inRange<Id>(0, 40), rc::gen::inRange<Id>(0, 4)),
                                   [](const auto& parts) { return parts.first + (parts.second << 40); });
  const auto ids = *rc::gen::container<std::vector<Id>>(any_id);
  IdMap map;
  std::map<Id, VertexRef> expected;
  std::uint32_t slot = 0;
  for (const Id id : ids) {
    if (expected.contains(id)) {
      map.erase(id);
      expected.erase(id);
    } else {
      map.insert(id, {0, slot, 0});
      expected[id] = {0, slot++, 0};
    }
    RC_ASSERT(map.size() == expected.size());
    RC_ASSERT(map.contains(id) == expected.contains(id));
  }
  std::vector<VertexRef> in_order;
  for (const auto& [id, vertex] : expected) {
    RC_ASSERT(map.find(id) && *map.find(id) == vertex);
    in_order.push_back(vertex);
  }
  RC_ASSERT(map.by_id() == in_order);
}

TEST(IdMap, FindsNothingInAnEmptyMapNorUnderNegativeIds) {
  IdMap map;
  EXPECT_EQ(map.find(0), nullptr);
  map.insert(0, {});
  for (const Id id : {Id{-1}, Id{-2}}) EXPECT_EQ(map.find(id), nullptr);
}

TEST(IdMap, StaysSmallWhereVerticesComeAndGo) {
  IdMap map;
  for (Id id = 0; id < 100'000; ++id) {
    map.insert(id, {});
    if (id >= 8) map.erase(id - 8);
  }
  EXPECT_EQ(map.size(), 8u);
  EXPECT_EQ(map.by_id().size(), 8u);
}

TEST(IdMap, TakesIdsThatAreMultiplesOfALargePowerOfTwo) {
  // With all of them at one place a linear search would take hours for so many.
  IdMap map;
  constexpr Id kCount = 300'000;
  for (Id k = 0; k < kCount; ++k) map.insert(k << 36, {0, static_cast<std::uint32_t>(k), 0});
  for (Id k = 0; k < kCount; ++k) ASSERT_EQ(map.find(k << 36)->slot, static_cast<std::uint32_t>(k));
}

}  // namespace
}  // namespace boxplus
