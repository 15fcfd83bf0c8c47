// SPDX-License-Identifier: BSD-3-Clause
// Graphs with gauge freedom, and the policies of GaugePolicy. optimize() holds a vertex if it keeps the
// vertex at its estimate although the user did not fix it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "boxplus/manifold/sim3.h"
#include "linear/every_solver.h"
#include "optimize/small_graphs.h"
#include "optimize/table_entries.h"

namespace boxplus {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(Gauge, HoldsTheVertexWithTheLowestIdWithoutChangingItsEstimateOrFlag) {
  Graph graph;
  const auto poses = add_noisy_circle(graph, 20);
  const SE2 before = graph.estimate(poses[0]);
  const Report report = optimize(graph);
  EXPECT_TRUE(report.converged()) << report;
  EXPECT_THAT(report.gauge.held, ElementsAre(0));
  EXPECT_EQ(graph.estimate(poses[0]).vector(), before.vector());
  EXPECT_FALSE(graph.is_fixed(poses[0]));
}

TEST(Gauge, HoldsOneVertexPerComponent) {
  Graph graph;
  add_noisy_circle(graph, 12, 1);
  add_noisy_circle(graph, 12, 2);
  const Report report = optimize(graph);
  EXPECT_TRUE(report.converged()) << report;
  EXPECT_THAT(report.gauge.held, ElementsAre(0, 12));
}

TEST(Gauge, HoldsNothingIfAVertexIsFixedOrHasAPrior) {
  Graph fixed;
  fixed.fix(add_noisy_circle(fixed, 12)[5]);
  EXPECT_THAT(optimize(fixed).gauge.held, IsEmpty());
  Graph prior;
  prior.add_edge(Prior(SE2(0, 0, 0)), add_noisy_circle(prior, 12)[5]);
  const Report report = optimize(prior);
  EXPECT_TRUE(report.converged()) << report;
  EXPECT_THAT(report.gauge.held, IsEmpty());
}

TEST(Gauge, HoldsAVertexOfTheLargestDimension) {
  Graph graph;
  const auto landmark = graph.add_vertex(Vector2(1, 1));
  const auto pose = graph.add_vertex(SE2());
  graph.add_edge(PointObservation2(Vector2(1, 1)), pose, landmark);
  EXPECT_THAT(optimize(graph).gauge.held, ElementsAre(1));
}

TEST(Gauge, HoldsOnlyTheMotionThatAPositionPriorLeavesFree) {
  // One measured position leaves the rotation free. If a whole pose were held, the circle would bend towards
  // the measurement.
  Graph graph;
  const auto poses = add_noisy_circle(graph, 20);
  Graph reference;
  add_noisy_circle(reference, 20);
  graph.add_edge(PositionPrior(Vector2(10, -3)), 1e4, poses[7]);
  const Report report = optimize(graph);
  EXPECT_TRUE(report.converged()) << report;
  ASSERT_EQ(report.gauge.free.size(), 1u);
  EXPECT_EQ(to_string(report.gauge.free[0]), "rotation");
  EXPECT_THAT(report.gauge.held, IsEmpty());
  EXPECT_NEAR(report.chi2_final, optimize(reference).chi2_final, 1e-6);
  EXPECT_NEAR(graph.estimate(poses[7]).x(), 10, 1e-5);
}

TEST(Gauge, IsDampedUnderThePolicyDampWithTheSameFinalChi2) {
  Graph held, damped;
  add_noisy_circle(held, 20);
  add_noisy_circle(damped, 20);
  Options options;
  options.gauge = GaugePolicy::kDamp;
  const Report report = optimize(damped, options);
  EXPECT_TRUE(report.converged()) << report;
  EXPECT_THAT(report.gauge.held, IsEmpty());
  EXPECT_NEAR(report.chi2_final, optimize(held).chi2_final, 1e-9);
}

TEST(Gauge, FreedomIsAnErrorUnderThePolicyError) {
  Graph graph;
  add_noisy_circle(graph, 20);
  Options options;
  options.gauge = GaugePolicy::kError;
  const double before = graph.chi2();
  const Report report = optimize(graph, options);
  EXPECT_EQ(report.status, Report::Status::kFailed);
  EXPECT_EQ(report.reason, Report::Reason::kGaugeFreedom);
  EXPECT_EQ(graph.chi2(), before);
}

/// y = a exp(b t) with the vertices a and b. Without any prior or fixed vertex, the edges determine both.
std::pair<VertexHandle<Vector<double, 1>>, VertexHandle<Vector<double, 1>>> add_exponential(Graph& graph) {
  const auto a = graph.add_vertex(Vector<double, 1>(1.0));
  const auto b = graph.add_vertex(Vector<double, 1>(0.0));
  for (int i = 0; i < 20; ++i) {
    const double t = i / 10.0, y = 2.5 * std::exp(-0.7 * t);
    graph.add_edge([t, y](const auto& x, const auto& z) { return x[0] * exp(z[0] * t) - y; }, a, b);
  }
  return {a, b};
}

TEST(Gauge, HoldsNothingIfTheEdgesDetermineAllVerticesWithoutPriorsOrFixedVertices) {
  Graph graph;
  const auto [a, b] = add_exponential(graph);
  const Report report = optimize(graph);
  EXPECT_TRUE(report.converged()) << report;
  EXPECT_THAT(report.gauge.held, IsEmpty());
  EXPECT_EQ(report.gauge.held_directions, 0);
  EXPECT_LE(report.iterations, 10) << report;
  EXPECT_NEAR(graph.estimate(a)[0], 2.5, 1e-8);
  EXPECT_NEAR(graph.estimate(b)[0], -0.7, 1e-8);
  const Report error = optimize(graph, {.gauge = GaugePolicy::kError});
  EXPECT_NE(error.reason, Report::Reason::kGaugeFreedom);
}

/// Rotations that are measured relative to each other. All of them may rotate together. The search for free
/// motions does not find this freedom, because it knows only poses and points.
std::vector<VertexHandle<SO3>> add_rotations(Graph& graph, int count) {
  std::vector<VertexHandle<SO3>> rotations;
  for (int i = 0; i < count; ++i)
    rotations.push_back(graph.add_vertex(SO3::from_rotation_vector(Vector3(0.1 * i, 0.2, 0.05 * i * i))));
  for (int i = 0; i < count; ++i) {
    graph.add_edge(Between(SO3::from_rotation_vector(Vector3(0.12, 0.01 * i, -0.1))),
                   rotations[static_cast<std::size_t>(i)],
                   rotations[static_cast<std::size_t>((i + 1) % count)]);
  }
  return rotations;
}

TEST(Gauge, HoldsTheFirstVertexIfItsTypeIsNeitherAPoseNorAPoint) {
  for (const auto algorithm : {AlgorithmKind::kGaussNewton, AlgorithmKind::kDogleg}) {
    for (const LinearSolverKind solver : every_direct_solver()) {
      Graph graph;
      const auto rotations = add_rotations(graph, 12);
      const SO3 before = graph.estimate(rotations[0]);
      const Report report = optimize(graph, {.algorithm = algorithm, .linear_solver = solver});
      EXPECT_TRUE(report.converged()) << report;
      EXPECT_EQ(report.gauge.held_directions, 3);
      EXPECT_EQ(report.regularized_steps, 0);
      EXPECT_TRUE(graph.estimate(rotations[0]).rotation() == before.rotation());
    }
  }
}

TEST(Gauge, FreedomOfTypesThatAreNeitherPosesNorPointsIsAnErrorUnderThePolicyError) {
  Graph graph;
  add_rotations(graph, 12);
  EXPECT_EQ(optimize(graph, {.gauge = GaugePolicy::kError}).reason, Report::Reason::kGaugeFreedom);
}

TEST(Gauge, FreedomOfTypesThatAreNeitherPosesNorPointsIsFoundEvenIfOneDirectionIsMeasured) {
  // Similarities in a loop. Only one scale is measured, so six directions are free.
  const auto loop = [] {
    Graph graph;
    std::vector<VertexHandle<Sim3>> vertices;
    for (int k = 0; k < 5; ++k) {
      const double turn[7] = {0.3 * k, 0.1, -0.2 * k, 0.1, 0.05 * k, 0.02, 0.01 * k};
      vertices.push_back(graph.add_vertex(Manifold<Sim3>::oplus(Sim3(), turn)));
    }
    const double noise[7] = {0.02, -0.01, 0.03, 0.01, 0.02, -0.02, 0.01};
    for (std::size_t k = 0; k < 5; ++k) {
      const auto a = vertices[k], b = vertices[(k + 1) % 5];
      const Sim3 between = graph.estimate(a).inverse() * graph.estimate(b);
      graph.add_edge(Between(Manifold<Sim3>::oplus(between, noise)), 100.0, a, b);
    }
    graph.add_edge([](const auto& x) { return log(x.scale()) - 0.3; }, vertices[2]);
    return graph;
  };
  Graph free = loop(), damped = loop(), anchored = loop();
  EXPECT_EQ(optimize(free, {.gauge = GaugePolicy::kError}).reason, Report::Reason::kGaugeFreedom);
  const Report report =
      optimize(damped, {.algorithm = AlgorithmKind::kGaussNewton, .gauge = GaugePolicy::kDamp});
  EXPECT_TRUE(report.converged()) << report;
  const auto first = anchored.typed<Sim3>(anchored.all_vertices()[0]);
  anchored.add_edge(Prior(anchored.estimate(first)), first);
  EXPECT_TRUE(optimize(anchored, {.gauge = GaugePolicy::kError}).converged());
}

TEST(Gauge, DampingOfEachDirectionIsRelativeToItsOwnDiagonalEntry) {
  // The weights of the first two directions differ by a factor of 1e7, and nothing measures the third
  // direction.
  for (const auto gauge : {GaugePolicy::kFixFirst, GaugePolicy::kDamp}) {
    Graph graph;
    const auto x = graph.add_vertex(Vector3(0, 0, 0));
    graph.add_edge([](const auto& p) { return p[0] - 1.0; }, 1e4, x);
    graph.add_edge([](const auto& p) { return p[1] - 5.0; }, 1e-3, x);
    const Report report = optimize(graph, {.gauge = gauge});
    EXPECT_TRUE(report.converged()) << report;
    EXPECT_LE(report.iterations, 3) << report;
    EXPECT_NEAR(graph.estimate(x)[1], 5, 1e-6);
  }
}

TEST(Gauge, IsNoLongerHeldWhenAMotionThatWasFreeAtTheStartIsMeasured) {
  // At the start, both poses have the same position, so nothing measures their heading.
  for (const AlgorithmKind algorithm : every_algorithm()) {
    Graph graph;
    const auto a = graph.add_vertex(SE2()), b = graph.add_vertex(SE2());
    graph.add_edge(Between(SE2(1, 0, 0)), a, b);
    graph.add_edge(PositionPrior(Vector2(0, 0)), a);
    graph.add_edge(PositionPrior(Vector2(0, 1)), b);
    const Report report = optimize(graph, {.algorithm = algorithm});
    EXPECT_TRUE(report.converged()) << report;
    EXPECT_LT(report.chi2_final, 1e-9) << report;
    const Report second = optimize(graph, {.algorithm = algorithm});
    EXPECT_LT(second.chi2_final, 1e-9) << second;
  }
}

/// Points of which only distances from each other are known, and from a fixed one if `anchored`. They start
/// up to `noise` away from points at these distances.
template <int kDim>
void add_distances(Graph& graph, int points, bool anchored, double noise, std::mt19937& random) {
  std::uniform_real_distribution<double> coordinate(-1, 1);
  const auto vector = [&] {
    Vector<double, kDim> v;
    for (int i = 0; i < kDim; ++i) v[i] = coordinate(random);
    return v;
  };
  std::vector<Vector<double, kDim>> truth(1, Vector<double, kDim>::Zero());
  for (int k = 1; k < points; ++k) truth.push_back(vector());
  std::vector<VertexHandle<Vector<double, kDim>>> vertices;
  for (const auto& point : truth) vertices.push_back(graph.add_vertex((point + noise * vector()).eval()));
  if (anchored) graph.set_estimate(vertices[0], truth[0]);
  graph.set_fixed(vertices[0], anchored);
  for (std::size_t i = 0; i < truth.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const double distance = (truth[i] - truth[j]).norm();
      graph.add_edge([distance](const auto& a, const auto& b) { return (b - a).norm() - distance; },
                     vertices[j], vertices[i]);
    }
  }
}

