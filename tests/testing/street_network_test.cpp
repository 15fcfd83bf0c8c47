// SPDX-License-Identifier: BSD-3-Clause
#include "testing/street_network.h"

#include <gmock/gmock.h>

namespace boxplus {
namespace {

using ::testing::AllOf;
using ::testing::Ge;
using ::testing::Le;

constexpr int kSizes[] = {1000, 10'000, 100'000};

int beginning(const StreetNetwork& network, const Leg& leg) {
  return leg.forward ? network.street(leg).from : network.street(leg).to;
}
int end(const StreetNetwork& network, const Leg& leg) {
  return leg.forward ? network.street(leg).to : network.street(leg).from;
}

TEST(StreetNetwork, HasStreetsOfAtLeastOneHundredStepsOfAboutOneMeter) {
  for (int size : kSizes) {
    RandomNumbers random(4);
    const StreetNetwork network(size, 140, random);
    for (const Street& street : network.streets()) {
      EXPECT_GE(street.steps - 1, 100);
      EXPECT_THAT(network.length(street) / street.steps, AllOf(Ge(0.99), Le(1)));
    }
  }
}

TEST(StreetNetwork, DrivesEachStreetTwoToFourTimes) {
  for (int size : kSizes) {
    RandomNumbers random(5);
    const StreetNetwork network(size, 140, random);
    std::vector<int> passes(network.streets().size());
    for (const Leg& leg : network.route(random)) ++passes[static_cast<std::size_t>(leg.street)];
    for (std::size_t i = 0; i < passes.size(); ++i) {
      EXPECT_EQ(passes[i], network.streets()[i].passes);
      EXPECT_THAT(passes[i], AllOf(Ge(2), Le(4)));
    }
  }
}

TEST(StreetNetwork, HasAClosedRouteOfTheRequestedLength) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    constexpr int kSteps = 20'000;
    RandomNumbers random(seed);
    const StreetNetwork network(kSteps, 140, random);
    const std::vector<Leg> route = network.route(random);
    int steps = 0, turned_back = 0;
    for (std::size_t i = 0; i < route.size(); ++i) {
      const Leg& next = route[(i + 1) % route.size()];
      ASSERT_EQ(end(network, route[i]), beginning(network, next)) << "seed " << seed;
      steps += network.street(route[i]).steps;
      turned_back += next.street == route[i].street;
    }
    EXPECT_THAT(steps, AllOf(Ge(kSteps), Le(1.05 * kSteps))) << "seed " << seed;
    EXPECT_LE(turned_back, static_cast<int>(route.size() / 8)) << "seed " << seed << " of " << route.size();
  }
}

TEST(StreetNetwork, IsNotAPerfectLattice) {
  RandomNumbers random(6);
  const StreetNetwork network(100'000, 140, random);
  std::vector<int> degree(network.crossings().size());
  for (const Street& street : network.streets()) {
    ++degree[static_cast<std::size_t>(street.from)];
    ++degree[static_cast<std::size_t>(street.to)];
  }
  EXPECT_THAT(degree, ::testing::Contains(3).Times(Ge(10)));
  EXPECT_THAT(degree, ::testing::Each(AllOf(Ge(2), Le(4))));
}

TEST(StreetNetwork, DrivesOnTheRightAndPassesTheCrossings) {
  RandomNumbers random(7);
  const StreetNetwork network(1000, 140, random);
  const Street& street = network.streets()[0];
  const SE2 there = network.pose({0, true}, street.steps / 2),
            back = network.pose({0, false}, street.steps / 2);
  EXPECT_NEAR(there.inverse_times(back.translation())[1], 3, 1e-12);
  EXPECT_NEAR(back.inverse_times(there.translation())[1], 3, 1e-12);
  for (bool forward : {true, false}) {
    EXPECT_LT((network.pose({0, forward}, 0).translation() - network.crossings()[0]).norm(), 1e-12);
  }
}

}  // namespace
}  // namespace boxplus
