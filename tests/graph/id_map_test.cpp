// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/graph/id_map.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <map>

namespace boxplus {
namespace {

RC_GTEST_PROP(IdMap, AgreesWithAnOrderedMapOverRandomInsertionsAndRemovals, ()) {
  // The low and high bits of the ids take few values, so ids repeat and share their low bits.
  const auto any_id = rc::gen::map(rc::gen::pair(rc::gen::inRange<Id>(0, 40), rc::gen::inRange<Id>(0, 4)),
                                   [](const auto& parts) { return parts.first + (parts.second << 40); });
  const auto ids = *rc::gen::container<std::vector<Id>>(any_id);
  detail::IdMap map;
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

TEST(IdMap, FindsNothingInAnEmptyMapOrUnderNegativeIds) {
  detail::IdMap map;
  EXPECT_EQ(map.find(0), nullptr);
  map.insert(0, {});
  for (const Id id : {Id{-1}, Id{-2}}) EXPECT_EQ(map.find(id), nullptr);
}

TEST(IdMap, EndsEverySearchEvenAfterManyInsertionsAndRemovals) {
  detail::IdMap map;
  for (Id id = 0; id < 100'000; ++id) {
    map.insert(id, {});
    if (id >= 8) map.erase(id - 8);
  }
  EXPECT_EQ(map.size(), 8u);
  EXPECT_EQ(map.by_id().size(), 8u);
}

TEST(IdMap, IsFastForIdsThatShareTheirLowBits) {
  // If most of the ids collided, the insertions would take minutes or hours.
  constexpr Id kCount = 300'000;
  for (const int shift : {20, 36, 40, 44}) {
    detail::IdMap map;
    for (Id k = 0; k < kCount; ++k) map.insert(k << shift, {0, static_cast<std::uint32_t>(k), 0});
    for (Id k = 0; k < kCount; ++k) ASSERT_EQ(map.find(k << shift)->slot, static_cast<std::uint32_t>(k));
  }
}

TEST(IdMap, IsFastForIdsWhoseHighBitsAreTags) {
  for (const int tag_bits : {5, 8, 14}) {
    detail::IdMap map;
    const Id tags = Id{1} << tag_bits, numbers = 300'000 / tags;
    for (Id tag = 0; tag < tags; ++tag) {
      for (Id k = 0; k < numbers; ++k) map.insert((tag << (62 - tag_bits)) + k, {});
    }
    EXPECT_EQ(map.size(), static_cast<std::size_t>(tags * numbers));
    EXPECT_TRUE(map.contains(((tags - 1) << (62 - tag_bits)) + numbers - 1));
  }
}

}  // namespace
}  // namespace boxplus