TEST(Gauge, DirectionsThatAreHeldAtTheStartMayBeNeededLater) {
  for (const auto algorithm :
       {AlgorithmKind::kGaussNewton, AlgorithmKind::kDogleg, AlgorithmKind::kLevenbergMarquardt}) {
    for (const Vector2& start :
         {Vector2(1.3, 1.1), Vector2(-1.3, 1.1), Vector2(0.5, 0.3), Vector2(0.01, 2)}) {
      Graph graph;
      const auto anchor = graph.add_vertex(SE2());
      graph.fix(anchor);
      const auto point = graph.add_vertex(start);
      graph.add_edge(Range(0.44), anchor, point);
      const Report report = optimize(graph, {.algorithm = algorithm});
      EXPECT_TRUE(report.converged()) << report;
      EXPECT_LT(report.chi2_final, 1e-20) << start.transpose();
      EXPECT_LE(report.iterations, 30) << report;
    }
  }
}

TEST(Gauge, OfPointsAtKnownDistancesDelaysNoTrustRegion) {
  std::mt19937 random(7);
  for (int problem = 0; problem < 200; ++problem) {
    Graph plane, space;
    add_distances<2>(plane, 2 + problem % 4, problem % 3 == 0, 0.3, random);
    add_distances<3>(space, 2 + problem % 4, problem % 3 == 0, 0.3, random);
    for (Graph* graph : {&plane, &space}) {
      const Report report = optimize(*graph, {.algorithm = AlgorithmKind::kDogleg});
      EXPECT_TRUE(report.converged()) << problem << report;
      EXPECT_LE(report.iterations, 30) << problem;
    }
  }
}

