// SPDX-License-Identifier: BSD-3-Clause
#include "guess/initial_guess.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>

#include "guess/scene.h"
#include "optimize/table_entries.h"

namespace boxplus {
namespace {

using namespace test;

template <class World>
class InitialGuess : public ::testing::Test {};
TYPED_TEST_SUITE(InitialGuess, Worlds);

TYPED_TEST(InitialGuess, RecoversANoiseFreeGraphFromArbitraryEstimatesIfOnePoseIsFixed) {
  for_each_guess([](std::size_t k) {
    Scene<TypeParam> scene;
    scene.fix(add_loop(scene, 0.4)[2]);
    scene.expect_truth_from(k);
  });
}

TYPED_TEST(InitialGuess, RecoversANoiseFreeGraphFromArbitraryEstimatesIfOnePoseHasAPrior) {
  for_each_guess([](std::size_t k) {
    Scene<TypeParam> scene;
    const auto poses = add_loop(scene);
    scene.graph.add_edge(Prior<TypeParam>{scene.truth(poses[3])}, poses[3]);
    scene.expect_truth_from(k);
  });
}

TYPED_TEST(InitialGuess, DoesNotMoveThePoseThatIsHeldInEachComponent) {
  for_each_guess([](std::size_t k) {
    Scene<TypeParam> scene;
    for (double seed : {0.0, 0.7}) {
      const auto first = add_loop(scene, seed)[0];
      scene.graph.set_estimate(first, Pose<TypeParam>{scene.truth(first)});
    }
    scene.expect_truth_from(k);
  });
}

TYPED_TEST(InitialGuess, DoesNotMoveThePoseWithTheLowestIdIfNoPoseIsHeld) {
  for_each_guess([](std::size_t k) {
    Scene<TypeParam> scene;
    const auto first = add_loop(scene)[0];
    scene.graph.set_estimate(first, Pose<TypeParam>{scene.truth(first)});
    PlanRequest request;
    request.gauge = GaugePolicy::kDamp;
    scene.expect_truth_from(k, request);
  });
}

TYPED_TEST(InitialGuess, AppliesSensorOffsetsThroughTheRelativeFrameOfTheEdge) {
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

TYPED_TEST(InitialGuess, NeverMovesAParameterThatIsBeingCalibrated) {
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
    const detail::Frame before = frame_of<TypeParam>(scene.graph.estimate(d).motion);
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

TYPED_TEST(InitialGuess, DoesNotMoveVerticesThatNoRelativeMeasurementReaches) {
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

TYPED_TEST(InitialGuess, IgnoresDisabledEdgesAndEdgesWithZeroInformation) {
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

TYPED_TEST(InitialGuess, AlignsAComponentWithMeasuredPositions) {
  for_each_guess([](std::size_t k) {
    Scene<TypeParam> scene;
    for (const auto& pose : add_loop(scene)) {
      scene.graph.add_edge(PositionPrior<TypeParam>{scene.truth(pose).translation()}, pose);
    }
    scene.expect_truth_from(k);
  });
}

TYPED_TEST(InitialGuess, AlignsAComponentWithPointsOfKnownPosition) {
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

TYPED_TEST(InitialGuess, PropagatesThroughMeasurementsBetweenPoints) {
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

TYPED_TEST(InitialGuess, ComputesTheSameBitsEveryTime) {
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

TYPED_TEST(InitialGuess, DoesNotDependOnTheEstimatesOfActiveVerticesEvenIfTheyAreNotFinite) {
  for_each_guess([](std::size_t k) {
    Scene<TypeParam> scene;
    const auto poses = add_loop(scene);
    scene.fix(poses[0]);
    detail::Frame frame = frame_of<TypeParam>(scene.truth(poses[1]));
    frame.translation.fill(std::numeric_limits<double>::quiet_NaN());
    scene.graph.set_estimate(poses[1], Pose<TypeParam>{TypeParam::from(frame)});
    scene.expect_truth_from(k);
  });
}

TEST(InitialGuessOfMixedGraphs, SupportsPosesInThePlaneAndInSpaceAtOnce) {
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
    EXPECT_TRUE(every_guess()[k].guess(graph, make_plan(graph, {}), {}).made);
    EXPECT_LT(graph.chi2(), 1e-18);
  });
}

}  // namespace
}  // namespace boxplus
