// SPDX-License-Identifier: BSD-3-Clause
// What each part of the search for gauge freedom is for.
#include "gauge/gauge.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <random>
#include <type_traits>

#include "boxplus/boxplus.h"
#include "boxplus/types/ba/similarity.h"
#include "plan/active_set.h"

namespace boxplus {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

Gauge gauge_of(const Graph& graph, GaugePolicy policy = GaugePolicy::kFixFirst, const StopToken& stop = {}) {
  return find_active_set(graph, {.gauge = policy, .stop = stop}).gauge;
}

std::vector<Id> held_ids(const Gauge& gauge) {
  std::vector<Id> ids;
  for (const detail::GaugeVertex& held : gauge.held) ids.push_back(held.id);
  return ids;
}

std::vector<Id> free_ids(const Gauge& gauge) {
  std::vector<Id> ids;
  for (const detail::GaugeFreedom& freedom : gauge.freedoms) ids.push_back(freedom.id);
  return ids;
}

std::vector<std::string> names_of(const Gauge& gauge) {
  std::vector<std::string> names;
  for (const detail::GaugeFreedom& freedom : gauge.freedoms) names.emplace_back(to_string(freedom));
  return names;
}

Vector2 place(int k) {
  return {std::cos(2 * k) + 0.3 * k, std::sin(3 * k)};
}
SE2 pose(int k) {
  return {place(k)[0], place(k)[1], 0.4 * k};
}

/// The motion between two poses, measured by an edge of no ready-made type.
struct Motion {
  template <class A>
  auto error(const A& a, const A& b) const {
    return a.inverse_times(b).vector();
  }
};

std::vector<VertexHandle<SE2>> add_chain(Graph& graph, int count) {
  std::vector<VertexHandle<SE2>> poses;
  for (int k = 0; k < count; ++k) {
    poses.push_back(graph.add_vertex(pose(k)));
    if (k > 0) graph.add_edge(Motion{}, poses[poses.size() - 2], poses.back());
  }
  return poses;
}

TEST(Gauge, OfAChainOfAnyEdgesIsThatOfItsFirstPose) {
  Graph graph;
  add_chain(graph, 5);
  const Gauge gauge = gauge_of(graph);
  EXPECT_THAT(held_ids(gauge), ElementsAre(0));
  EXPECT_THAT(gauge.freedoms, IsEmpty());
  EXPECT_THAT(gauge.loose, IsEmpty());
}

TEST(Gauge, IsNotFreeIfAPoseIsFixedThatOnlyOneOfManyEdgesTouches) {
  Graph graph;
  const auto poses = add_chain(graph, 4000);
  for (const std::size_t fixed : {1u, 1003u, 2222u}) {
    const auto anchor = graph.add_vertex(SE2(1, 2, 3));
    graph.fix(anchor);
    const EdgeRef edge = graph.add_edge(Motion{}, anchor, poses[fixed]);
    EXPECT_THAT(gauge_of(graph).freedoms, IsEmpty());
    graph.remove(edge);
  }
}

TEST(Gauge, IsNotFreeIfADirectionIsFixedOfAPoseThatOnlyTwoOfManyEdgesTouch) {
  Graph graph;
  const auto poses = add_chain(graph, 4000);
  graph.fix_directions(poses[1003], {0, 1});
  EXPECT_THAT(names_of(gauge_of(graph)), ElementsAre("rotation"));
  graph.fix_directions(poses[2222], {0});
  const Gauge gauge = gauge_of(graph);
  EXPECT_THAT(gauge.freedoms, IsEmpty());
  EXPECT_TRUE(gauge.components[0].anchored);
}

/// Measures the motion from a to b or, if `anchored`, the position of b.
struct MotionOrPosition {
  bool anchored;
  template <class P>
  P error(const P& a, const P& b) const {
    return anchored ? b : P(b - a);
  }
};

TEST(Gauge, IsNoErrorIfOneOfManyEdgesOfATypeMeasuresIt) {
  Graph graph;
  std::vector<VertexHandle<Vector2>> points;
  for (int k = 0; k < 4000; ++k) points.push_back(graph.add_vertex(place(k)));
  for (std::size_t k = 0; k + 1 < points.size(); ++k)
    graph.add_edge(MotionOrPosition{k == 1234}, points[k], points[k + 1]);
  EXPECT_THAT(gauge_of(graph, GaugePolicy::kError).freedoms, IsEmpty());
  graph.fix_directions(points[0], {0});
  EXPECT_THAT(gauge_of(graph, GaugePolicy::kError).freedoms, IsEmpty());
}

TEST(Gauge, IsFoundInWorldsOfAnySizeAndAnywhere) {
  for (const auto& [size, north] :
       {std::pair(5e-6, 0.0), std::pair(1.0, 0.0), std::pair(1e7, 0.0), std::pair(1.0, 5e6)}) {
    Graph graph;
    std::vector<VertexHandle<SE2>> poses;
    for (int k = 0; k < 5; ++k)
      poses.push_back(
          graph.add_vertex(SE2(0.1 * north + size * place(k)[0], north + size * place(k)[1], 0.4 * k)));
    for (std::size_t k = 1; k < poses.size(); ++k) graph.add_edge(Motion{}, poses[k - 1], poses[k]);
    EXPECT_THAT(held_ids(gauge_of(graph)), ElementsAre(0)) << size;
    graph.add_edge([](const auto& p) { return p.translation().eval(); }, poses[2]);
    EXPECT_THAT(names_of(gauge_of(graph)), ElementsAre("rotation")) << size;
    graph.add_edge([](const auto& p) { return p.translation()[0]; }, poses[4]);
    EXPECT_THAT(gauge_of(graph).freedoms, IsEmpty()) << size;
  }
}

/// The motion between two poses, without a template, so that its Jacobians are numeric.
struct NumericMotion {
  Vector3 error(const SE2& a, const SE2& b) const { return a.inverse_times(b).vector(); }
};

TEST(Gauge, IsFoundFromNumericJacobiansFarFromTheOrigin) {
  Graph graph;
  std::vector<VertexHandle<SE2>> poses;
  for (int k = 0; k < 5; ++k)
    poses.push_back(graph.add_vertex(SE2(1e5 + place(k)[0], 1e5 + place(k)[1], 0.4 * k)));
  for (std::size_t k = 1; k < poses.size(); ++k) graph.add_edge(NumericMotion{}, poses[k - 1], poses[k]);
  EXPECT_THAT(held_ids(gauge_of(graph)), ElementsAre(0));
}

TEST(Gauge, IsFixedByEdgesWhoseErrorsHaveATinyUnit) {
  Graph graph;
  const auto poses = add_chain(graph, 5);
  graph.add_edge([](const auto& p) { return (1e-9 * p.vector()).eval(); }, poses[2]);
  EXPECT_THAT(gauge_of(graph).freedoms, IsEmpty());
}

/// The motion between two poses in space, measured with a bias of the first N numbers.
template <int N>
std::vector<Id> held_with_bias_of() {
  Graph graph;
  std::vector<VertexHandle<SE3>> poses;
  for (int k = 0; k < 5; ++k) {
    const double turn[6] = {place(k)[0], place(k)[1], 0.2 * k * k, 0.1 * k, 0.2, 0};
    poses.push_back(graph.add_vertex(Manifold<SE3>::oplus(SE3(), turn)));
  }
  const auto bias = graph.add_vertex(Vector<double, N>(Vector<double, N>::Constant(0.1)));
  for (std::size_t k = 1; k < poses.size(); ++k) {
    graph.add_edge(
        [](const auto& a, const auto& b, const auto& c) {
          auto error = a.inverse_times(b).minimal().eval();
          error.template head<N>() += c;
          return error;
        },
        poses[k - 1], poses[k], bias);
  }
  return held_ids(gauge_of(graph));
}

TEST(Gauge, OfPosesInSpaceIsNotHiddenByABiasThatLooksLikeAPoint) {
  EXPECT_THAT(held_with_bias_of<2>(), ElementsAre(0));
  EXPECT_THAT(held_with_bias_of<3>(), ElementsAre(0));
}

TEST(Gauge, OfAPlaneAndOfSpaceThatShareANumberIsHeldInBoth) {
  Graph graph;
  const auto offset = graph.add_vertex(1.0);
  std::vector<VertexHandle<SE2>> plane;
  std::vector<VertexHandle<SE3>> space;
  for (int k = 0; k < 3; ++k) {
    plane.push_back(graph.add_vertex(pose(k), 10 + k));
    space.push_back(graph.add_vertex(SE3(Vector3(k, k * k, 1), SO3()), 20 + k));
  }
  for (std::size_t k = 1; k < 3; ++k) {
    graph.add_edge(
        [](const auto& a, const auto& b, const auto& c) { return (c * a.inverse_times(b).vector()).eval(); },
        plane[k - 1], plane[k], offset);
    graph.add_edge(
        [](const auto& a, const auto& b, const auto& c) { return (c * a.inverse_times(b).minimal()).eval(); },
        space[k - 1], space[k], offset);
  }
  const Gauge gauge = gauge_of(graph);
  EXPECT_THAT(held_ids(gauge), ElementsAre(10, 20));
  ASSERT_THAT(gauge.components, SizeIs(1));
  EXPECT_THAT(gauge.components[0].free, SizeIs(2));
  EXPECT_THAT(gauge.components[0].moved, SizeIs(6));
}

/// Poses T_body_world that see points through a mount T_sensor_body.
struct Rig {
  Graph graph;
  std::vector<VertexHandle<SE2>> bodies;