TEST(Gauge, OfAStraightTrajectoryWithPositionPriorsIsNoLongerHeldWhenTheTrajectoryBends) {
  for (const auto algorithm : {AlgorithmKind::kGaussNewton, AlgorithmKind::kDogleg}) {
    Graph graph;
    std::vector<VertexHandle<SE3>> poses;
    for (int i = 0; i < 4; ++i) poses.push_back(graph.add_vertex(SE3(Vector3(i, 0, 0), SO3())));
    const SO3 turn = SO3::from_rotation_vector(Vector3(0, 0, std::acos(-1.0) / 2));
    graph.add_edge(Between(SE3(Vector3(1, 0, 0), SO3())), poses[0], poses[1]);
    graph.add_edge(Between(SE3(Vector3(1, 0, 0), turn)), poses[1], poses[2]);
    graph.add_edge(Between(SE3(Vector3(1, 0, 0), SO3())), poses[2], poses[3]);
    const std::vector<Vector3> places{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 0, 1}};
    for (std::size_t i = 0; i < poses.size(); ++i) graph.add_edge(PositionPrior(places[i]), poses[i]);
    const Report report = optimize(graph, {.algorithm = algorithm});
    EXPECT_LT(report.chi2_final, 1e-8) << report;
  }
}

/// Measures the motion from a to b or, if `anchored`, the position of b.
struct MotionOrPosition {
  Vector2 measurement;
  bool anchored;
  template <class P>
  P error(const P& a, const P& b) const {
    return anchored ? P(b - measurement) : P(b - a - measurement);
  }
};

