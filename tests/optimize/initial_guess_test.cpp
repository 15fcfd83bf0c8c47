// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/optimize/initial_guess.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "optimize/frame_types.h"

namespace boxplus {
namespace {

using namespace test;

constexpr std::array kGuesses{guess_odometry, guess_spanning_tree, guess_chordal};
constexpr std::array<const char*, 3> kNames{"odometry", "spanning tree", "chordal"};

/// A graph whose vertices have a true place; measurements are perfect, estimates are not.
template <class World>
class Scene {
 public:
  using Motion = typename World::Motion;
  using PoseHandle = VertexHandle<Pose<World>>;
  using PointHandle = VertexHandle<Point<World>>;

  PoseHandle add_pose(double seed, std::optional<Id> id = std::nullopt) {
    truth_.push_back(World::motion(seed));
    poses_.push_back(graph.add_vertex(Pose<World>{garbage(poses_.size())}, id));
    return poses_.back();
  }
  PointHandle add_point(double seed, std::optional<Id> id = std::nullopt) {
    positions_.push_back(World::motion(seed).translation());
    points_.push_back(graph.add_vertex(Point<World>{garbage(points_.size()).translation()}, id));
    return points_.back();
  }
  EdgeHandle<Between<World>> join(PoseHandle a, PoseHandle b, Information information = 1.0) {
    return graph.add_edge(Between<World>{truth(a).inverse() * truth(b)}, information, a, b);
  }
  void see(PoseHandle a, PointHandle b) {
    graph.add_edge(Sighting<World>{truth(a).inverse() * truth(b)}, a, b);
  }
  void fix(PoseHandle pose) {
    graph.set_estimate(pose, Pose<World>{truth(pose)});
    graph.fix(pose);
  }
  void fix(PointHandle point) {
    graph.set_estimate(point, Point<World>{truth(point)});
    graph.fix(point);
  }

  Motion truth(PoseHandle pose) const { return truth_[index(poses_, pose)]; }
  PointError<World> truth(PointHandle point) const { return positions_[index(points_, point)]; }

  GuessResult apply(std::size_t k, const PlanRequest& request = {}) {
    return kGuesses[k](graph, make_plan(graph, request), {});
  }
  /// The k-th guess finds the truth.
  void expect_truth_from(std::size_t k, const PlanRequest& request = {}) {
    EXPECT_TRUE(apply(k, request).made);
    EXPECT_LT(largest_error(), 1e-9);
  }
  double error(PoseHandle pose) const {
    const auto d = frame_of<World>(graph.estimate(pose).motion), e = frame_of<World>(truth(pose));
    double sum = 0;
    for (std::size_t i = 0; i < 9; ++i) sum += std::abs(d.rotation[i] - e.rotation[i]);
    for (std::size_t i = 0; i < 3; ++i) sum += std::abs(d.translation[i] - e.translation[i]);
    return sum;
  }
  double error(PointHandle point) const { return (graph.estimate(point).position - truth(point)).norm(); }
  double largest_error() const {
    double largest = 0;
    for (PoseHandle pose : poses_) largest = std::max(largest, error(pose));
    for (PointHandle point : points_) largest = std::max(largest, error(point));
    return largest;
  }

  Graph graph;

 private:
  static Motion garbage(std::size_t k) { return World::motion(100.0 + 7.3 * static_cast<double>(k)); }
  template <class H>
  static std::size_t index(const std::vector<H>& handles, const H& handle) {
    return static_cast<std::size_t>(std::find(handles.begin(), handles.end(), handle) - handles.begin());
  }

