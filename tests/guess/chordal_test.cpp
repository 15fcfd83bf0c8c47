// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <vector>

#include "guess/scene.h"

namespace boxplus {
namespace {

using namespace test;

template <class World>
class ChordalGuess : public ::testing::Test {};
TYPED_TEST_SUITE(ChordalGuess, Worlds);

TYPED_TEST(ChordalGuess, KeepsTheEstimateOfAPoseInDirectionsThatAreNotMeasured) {
  Scene<TypeParam> scene;
  const auto poses = add_loop(scene);
  scene.fix(poses[0]);
  const auto point = scene.add_point(7);
  const auto loose = scene.add_pose(9);  // sees one point only
  scene.see(poses[1], point);
  scene.see(loose, point);
  const GuessResult result = scene.apply(2);
  EXPECT_TRUE(result.made);
  EXPECT_FALSE(result.note.empty());
  EXPECT_LT(scene.graph.chi2(), 1e-6);  // the measurements are exact, and the guess fits them
}

TYPED_TEST(ChordalGuess, DistributesTheErrorOfALoopThatOtherGuessesLeaveInOneEdge) {
  constexpr int kPoses = 8;
  std::array<double, 3> chi2{};
  for_each_guess([&](std::size_t k) {
    Scene<TypeParam> scene;
    std::vector<typename Scene<TypeParam>::PoseHandle> poses;
    for (int i = 0; i < kPoses; ++i) poses.push_back(scene.add_pose(0.3 * i));
    scene.fix(poses[0]);
    for (std::size_t i = 0; i < kPoses; ++i) {
      const auto &from = poses[i], &to = poses[(i + 1) % kPoses];
      std::array<double, 6> noise{};
      for (std::size_t j = 0; j < 6; ++j) noise[j] = 0.02 * std::sin(static_cast<double>(10 * i + j));
      const auto truth = scene.truth(from).inverse() * scene.truth(to);
      const auto measured = Manifold<typename TypeParam::Motion>::oplus(truth, noise.data());
      scene.graph.add_edge(Between<TypeParam>{measured}, from, to);
    }
    EXPECT_TRUE(scene.apply(k).made);
    chi2[k] = scene.graph.chi2();
  });
  EXPECT_LT(chi2[2], 0.5 * chi2[0]);
  EXPECT_LT(chi2[2], 0.5 * chi2[1]);
}

/// Counts in `asked` how often measurements are read, and sets `raised` when the count reaches `at`.
struct Alarm {
  std::size_t at = 0, asked = 0;
  std::atomic<bool> raised = false;
};

struct AlarmingBetween : Between<Plane> {
  Alarm* alarm;
  AlarmingBetween(const SE2& measured, Alarm& a) : Between<Plane>{measured}, alarm(&a) {}
  detail::RelativeFrame relative_frame(const Pose<Plane>& a, const Pose<Plane>& b) const {
    if (++alarm->asked == alarm->at) alarm->raised = true;
    return Between<Plane>::relative_frame(a, b);
  }
};

TEST(StoppedChordalGuess, StopsWhileItReadsMeasurementsWithoutChangingAnEstimate) {
  constexpr std::size_t kMeasurements = 20000, kSoon = 5000;
  Graph graph;
  Alarm alarm;
  std::vector<VertexHandle<Pose<Plane>>> poses{graph.add_vertex(Pose<Plane>{})};
  for (std::size_t k = 0; k < kMeasurements; ++k) {
    poses.push_back(graph.add_vertex(Pose<Plane>{Plane::motion(static_cast<double>(k))}));
    graph.add_edge(AlarmingBetween(Plane::motion(1), alarm), poses[k], poses[k + 1]);
  }
  const Plan plan = make_plan(graph, {});
  const double before = graph.chi2();
  // Measurements are read three times: when they are collected, when rotations and positions are solved
  // together, and when the positions are solved again.
  for (const std::size_t at : {std::size_t{1}, kMeasurements + 1, 2 * kMeasurements + 1}) {
    alarm.at = at;
    alarm.asked = 0;
    alarm.raised = false;
    const GuessResult guess = guess_chordal(graph, plan, {.stop = StopToken(&alarm.raised)});
    EXPECT_FALSE(guess.made);
    EXPECT_LT(alarm.asked, at + kSoon);
    EXPECT_EQ(graph.chi2(), before);
  }
}

}  // namespace
}  // namespace boxplus