  Rig() {
    const auto mount = graph.add_vertex(SE2(0.4, 0.1, 0.2), 0);
    for (int k = 0; k < 4; ++k) bodies.push_back(graph.add_vertex(pose(k)));
    for (int k = 0; k < 6; ++k) {
      const auto point = graph.add_vertex(Vector2(2 + std::sin(2 * k), 1 + std::cos(3 * k)));
      for (const auto& body : bodies) {
        graph.add_edge([](const auto& m, const auto& p, const auto& l) { return (m * (p * l)).eval(); },
                       mount, body, point);
      }
    }
    graph.add_edge([](const auto& m) { return m.vector(); }, mount);
  }
};

TEST(Gauge, OfARigTellsTheRolesOfItsPosesItsMountAndItsPoints) {
  Rig rig;
  const Gauge gauge = gauge_of(rig.graph);
  EXPECT_THAT(held_ids(gauge), IsEmpty());  // the prior of the mount anchors the component
  EXPECT_THAT(names_of(gauge), ElementsAre("translation and rotation"));
  EXPECT_THAT(gauge.held_directions, SizeIs(3));
  EXPECT_THAT(gauge.components[0].vertices, SizeIs(11));
  EXPECT_THAT(gauge.components[0].moved, SizeIs(10));  // all but the mount
}

/// A sighting of a point from a pose T_camera_world.
template <int kType>
struct Sighting {
  template <class P, class L>
  auto error(const P& p, const L& l) const {
    return (p * l).eval();
  }
};

TEST(Gauge, OfCamerasWithManyTypesOfEdgesNeedsOneRoleForAllCameras) {
  // Camera k and camera k + 1 share a type of edges.
  Graph graph;
  std::vector<VertexHandle<SE2>> cameras;
  for (int k = 0; k < 6; ++k) cameras.push_back(graph.add_vertex(pose(k)));
  const auto add = [&]<int kType>(std::integral_constant<int, kType>) {
    for (int k = 0; k < 3; ++k) {
      const auto point = graph.add_vertex(Vector2(place(k) + Vector2(kType, 1)));
      graph.add_edge(Sighting<kType>{}, cameras[kType], point);
      graph.add_edge(Sighting<kType>{}, cameras[kType + 1], point);
    }
  };
  [&]<int... kType>(std::integer_sequence<int, kType...>) {
    (add(std::integral_constant<int, kType>{}), ...);
  }
  (std::make_integer_sequence<int, 5>{});
  EXPECT_THAT(held_ids(gauge_of(graph)), ElementsAre(0));
}

/// The distances between the positions of any number of cameras T_camera_world, and their headings.
struct Formation {
  int count;
  int error_dimension() const { return 3 * (count - 1); }
  template <class S>
  Eigen::Matrix<S, Eigen::Dynamic, 1> error(std::span<const BasicSE2<S>> cameras) const {
    Eigen::Matrix<S, Eigen::Dynamic, 1> error(error_dimension());
    for (int k = 1; k < count; ++k)
      error.template segment<3>(3 * (k - 1)) =
          (cameras[0] * cameras[static_cast<std::size_t>(k)].inverse()).vector();
    return error;
  }
};

TEST(Gauge, OfCamerasInOneEdgeOfRunTimeSizeNeedsOneRoleForAllPositions) {
  Graph graph;
  std::vector<VertexHandle<SE2>> cameras;
  for (int k = 0; k < 6; ++k) cameras.push_back(graph.add_vertex(pose(k)));
  graph.add_edge(Formation{6}, cameras);
  EXPECT_THAT(held_ids(gauge_of(graph)), ElementsAre(0));
}

std::atomic<int> evaluations{0};

template <int kType>
struct CountedMotion {
  Vector3 error(const SE2& a, const SE2& b) const {
    ++evaluations;
    return a.inverse_times(b).vector();
  }
};

SimilarityCamera similarity(int k) {
  Vector<double, 7> logarithm;
  logarithm << 0.3 * k, std::sin(k), 0.1, std::cos(2 * k), k, std::sin(3 * k), 0.2 * std::cos(k);
  return {LoggedSim3(logarithm)};
}

TEST(Gauge, OfAChainOfSimilaritiesContainsTheScale) {
  Graph graph;
  std::vector<VertexHandle<SimilarityCamera>> cameras;
  for (int k = 0; k < 5; ++k) {
    cameras.push_back(graph.add_vertex(similarity(k)));
    if (k > 0) graph.add_edge(SimilarityBetween(similarity(7 + k).similarity), cameras[k - 1], cameras[k]);
  }
  const Gauge all = gauge_of(graph, GaugePolicy::kError);
  ASSERT_THAT(names_of(all), ElementsAre("translation, rotation and scale"));
  EXPECT_EQ(all.freedoms[0].directions, 7);
  EXPECT_THAT(held_ids(gauge_of(graph)), ElementsAre(0));

  // The pixel of a point at a known place determines two of the seven directions.
  const auto point = graph.add_vertex(Vector3(0, 0, 9));
  graph.fix(point);
  graph.add_edge(SimilarityImage({0.1, 0.2}), point, cameras[0]);
  const Gauge rest = gauge_of(graph);
  ASSERT_THAT(rest.freedoms, SizeIs(1));
  EXPECT_EQ(rest.freedoms[0].directions, 5);
  EXPECT_TRUE(rest.freedoms[0].scale);
  EXPECT_THAT(rest.held, IsEmpty());
  EXPECT_THAT(rest.held_directions, SizeIs(5));
}

TEST(Gauge, OfManyKindsOfPosesIsFoundWithoutTryingAllCombinationsOfRoles) {
  Graph graph;
  std::vector<VertexHandle<SE2>> poses{graph.add_vertex(pose(0))};
  const auto add = [&]<int kType>(std::integral_constant<int, kType>) {
    poses.push_back(graph.add_vertex(pose(kType + 1)));
    graph.add_edge(CountedMotion<kType>{}, poses[kType], poses[kType + 1]);
  };
  [&]<int... kType>(std::integer_sequence<int, kType...>) {
    (add(std::integral_constant<int, kType>{}), ...);
  }
  (std::make_integer_sequence<int, 8>{});
  evaluations = 0;
  EXPECT_THAT(held_ids(gauge_of(graph)), ElementsAre(0));
  EXPECT_LT(evaluations, 10000);
}

TEST(Gauge, OfMapsThatShareAnUnknownSensorPoseIsThatOfEachMap) {
  Graph graph;
  const auto sensor = graph.add_vertex(SE2(0.2, 0.1, 0.3), 1000);
  for (const int first : {0, 100}) {
    std::vector<VertexHandle<SE2>> poses;
    for (int k = 0; k < 10; ++k) poses.push_back(graph.add_vertex(pose(k), first + k));
    for (std::size_t k = 1; k < poses.size(); ++k) {
      graph.add_edge([](const auto& a, const auto& b,
                        const auto& s) { return (a * s).inverse_times(b * s).vector().eval(); },
                     poses[k - 1], poses[k], sensor);
    }
  }
  const Gauge gauge = gauge_of(graph);
  EXPECT_THAT(free_ids(gauge), ElementsAre(0, 100));
  EXPECT_THAT(gauge.held_directions, SizeIs(6));
  ASSERT_THAT(gauge.components, SizeIs(2));
  EXPECT_EQ(gauge.components[0].vertices.size() + gauge.components[1].vertices.size(), 21u);
  // If one of the maps is anchored, the other one is still free.
  graph.fix(*graph.find_vertex(3));
  EXPECT_THAT(free_ids(gauge_of(graph)), ElementsAre(100));
}

TEST(Gauge, OfMapsIsReleasedIfTheirSharedVertexMakesEdgesResist) {
  // Drifting boats: their headings matter only once the current differs from zero, which is the first guess.
  Graph graph;
  const auto current = graph.add_vertex(Vector2(0, 0), 1000);
  for (const int first : {0, 100}) {
    std::vector<VertexHandle<SE2>> poses;
    for (int k = 0; k < 10; ++k) poses.push_back(graph.add_vertex(pose(k), first + k));
    for (std::size_t k = 1; k < poses.size(); ++k) {
      const SE2 a = pose(static_cast<int>(k) - 1), b = pose(static_cast<int>(k));
      const Vector2 moved = a.inverse_times(b).translation() - a.rotation().transpose() * Vector2(0.2, 0.1);
      const Vector3 z(moved[0], moved[1], a.inverse_times(b).theta());
      graph.add_edge(
          [z](const auto& p, const auto& q, const auto& w) {
            const auto motion = p.inverse_times(q);
            const auto through_water = (motion.translation() - p.rotation().transpose() * w).eval();
            auto error = motion.vector().eval();
            error.template head<2>() = through_water;
            return (error - z).eval();
          },
          poses[k - 1], poses[k], current);
    }
  }
  for (const GaugePolicy gauge : {GaugePolicy::kFixFirst, GaugePolicy::kDamp}) {
    Graph copy = graph;
    const Report report = optimize(copy, {.gauge = gauge});
    EXPECT_TRUE(report.converged()) << report;
    EXPECT_LT(report.chi2_final, 1e-9) << report;
  }
}

TEST(Gauge, OfMapsThatShareBeaconsIsThatOfAllOfThem) {
  Graph graph;
  std::vector<VertexHandle<Vector2>> beacons;
  for (int i = 0; i < 3; ++i) beacons.push_back(graph.add_vertex(Vector2(1, 2), 1000 + i));
  for (int map = 0; map < 5; ++map) {
    std::vector<VertexHandle<SE2>> poses;
    for (int k = 0; k < 6; ++k) {
      poses.push_back(graph.add_vertex(pose(k + map), 100 * map + k));
      if (k > 0) graph.add_edge(Between(SE2()), poses[poses.size() - 2], poses.back());
      for (const auto& beacon : beacons) graph.add_edge(Range(1), poses.back(), beacon);
    }
  }
  const Gauge gauge = gauge_of(graph);
  EXPECT_THAT(held_ids(gauge), SizeIs(1));
  EXPECT_THAT(gauge.components, SizeIs(1));
}

TEST(Gauge, OfScenesThatShareAnUnknownFocalLengthIsThatOfEachScene) {
  Graph graph;
  const auto focal = graph.add_vertex(1.5, 1000);
  for (const int first : {0, 100}) {
    std::vector<VertexHandle<SE2>> cameras;
    for (int k = 0; k < 5; ++k) cameras.push_back(graph.add_vertex(pose(k), first + k));
    for (int k = 0; k < 9; ++k) {
      const auto point =
          graph.add_vertex(Vector2(20 + 3 * std::sin(2 * k), 30 + std::cos(3 * k)), first + 50 + k);
      for (const auto& camera : cameras) {
        graph.add_edge(
            [](const auto& p, const auto& l, const auto& f) {
              const auto y = p.inverse_times(l).eval();
              return f * y[0] / y[1];
            },
            camera, point, focal);
      }
    }
  }
  const Gauge gauge = gauge_of(graph);
  EXPECT_THAT(free_ids(gauge), ElementsAre(0, 100));
  EXPECT_THAT(names_of(gauge),
              ElementsAre("translation, rotation and scale", "translation, rotation and scale"));
  EXPECT_THAT(gauge.held_directions, SizeIs(8));
}

/// The motions of poses in space are measured, and their distances from four points, of which two are fixed.
TEST(Gauge, IsARotationIfDistancesFromTwoFixedPointsAreMeasured) {
  Graph graph;
  std::vector<VertexHandle<SE3>> poses;
  const auto pose_in_space = [](int k) {
    return SE3(Vector3(std::cos(2 * k), std::sin(3 * k), 0.3 * k),
               SO3::from_rotation_vector(Vector3(0.1 * k, -0.2, 0.3 * std::sin(k))));
  };
  for (int k = 0; k < 8; ++k) poses.push_back(graph.add_vertex(pose_in_space(k)));
  for (const std::size_t step : {1u, 3u}) {
    for (std::size_t k = step; k < poses.size(); ++k)
      graph.add_edge(Between(SE3()), poses[k - step], poses[k]);
  }
  for (int i = 0; i < 4; ++i) {
    const auto point = graph.add_vertex(Vector3(3 * std::sin(i + 1), 2 * std::cos(2 * i), i - 1.5));
    if (i < 2) graph.fix(point);
    for (const auto& pose : poses) graph.add_edge(Range(1), pose, point);
  }
  EXPECT_THAT(names_of(gauge_of(graph)), ElementsAre("rotation"));
}

TEST(Gauge, DoesNotCountRowsWhoseInformationIsZero) {
  Graph graph;
  const auto a = graph.add_vertex(SE2(0, 0, 0.1)), b = graph.add_vertex(SE2(1, 0, 0));
  graph.add_edge(Between(SE2(1, 0, 0)), a, b);
  const Vector3 heading(0, 0, 1);
  const EdgeRef compass =
      graph.add_edge(Prior(SE2(5, 5, 0)), Information(Eigen::Matrix3d(heading.asDiagonal())), a);
  EXPECT_THAT(names_of(gauge_of(graph)), ElementsAre("translation"));
  Optimizer optimizer(graph, {.algorithm = AlgorithmKind::kGaussNewton});
  Report report = optimizer.run();
  EXPECT_TRUE(report.converged()) << report;
  EXPECT_EQ(report.regularized_steps, 0);
  EXPECT_EQ(report.rows, 4u);
  EXPECT_EQ(report.degrees_of_freedom, 0);
  EXPECT_NEAR(graph.estimate(a).x(), 0, 1e-3);
  // The same optimizer notices when these rows count.
  graph.set_information(compass, 1.0);
  report = optimizer.run();
  EXPECT_FALSE(report.plan_reused);
  EXPECT_EQ(report.rows, 6u);
  EXPECT_EQ(report.degrees_of_freedom, 0);
  EXPECT_NEAR(graph.estimate(a).x(), 5, 1e-9);
  // An edge without any information keeps its place, as a disabled one does.
  graph.set_information(compass, 0.0);
  EXPECT_TRUE(optimizer.run().plan_reused);
}

/// Cameras see points with intrinsics f of a unit u: the error is f₀ u p⁻¹ l. One camera is fixed.
template <class Handle>
void add_cameras(Graph& graph, Handle f, double unit) {
  std::vector<VertexHandle<Vector2>> points;
  for (int k = 0; k < 6; ++k)
    points.push_back(graph.add_vertex(Vector2(2 + std::sin(2 * k), 1 + std::cos(3 * k))));
  for (int k = 0; k < 4; ++k) {
    const auto camera = graph.add_vertex(pose(k));
    if (k == 0) graph.fix(camera);
    for (const auto& point : points) {
      graph.add_edge([unit](const auto& p, const auto& l,
                            const auto& c) { return (c[0] * unit * p.inverse_times(l)).eval(); },
                     camera, point, f);
    }
  }
}

TEST(Gauge, OfAScaleThatIsFreeTogetherWithAFocalLengthIsFoundInAnyUnit) {
  for (const double unit : {1.0, 1e-8}) {
    Graph graph;
    const auto f = graph.add_vertex(Vector<double, 4>(1.2 / unit, 0, 0, 0));
    add_cameras(graph, f, unit);
    EXPECT_THAT(names_of(gauge_of(graph)), ElementsAre("scale")) << unit;
    graph.fix_directions(f, {0});
    EXPECT_THAT(names_of(gauge_of(graph)), IsEmpty()) << unit;
  }
}

TEST(Gauge, OfAScaleIsNotFreeIfTheFocalLengthIsAFixedDirectionOfAParameter) {
  Graph graph;
  const auto f = graph.add_parameter(Vector<double, 4>(1.2, 0, 0, 0));
  graph.unfix(f);
  add_cameras(graph, f, 1);
  EXPECT_THAT(names_of(gauge_of(graph)), ElementsAre("scale"));
  graph.fix_directions(f, {0});
  EXPECT_THAT(names_of(gauge_of(graph)), IsEmpty());
}

TEST(Gauge, OfPointsThatOnlyAFocalLengthConnectsIsNotFree) {
  // Each point has as many errors as coordinates, but all of them together determine the focal length.
  Graph graph;
  const auto f = graph.add_parameter(1.2);
  graph.unfix(f);
  std::vector<VertexHandle<SE2>> cameras;
  for (int k = 0; k < 2; ++k) cameras.push_back(graph.add_vertex(pose(k)));
  for (const auto& camera : cameras) graph.fix(camera);
  const auto add_points = [&](int count) {
    for (int k = 0; k < count; ++k) {
      const auto point = graph.add_vertex(Vector2(2 + std::sin(2 * k), 3 + std::cos(3 * k)));
      for (const auto& camera : cameras) {
        graph.add_edge(
            [](const auto& p, const auto& l, const auto& c) {
              const auto y = p.inverse_times(l).eval();
              return c * y[0] / y[1];
            },
            camera, point, f);
      }
    }
  };
  add_points(1);
  EXPECT_THAT(gauge_of(graph).freedoms, SizeIs(1));
  add_points(4);
  EXPECT_THAT(gauge_of(graph).freedoms, IsEmpty());
}

TEST(Gauge, OfATranslationThatIsFreeTogetherWithAnOffsetHoldsTheOffset) {
  // Positions are measured with an unknown offset in x.
  Graph graph;
  const auto poses = add_chain(graph, 5);
  const auto offset = graph.add_vertex(0.3, 7);
  for (int k = 0; k < 5; ++k) {
    graph.add_edge(
        [z = place(k)](const auto& x, const auto& o) {
          auto error = (x.translation() - z).eval();
          error[0] += o;
          return error;
        },
        poses[static_cast<std::size_t>(k)], offset);
  }
  EXPECT_THAT(held_ids(gauge_of(graph)), ElementsAre(7));
  const Report report = optimize(graph, {.algorithm = AlgorithmKind::kGaussNewton, .max_iterations = 3});
  EXPECT_NE(report.status, Report::Status::kFailed) << report;
  EXPECT_EQ(report.regularized_steps, 0);
}

TEST(Gauge, OfCamerasIsHeldAtOneCameraAndADirectionOfAnotherInWorldsOfAnySize) {
  for (const double size : {1.0, 1e3, 1e6}) {
    Graph graph;
    std::vector<VertexHandle<SE2>> cameras;
    for (int k = 0; k < 4; ++k)
      cameras.push_back(graph.add_vertex(SE2(size * place(k)[0], size * place(k)[1], 0.4 * k)));
    for (int k = 0; k < 6; ++k) {
      const Vector2 place(20 + 3 * std::sin(2 * k), 30 + std::cos(3 * k));
      const auto point = graph.add_vertex(Vector2(size * place));
      graph.set_eliminated(point, true);
      for (const auto& camera : cameras) {
        graph.add_edge(
            [](const auto& p, const auto& l) {
              const auto y = p.inverse_times(l).eval();
              return y[0] / y[1];
            },
            camera, point);
      }
    }
    const Gauge gauge = gauge_of(graph);
    EXPECT_THAT(held_ids(gauge), ElementsAre(0)) << size;
    ASSERT_THAT(gauge.held_directions, SizeIs(1)) << size;
    EXPECT_EQ(gauge.held_directions[0].vertex.pool, VertexRef(cameras[0]).pool) << size;
  }
}

TEST(Gauge, OfOtherTypesIsLeftToTheLargestVertexThatIsNotEliminated) {
  Graph graph;
  std::vector<VertexHandle<SO3>> rotations;
  const auto offset = graph.add_vertex(0.1, 0);
  for (int k = 0; k < 4; ++k)
    rotations.push_back(graph.add_vertex(SO3::from_rotation_vector(Vector3(0.1 * k, 0.2, 0)), 1 + k));
  graph.set_eliminated(rotations[0], true);
  for (std::size_t k = 1; k < rotations.size(); ++k) {
    graph.add_edge([](const auto& a, const auto& b,
                      const auto& o) { return (o * (a.inverse() * b).rotation_vector()).eval(); },
                   rotations[k - 1], rotations[k], offset);
  }
  const Gauge gauge = gauge_of(graph);
  ASSERT_THAT(gauge.loose, SizeIs(1));
  EXPECT_EQ(gauge.loose[0], VertexRef(rotations[1]));
}

struct Difference {
  static constexpr bool kRigid = true;
  template <class A>
  auto error(const A& a, const A& b) const {
    return b - a;
  }
};

TEST(Gauge, OfRigidEdgesBetweenTypesWithoutAFrameIsLeftToThePivots) {
  Graph graph;
  graph.add_edge(Difference{}, graph.add_vertex(1.0), graph.add_vertex(2.0));
  const Gauge gauge = gauge_of(graph);
  EXPECT_THAT(held_ids(gauge), IsEmpty());
  EXPECT_THAT(gauge.loose, SizeIs(1));
  EXPECT_EQ(optimize(graph).gauge.held_directions, 1);
}

struct CountedPrior {
  static constexpr bool kRigid = true;
  Vector3 error(const SE2& a) const {
    ++evaluations;
    return a.vector();
  }
};

TEST(Gauge, IsNotSearchedIfAllEdgesAreRigidAndOneMeasuresAWholePose) {
  // There may be many such components.
  Graph graph;
  const auto a = graph.add_vertex(pose(0)), b = graph.add_vertex(pose(1));
  graph.add_edge(Between(SE2()), a, b);
  graph.add_edge(CountedPrior{}, b);
  evaluations = 0;
  EXPECT_THAT(gauge_of(graph).freedoms, IsEmpty());
  EXPECT_EQ(evaluations, 0);
}

TEST(Gauge, ListsFreeTranslationsAlongCoordinateAxesIfItCan) {
  // Differences of positions are measured, and one height.
  Graph graph;
  const auto a = graph.add_vertex(Vector3(0, 0, 0)), b = graph.add_vertex(Vector3(1, 2, 3));
  const auto c = graph.add_vertex(Vector3(-1, 0.5, 2));
  for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c)})
    graph.add_edge([](const auto& x, const auto& y) { return (y - x).eval(); }, from, to);
  graph.add_edge([](const auto& x) { return x[2]; }, a);
  const Gauge gauge = gauge_of(graph);
  ASSERT_THAT(gauge.components[0].free, SizeIs(1));
  EXPECT_THAT(gauge.components[0].free[0].along,
              ElementsAre(FreeMotions::Axis{1, 0, 0}, FreeMotions::Axis{0, 1, 0}));
}