  std::vector<PoseHandle> poses_;
  std::vector<PointHandle> points_;
  std::vector<Motion> truth_;
  std::vector<PointError<World>> positions_;
};

template <class World>
class InitialGuess : public ::testing::Test {};
using Worlds = ::testing::Types<Plane, Space>;
TYPED_TEST_SUITE(InitialGuess, Worlds);

/// Runs `body(k)` for each method.
template <class F>
void for_each_guess(F&& body) {
  for (std::size_t k = 0; k < kGuesses.size(); ++k) {
    SCOPED_TRACE(kNames[k]);
    body(k);
  }
}

/// Five poses in a chain with loop closures, and three points, ids mixed.
template <class World>
std::array<typename Scene<World>::PoseHandle, 5> add_loop(Scene<World>& scene, double seed = 0) {
  std::array<typename Scene<World>::PoseHandle, 5> poses;
  std::array<typename Scene<World>::PointHandle, 3> points;
  for (std::size_t k = 0; k < 5; ++k) {
    poses[k] = scene.add_pose(seed + static_cast<double>(k));
    if (k < 3) points[k] = scene.add_point(seed + 0.3 * static_cast<double>(k));
  }
  for (std::size_t k = 0; k + 1 < 5; ++k) scene.join(poses[k], poses[k + 1]);
  scene.join(poses[4], poses[0]);
  scene.join(poses[1], poses[3], 0.5);
  for (std::size_t k = 0; k < 5; ++k) {
    for (std::size_t l = 0; l < 3; ++l) scene.see(poses[k], points[l]);
  }
  return poses;
}

TYPED_TEST(InitialGuess, RecoversANoiseFreeGraphFromGarbageAroundAFixedPoseAwayFromTheOrigin) {
  for_each_guess([](std::size_t k) {
    Scene<TypeParam> scene;
    scene.fix(add_loop(scene, 0.4)[2]);
    scene.expect_truth_from(k);
  });
}

TYPED_TEST(InitialGuess, StartsFromPosePriors) {
  for_each_guess([](std::size_t k) {
    Scene<TypeParam> scene;
    const auto poses = add_loop(scene);
    scene.graph.add_edge(Prior<TypeParam>{scene.truth(poses[3])}, poses[3]);
    scene.expect_truth_from(k);
  });
}

TYPED_TEST(InitialGuess, KeepsTheHeldPoseOfEachComponentWhereItIs) {
  for_each_guess([](std::size_t k) {
    Scene<TypeParam> scene;
    for (double seed : {0.0, 0.7}) {
      const auto first = add_loop(scene, seed)[0];
      scene.graph.set_estimate(first, Pose<TypeParam>{scene.truth(first)});
    }
    scene.expect_truth_from(k);
  });
}

TYPED_TEST(InitialGuess, KeepsThePoseOfLowestIdWhereNothingIsHeld) {
  for_each_guess([](std::size_t k) {
    Scene<TypeParam> scene;
    const auto first = add_loop(scene)[0];
    scene.graph.set_estimate(first, Pose<TypeParam>{scene.truth(first)});
    PlanRequest request;
    request.gauge = GaugePolicy::kDamp;
    scene.expect_truth_from(k, request);
  });
}

TYPED_TEST(InitialGuess, FoldsSensorOffsetsInThroughTheHook) {
  for_each_guess([](std::size_t k) {
    Scene<TypeParam> scene;
    const auto mount = TypeParam::motion(9);
    const auto parameter = scene.graph.add_parameter(Pose<TypeParam>{mount});
    const auto a = scene.add_pose(0), b = scene.add_pose(1);
    scene.graph.add_edge(
        MountedBetween<TypeParam>{(scene.truth(a) * mount).inverse() * (scene.truth(b) * mount)}, a, b,
        parameter);
    scene.fix(a);
    scene.expect_truth_from(k);
  });
}

TYPED_TEST(InitialGuess, NeverMovesAParameterThatIsCalibrated) {
  for_each_guess([](std::size_t k) {
    Scene<TypeParam> scene;
    const auto mount = TypeParam::motion(9);
    const auto parameter = scene.graph.add_parameter(Pose<TypeParam>{mount});
    scene.graph.unfix(parameter);
    const auto a = scene.add_pose(0), b = scene.add_pose(1);
    scene.graph.add_edge(
        MountedBetween<TypeParam>{(scene.truth(a) * mount).inverse() * (scene.truth(b) * mount)}, a, b,
        parameter);
    scene.fix(a);
    scene.expect_truth_from(k);
    EXPECT_EQ(frame_of<TypeParam>(scene.graph.estimate(parameter).motion).rotation,
              frame_of<TypeParam>(mount).rotation);
  });
}

TYPED_TEST(InitialGuess, MovesOnlyTheActiveVertices) {
  for_each_guess([](std::size_t k) {
    Scene<TypeParam> scene;
    const auto a = scene.add_pose(0), b = scene.add_pose(1), c = scene.add_pose(2), d = scene.add_pose(3);
    scene.join(a, b);
    scene.join(b, c);
    scene.join(c, d);
    scene.graph.set_estimate(a, Pose<TypeParam>{scene.truth(a)});
    const Frame before = frame_of<TypeParam>(scene.graph.estimate(d).motion);
    const std::array<VertexRef, 2> active{b, c};
    PlanRequest request;
    request.vertices = active;
    scene.graph.set_enabled(scene.graph.all_edges().back(), false);
    EXPECT_TRUE(scene.apply(k, request).made);
    for (const auto& pose : {a, b, c}) EXPECT_LT(scene.error(pose), 1e-9);
    EXPECT_EQ(frame_of<TypeParam>(scene.graph.estimate(d).motion).rotation, before.rotation);
    EXPECT_EQ(frame_of<TypeParam>(scene.graph.estimate(d).motion).translation, before.translation);
  });
}

TYPED_TEST(InitialGuess, LeavesVerticesThatNoRelativeMeasurementReaches) {
  for_each_guess([](std::size_t k) {
    Scene<TypeParam> scene;
    const auto poses = add_loop(scene);
    scene.fix(poses[0]);
    const auto point = scene.add_point(3), other_point = scene.add_point(4);
    const auto lone = scene.add_pose(8);
    const auto number = scene.graph.add_vertex(2.5);
    scene.graph.add_edge(Direction<TypeParam>{PointError<TypeParam>::UnitX()}, poses[1], point);
    scene.graph.add_edge(Direction<TypeParam>{PointError<TypeParam>::UnitX()}, lone, other_point);
    scene.graph.add_edge([](double x) { return x - 1; }, number);
    const auto position = scene.graph.estimate(point).position;
    const auto motion = scene.graph.estimate(lone).motion;
    EXPECT_TRUE(scene.apply(k).made);
    for (const auto& pose : poses) EXPECT_LT(scene.error(pose), 1e-9);
    EXPECT_EQ(scene.graph.estimate(point).position, position);
    EXPECT_EQ(frame_of<TypeParam>(scene.graph.estimate(lone).motion).rotation,
              frame_of<TypeParam>(motion).rotation);
    EXPECT_EQ(scene.graph.estimate(number), 2.5);
  });
}

TYPED_TEST(InitialGuess, IsNotMadeWithoutRelativeMeasurements) {
  for_each_guess([](std::size_t k) {
    Scene<TypeParam> scene;
    const auto pose = scene.add_pose(0);
    const auto point = scene.add_point(1);
    scene.graph.add_edge(Direction<TypeParam>{PointError<TypeParam>::UnitX()}, pose, point);
    const double before = scene.largest_error();
    const GuessResult result = scene.apply(k);
    EXPECT_FALSE(result.made);
    EXPECT_FALSE(result.note.empty());
    EXPECT_EQ(scene.largest_error(), before);
  });
}

TYPED_TEST(InitialGuess, IgnoresDisabledAndWeightlessEdges) {
  for_each_guess([](std::size_t k) {
    Scene<TypeParam> scene;
    const auto poses = add_loop(scene);
    scene.fix(poses[0]);
    const Between<TypeParam> wrong{TypeParam::motion(55)};
    const auto disabled = scene.graph.add_edge(wrong, 1e6, poses[0], poses[1]);
    scene.graph.set_enabled(disabled, false);
    scene.graph.add_edge(wrong, 0.0, poses[1], poses[2]);
    scene.expect_truth_from(k);
  });
}

TYPED_TEST(InitialGuess, MovesAComponentOntoMeasuredPositions) {
  for_each_guess([](std::size_t k) {
    Scene<TypeParam> scene;
    for (const auto& pose : add_loop(scene)) {
      scene.graph.add_edge(PositionPrior<TypeParam>{scene.truth(pose).translation()}, pose);
    }
    scene.expect_truth_from(k);
  });
}

TYPED_TEST(InitialGuess, MovesAComponentOntoPointsOfKnownPosition) {
  for_each_guess([](std::size_t k) {
    Scene<TypeParam> scene;
    const auto poses = add_loop(scene);
    for (double seed : {0.1, 1.0, 2.0, 3.0}) {
      const auto point = scene.add_point(seed);
      scene.see(poses[static_cast<std::size_t>(seed)], point);
      if (seed < 1.5) {
        scene.graph.add_edge(PointPrior<TypeParam>{scene.truth(point)}, point);
      } else {
        scene.fix(point);
      }
    }
    scene.expect_truth_from(k);
  });
}

TYPED_TEST(InitialGuess, FollowsPointsThatAreMeasuredFromPoints) {
  for_each_guess([](std::size_t k) {
    Scene<TypeParam> scene;
    const auto a = scene.add_pose(0), b = scene.add_pose(1);
    const auto p = scene.add_point(2), q = scene.add_point(3), r = scene.add_point(4);
    scene.fix(a);
    scene.join(a, b);
    scene.see(b, q);
    scene.graph.add_edge(Offset<TypeParam>{scene.truth(q) - scene.truth(p)}, p, q);
    scene.graph.add_edge(Offset<TypeParam>{scene.truth(r) - scene.truth(q)}, q, r);
    scene.expect_truth_from(k);
  });
}

TYPED_TEST(InitialGuess, GivesTheSameBitsEveryTime) {
  for_each_guess([](std::size_t k) {
    const auto run = [&] {
      Scene<TypeParam> scene;
      scene.fix(add_loop(scene)[0]);
      EXPECT_TRUE(scene.apply(k).made);
      return scene.largest_error();
    };
    EXPECT_EQ(run(), run());
  });
}

TYPED_TEST(InitialGuess, DoesNotDependOnTheEstimatesOfActiveVerticesEvenWhereTheyAreNotFinite) {
  for_each_guess([](std::size_t k) {
    Scene<TypeParam> scene;
    const auto poses = add_loop(scene);
    scene.fix(poses[0]);
    Frame frame = frame_of<TypeParam>(scene.truth(poses[1]));
    frame.translation.fill(std::numeric_limits<double>::quiet_NaN());
    scene.graph.set_estimate(poses[1], Pose<TypeParam>{TypeParam::from(frame)});
    scene.expect_truth_from(k);
  });
}

TYPED_TEST(InitialGuess, ChordalKeepsTheEstimateOfAPoseWhereNothingMeasuresIt) {
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
  EXPECT_LT(scene.graph.chi2(), 1e-6);  // the rest is as exact as its measurements
}

TYPED_TEST(InitialGuess, ChordalSpreadsTheErrorOfALoopThatTheOthersLeaveInOneEdge) {
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

TYPED_TEST(InitialGuess, OdometryFollowsConsecutiveIdsAndBridgesGaps) {
  Scene<TypeParam> scene;
  const auto a = scene.add_pose(0, 10), b = scene.add_pose(1, 11), c = scene.add_pose(2, 20),
             d = scene.add_pose(3, 21);
  scene.fix(a);
  scene.join(a, b);
  scene.join(b, d);  // the only way across the gap between 11 and 20
  scene.join(c, d);
  scene.graph.add_edge(Between<TypeParam>{TypeParam::motion(55)}, 1e6, a,
                       d);  // needs as many bridges, and is longer
  EXPECT_TRUE(scene.apply(0).made);
  EXPECT_LT(scene.error(b), 1e-9);
  scene.graph.set_enabled(scene.graph.all_edges().back(), false);
  scene.expect_truth_from(0);
}

TYPED_TEST(InitialGuess, OdometryDoesNotUseLoopClosures) {
  Scene<TypeParam> scene;
  const auto poses = add_loop(scene);
  scene.fix(poses[0]);
  scene.graph.add_edge(Between<TypeParam>{TypeParam::motion(55)}, 1e6, poses[0], poses[4]);
  scene.expect_truth_from(0);
}

TYPED_TEST(InitialGuess, SpanningTreePrefersTwoCertainEdgesToAnUncertainOne) {
  Scene<TypeParam> scene;
  const auto a = scene.add_pose(0), b = scene.add_pose(1), c = scene.add_pose(2);
  scene.fix(a);
  scene.join(a, b, 10.0);
  scene.join(b, c, 10.0);
  scene.graph.add_edge(Between<TypeParam>{TypeParam::motion(55)}, 1.0, a, c);
  scene.expect_truth_from(1);
}

TYPED_TEST(InitialGuess, SpanningTreeKeepsAPoseThatIsJoinedThroughLandmarksOnly) {
  Scene<TypeParam> scene;
  const auto a = scene.add_pose(0), b = scene.add_pose(1);
  const auto p = scene.add_point(2), q = scene.add_point(3);
  scene.fix(a);
  scene.see(a, p);
  scene.see(b, p);
  scene.see(b, q);
  scene.graph.set_estimate(b, Pose<TypeParam>{scene.truth(b)});
  scene.expect_truth_from(1);
}

TEST(InitialGuessOfPoses, ReplacesEstimatesThatAreNotFinite) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  SE3 pose = SE3::from_unit(Vector<double, 3>(kNan, kNan, kNan), Quaternion<double>{kNan, kNan, kNan, kNan});
  FrameTrait<SE3>::set(pose, FrameTrait<SE3>::get(SE3()));
  EXPECT_EQ(pose.vector(), SE3().vector());
}

TEST(InitialGuessOfMixedGraphs, HandlesThePlaneAndSpaceSideBySide) {
  for_each_guess([](std::size_t k) {
    Graph graph;
    const auto a = graph.add_vertex(Pose<Plane>{Plane::motion(1)}),
               b = graph.add_vertex(Pose<Plane>{Plane::motion(2)});
    const auto c = graph.add_vertex(Pose<Space>{Space::motion(1)}),
               d = graph.add_vertex(Pose<Space>{Space::motion(2)});
    graph.add_edge(Between<Plane>{Plane::motion(3)}, a, b);
    graph.add_edge(Between<Space>{Space::motion(3)}, c, d);
    graph.fix(a);
    graph.fix(c);
    EXPECT_TRUE(kGuesses[k](graph, make_plan(graph, {}), {}).made);
    EXPECT_LT(graph.chi2(), 1e-18);
  });
}

/// Raises a flag when measurements were asked for so many times.
struct Alarm {
  std::size_t at = 0, asked = 0;
  std::atomic<bool> raised = false;
};

struct AlarmingBetween : Between<Plane> {
  Alarm* alarm;
  AlarmingBetween(const SE2& measured, Alarm& a) : Between<Plane>{measured}, alarm(&a) {}
  RelativeFrame relative_frame(const Pose<Plane>& a, const Pose<Plane>& b) const {
    if (++alarm->asked == alarm->at) alarm->raised = true;
    return Between<Plane>::relative_frame(a, b);
  }
};

TEST(ChordalGuess, StopsAmongItsMeasurementsWithoutMovingAnything) {
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
  // They are asked for as they are found, for the joint problem, and for the positions.
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