TEST(Gauge, IsNotHeldIfOneOfManyEdgesOfATypeMeasuresIt) {
  constexpr int kPoints = 3000;
  for (const bool one_direction : {false, true}) {
    for (const int anchor : {1, 1234, 2998}) {
      // A spiral of points. Edges measure the motion from each point to the next, and one edge measures a
      // position.
      Graph graph;
      std::vector<VertexHandle<Vector2>> points;
      const auto at = [](int k) {
        return Vector2(0.01 * k * std::cos(0.1 * k), 0.01 * k * std::sin(0.1 * k));
      };
      const Vector2 shift(one_direction ? 0 : 5, -3);
      for (int k = 0; k < kPoints; ++k) points.push_back(graph.add_vertex(at(k)));
      if (one_direction) graph.fix_directions(points[0], std::vector{0});
      for (int k = 0; k + 1 < kPoints; ++k) {
        graph.add_edge(MotionOrPosition{at(k + 1) - at(k), false}, points[k], points[k + 1]);
        if (k == anchor) graph.add_edge(MotionOrPosition{at(k + 1) + shift, true}, points[k], points[k + 1]);
      }
      const Report report = optimize(graph);
      EXPECT_TRUE(report.converged()) << report;
      EXPECT_LE((graph.estimate(points[0]) - at(0) - shift).norm(), 1e-6) << one_direction << anchor;
    }
  }
}