std::atomic<bool> stop{false};
std::atomic<int> evaluations_after_stop{0};

struct StoppingMotion {
  Vector2 error(const Vector2& a, const Vector2& b) const {
    stop = true;
    ++evaluations_after_stop;
    return b - a;
  }
};

TEST(Gauge, IsNotSearchedOnceAStopIsRequested) {
  Graph rigid, other;
  std::vector<VertexHandle<SE2>> poses;
  std::vector<VertexHandle<Vector2>> points;
  for (int k = 0; k < 3000; ++k) {
    poses.push_back(rigid.add_vertex(SE2()));
    points.push_back(other.add_vertex(place(k)));
    if (k == 0) continue;
    rigid.add_edge(Between(SE2()), poses[poses.size() - 2], poses.back());
    other.add_edge(StoppingMotion{}, points[points.size() - 2], points.back());
  }
  const StopToken token(&stop);
  evaluations_after_stop = 0;
  EXPECT_THROW(gauge_of(other, GaugePolicy::kError, token), Stopped);
  EXPECT_LT(evaluations_after_stop, 2000);
  const std::vector<std::vector<std::uint8_t>> movable{std::vector<std::uint8_t>(poses.size(), 1)};
  EXPECT_THROW(find_gauge(rigid, find_active_set(rigid, {}).edges, movable, GaugePolicy::kFixFirst, token),
               Stopped);
}

