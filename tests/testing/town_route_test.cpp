// SPDX-License-Identifier: BSD-3-Clause
#include "testing/town_route.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace boxplus {
namespace {

/// The distance of a place from the middle of the nearest street.
double distance_from_streets(const Vector2& place) {
  const auto from_line = [](double x) { return std::abs(std::remainder(x, Town::kBlock)); };
  return std::min(from_line(place[0]), from_line(place[1]));
}

TEST(TownRoute, MovesContinuouslyInTheDirectionOfItsHeadingAndStaysOnTheStreets) {
  for (const bool returns : {false, true}) {
    RandomNumbers random(5);
    const TownRoute route(3000, returns, random);
    constexpr double kStep = 0.01;
    for (double time = 0; time < 3000 - kStep; time += kStep) {
      const TownRoute::Place here = route.at(time), next = route.at(time + kStep);
      const Vector2 motion = next.position - here.position;
      EXPECT_LE(motion.norm(), kStep * (1 + 1e-9));
      EXPECT_GE(motion.norm(), 0.49 * kStep) << "the car drives at half speed in turns";
      const double heading = std::atan2(motion[1], motion[0]);
      EXPECT_LT(std::abs(std::remainder(heading - here.heading, 2 * kPi)), 0.01);
      EXPECT_LT(distance_from_streets(here.position), Town::kHalfStreet * 0.6);
    }
  }
}

using Square = std::pair<int, int>;

/// The squares of 20 m that the route visits, and the number of visits.
std::pair<std::set<Square>, int> visits(const TownRoute& route, double length) {
  std::set<Square> squares;
  Square last{-1, -1};
  int count = 0;
  for (double time = 0; time < length; ++time) {
    const Vector2 place = route.at(time).position / 20;
    const Square square(static_cast<int>(std::lround(place[0])), static_cast<int>(std::lround(place[1])));
    if (square == last) continue;
    last = square;
    squares.insert(square);
    ++count;
  }
  return {squares, count};
}

TEST(TownRoute, VisitsEachPlaceOnceOrAboutThreeTimes) {
  constexpr double kLength = 20'000;
  RandomNumbers random(2);
  const auto [once, visits_once] = visits(TownRoute(kLength, false, random), kLength);
  EXPECT_EQ(std::ssize(once), visits_once);
  const auto [often, visits_often] = visits(TownRoute(kLength, true, random), kLength);
  EXPECT_NEAR(visits_often / static_cast<double>(often.size()), 3, 1);
}

}  // namespace
}  // namespace boxplus