TEST(Gauge, HoldsAPoseAndNotTheSensorMountEvenIfTheMountHasALowerId) {
  Graph graph;
  const auto mount = graph.add_vertex(SE2(0.4, 0.1, 0.2), 0);
  const SE2 motion(1, 0, 1.5707963), seen = SE2(0.3, 0.2, 0.1).inverse() * motion * SE2(0.3, 0.2, 0.1);
  std::vector<VertexHandle<SE2>> poses{graph.add_vertex(SE2(), 1)};
  for (int i = 0; i < 2; ++i) {
    poses.push_back(graph.add_vertex(graph.estimate(poses.back()) * motion));
    const auto from = poses[poses.size() - 2], to = poses.back();
    graph.add_edge(Between(motion), 100.0, from, to);
    graph.add_edge(
        [seen](const auto& a, const auto& b, const auto& m) {
          return (a * m).inverse_times(b * m).inverse_times(seen).vector();
        },
        100.0, from, to, mount);
  }
  const Report report = optimize(graph);
  EXPECT_THAT(report.gauge.held, ElementsAre(1)) << report;
  EXPECT_LT(report.chi2_final, 1e-9) << report;
}

TEST(Gauge, FreedomIsShownInTheReport) {
  Graph graph;
  const auto poses = add_noisy_circle(graph, 20);
  graph.add_edge(PositionPrior(Vector2(10, -3)), 1e4, poses[7]);
  EXPECT_THAT(to_string(optimize(graph)),
              testing::HasSubstr("gauge           rotation free in the component of vertex 0"));
}

TEST(Gauge, StaysHeldIfDampingOrTheTrustRegionShortensEveryStep) {
  for (const Options& options :
       {Options{.algorithm = AlgorithmKind::kLevenbergMarquardt, .max_iterations = 3, .initial_lambda = 1e15},
        Options{.algorithm = AlgorithmKind::kDogleg, .max_iterations = 3, .initial_radius = 1e-15}}) {
    Graph graph;
    add_noisy_circle(graph, 20);
    const Report report = optimize(graph, options);
    EXPECT_EQ(report.status, Report::Status::kNotConverged) << report;
    EXPECT_THAT(report.gauge.held, ElementsAre(0));
  }
}

TEST(Gauge, StaysHeldIfTheDataFitPerfectly) {
  // In this case, chi2 and the gradient of the held vertex consist of rounding errors.
  for (const AlgorithmKind algorithm : every_algorithm()) {
    Graph graph;
    std::vector<VertexHandle<SE2>> poses{graph.add_vertex(SE2(100, -50, 1))};
    for (int i = 1; i < 6; ++i) {
      poses.push_back(graph.add_vertex(SE2(100 + i, -50, 0.9)));
      graph.add_edge(Between(SE2(1, 0, 0.3)), poses[poses.size() - 2], poses.back());
    }
    for (int run = 0; run < 4; ++run) {
      const Report report = optimize(graph, {.algorithm = algorithm});
      EXPECT_TRUE(report.converged()) << report;
      EXPECT_THAT(report.gauge.held, ElementsAre(0)) << report;
      EXPECT_LT(report.chi2_final, 1e-20);
      EXPECT_EQ(graph.estimate(poses[0]).vector(), SE2(100, -50, 1).vector());
      graph.set_estimate(poses[3], SE2(103, -48, 1.5));
    }
  }
}