/// One edge between vertices of one to three dimensions, whose motions of the plane and of space move the
/// same vertex.
TEST(Gauge, OfVerticesOfSeveralDimensionsHoldsNoVertexTwice) {
  std::mt19937 random(1);
  std::uniform_int_distribution<int> entry(-2, 2);
  const auto coefficient = [&] { return static_cast<double>(entry(random)); };
  for (int trial = 0; trial < 200; ++trial) {
    Graph graph;
    const auto a = graph.add_vertex(Vector<double, 1>(-1.0));
    const auto p = graph.add_vertex(Vector2(0, -3));
    const auto q = graph.add_vertex(Vector3(4, -6, -4)), r = graph.add_vertex(Vector3(2, 3, -3));
    Eigen::Matrix<double, 2, 9> A;
    for (double& value : A.reshaped()) value = coefficient();
    graph.add_edge(
        [A](const auto& w, const auto& x, const auto& y, const auto& z) {
          using S = std::decay_t<decltype(x[0])>;
          Vector<S, 2> error;
          for (int i = 0; i < 2; ++i) {
            error[i] = A(i, 0) * w[0] + A(i, 1) * x[0] + A(i, 2) * x[1];
            for (int k = 0; k < 3; ++k) error[i] += A(i, 3 + k) * y[k] + A(i, 6 + k) * z[k];
          }
          return error;
        },
        a, p, q, r);
    const Report report = optimize(graph);
    EXPECT_TRUE(report.converged()) << report;
    EXPECT_LT(report.chi2_final, 1e-12) << report;
  }
}

}  // namespace
}  // namespace boxplus