/// Cameras that see points with one focal length f: the error is f p⁻¹ l − z. One camera is fixed, so only
/// the scale is free, and only together with f.
struct FocalLength {
  Graph graph;
  VertexRef focal_length;
  std::vector<VertexHandle<Vector2>> points;

  explicit FocalLength(bool is_parameter = false) { add(is_parameter); }

  void add(bool is_parameter) {
    if (is_parameter) {
      const auto focal = graph.add_parameter(1.2);
      graph.unfix(focal);
      add_edges(focal);
    } else {
      add_edges(graph.add_vertex(1.2));
    }
  }
  template <class Focal>
  void add_edges(Focal focal) {
    focal_length = focal;
    std::vector<VertexHandle<SE2>> cameras;
    for (int k = 0; k < 4; ++k) cameras.push_back(graph.add_vertex(SE2(k, 0.3 * k * k, 0.2 * k)));
    graph.fix(cameras[0]);
    for (int k = 0; k < 6; ++k) {
      const Vector2 truth(2 + std::sin(2 * k), 1 + std::cos(3 * k));
      points.push_back(graph.add_vertex(Vector2(truth + Vector2(0.05, 0.02 * k))));
      for (const auto& camera : cameras) {
        const Vector2 z = graph.estimate(camera).inverse_times(truth);
        graph.add_edge(
            [z](const auto& p, const auto& l, const auto& f) { return (f * p.inverse_times(l) - z).eval(); },
            camera, points.back(), focal);
      }
    }
  }
};

TEST(Gauge, OfAScaleThatIsFreeTogetherWithAFocalLengthIsNamedUnderEveryPolicy) {
  for (const bool is_parameter : {false, true}) {
    for (const auto gauge : {GaugePolicy::kFixFirst, GaugePolicy::kDamp, GaugePolicy::kError}) {
      FocalLength problem(is_parameter);
      const Report report = optimize(problem.graph, {.gauge = gauge});
      EXPECT_THAT(to_string(report),
                  testing::HasSubstr("gauge           scale free in the component of vertex"))
          << report;
      EXPECT_EQ(report.reason == Report::Reason::kGaugeFreedom, gauge == GaugePolicy::kError) << report;
      if (gauge != GaugePolicy::kError) {
        EXPECT_TRUE(report.converged()) << report;
        EXPECT_LT(report.chi2_final, 1e-15) << report;
      }
    }
  }
}

TEST(Gauge, OfAScaleThatIsFreeTogetherWithAFocalLengthHoldsTheFocalLength) {
  FocalLength problem;
  const auto f = problem.graph.typed<double>(problem.focal_length);
  const Report report = optimize(problem.graph, {.algorithm = AlgorithmKind::kGaussNewton});
  EXPECT_TRUE(report.converged()) << report;
  EXPECT_EQ(problem.graph.estimate(f), 1.2);
  EXPECT_EQ(report.regularized_steps, 0);
}

TEST(Gauge, OfScalesThatAreFreeTogetherWithFocalLengthsIsNamedForEachComponent) {
  for (const bool is_parameter : {false, true}) {
    FocalLength problem(is_parameter);
    problem.add(is_parameter);
    const Report report = optimize(problem.graph);
    EXPECT_TRUE(report.converged()) << report;
    EXPECT_EQ(report.gauge.free.size(), 2u) << report;
  }
}

TEST(Gauge, OfAScaleIsNotFreeIfTheFocalLengthIsMeasuredOrASecondPointIsKnown) {
  FocalLength measured, known;
  measured.graph.add_edge(Prior(1.0), measured.graph.typed<double>(measured.focal_length));
  known.graph.fix(known.points[0]);
  for (FocalLength* problem : {&measured, &known}) {
    const Report report = optimize(problem->graph);
    EXPECT_TRUE(report.converged()) << report;
    EXPECT_THAT(report.gauge.free, IsEmpty()) << report;
  }
}

/// Kept vertices see eliminated vertices along their entry 1. Their other entries are measured. So only a
/// shift of all entries 1 and all eliminated vertices is free.
struct FreeShift {
  double seen;
  Vector3 measured;
  template <class S>
  Vector<S, 4> error(const Vector<S, 4>& kept, const Vector<S, 1>& eliminated) const {
    return {eliminated[0] - kept[1] - seen, kept[0] - measured[0], kept[2] - measured[1],
            kept[3] - measured[2]};
  }
};

TEST(Gauge, HoldsNoMeasuredDirectionWhateverTheSolverEliminatesLast) {
  for (const detail::LinearSolverEntry& solver : every_solver()) {
    if (solver.method == detail::LinearSolverEntry::Method::kIterative) continue;
    for (const AlgorithmKind algorithm :
         {AlgorithmKind::kGaussNewton, AlgorithmKind::kLevenbergMarquardt, AlgorithmKind::kDogleg}) {
      SCOPED_TRACE(std::string(solver.name) + " " + std::to_string(static_cast<int>(algorithm)));
      Graph graph;
      std::vector<VertexHandle<Vector<double, 4>>> kept;
      for (int i = 0; i < 3; ++i)
        kept.push_back(graph.add_vertex(Vector<double, 4>(Vector<double, 4>::Zero())));
      for (int k = 0; k < 5; ++k) {
        const auto eliminated = graph.add_vertex(Vector<double, 1>(Vector<double, 1>::Zero()));
        graph.set_eliminated(eliminated, true);
        for (int i = 0; i < 3; ++i)
          graph.add_edge(FreeShift{2.0 * k - i, Vector3(1 + i, 2, 3)}, 1.0, kept[static_cast<std::size_t>(i)],
                         eliminated);
      }
      const Report report = optimize(graph, {.algorithm = algorithm, .linear_solver = solver.kind});
      EXPECT_TRUE(report.converged()) << report;
      EXPECT_LT(report.chi2_final, 1e-15) << report;
      for (int i = 0; i < 3; ++i)
        EXPECT_NEAR(graph.estimate(kept[static_cast<std::size_t>(i)])[0], 1 + i, 1e-9);
    }
  }
}

/// Entry 2 of the camera is not measured.
struct WithoutEntryOfCamera {
  double z;
  template <class S>
  Vector<S, 7> error(const Vector<S, 2>& pose, const Vector<S, 4>& camera, const Vector<S, 1>& point) const {
    return {point[0] - z, pose[0], pose[1] + point[0], camera[0], camera[1] - point[0], camera[3], S(0)};
  }
};

TEST(Gauge, OfACameraIsNamedAlsoIfItIsOneBlockWithItsPose) {
  for (const detail::LinearSolverEntry& solver : every_solver()) {
    SCOPED_TRACE(solver.name);
    Graph graph;
    const auto pose = graph.add_vertex(Vector<double, 2>(1, 2), 1);
    const auto camera = graph.add_vertex(Vector<double, 4>(1, 2, 3, 4), 2);
    const auto anchor = graph.add_vertex(Vector<double, 1>(Vector<double, 1>::Zero()), 3);
    graph.fix(anchor);
    for (int k = 0; k < 5; ++k) {
      const auto point = graph.add_vertex(Vector<double, 1>(Vector<double, 1>::Zero()), 10 + k);
      graph.add_edge([](const auto& a, const auto& b) { return (a - b).eval(); }, anchor, point);
      graph.set_eliminated(point, true);
      graph.add_edge(WithoutEntryOfCamera{1.0 * k}, 1.0, pose, camera, point);
    }
    const Report report =
        optimize(graph, {.algorithm = AlgorithmKind::kGaussNewton, .linear_solver = solver.kind});
    EXPECT_THAT(report.message, testing::HasSubstr("vertex 2")) << report;
  }
}

TEST(Gauge, IsNotFixedByParameters) {
  Graph graph;
  const auto offset = graph.add_parameter(SE3());
  const auto pose = graph.add_vertex(SE3());
  const auto landmark = graph.add_vertex(Vector3(1, 2, 3));
  graph.add_edge(OffsetPointObservation3(Vector3(1, 2, 2.5)), pose, landmark, offset);
  EXPECT_THAT(optimize(graph).gauge.held, ElementsAre(0));
}

}  // namespace
}  // namespace boxplus
