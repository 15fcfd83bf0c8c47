// SPDX-License-Identifier: BSD-3-Clause
#include "system/bounds.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "boxplus/base/error.h"
#include "boxplus/linear/linear_solver_kind.h"
#include "boxplus/optimize/optimizer.h"
#include "boxplus/types/ba.h"
#include "boxplus/types/slam2d.h"

namespace boxplus {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr AlgorithmKind kAlgorithms[] = {AlgorithmKind::kAutomatic, AlgorithmKind::kLevenbergMarquardt,
                                         AlgorithmKind::kDogleg, AlgorithmKind::kGaussNewton};

/// Options for which a run ends only when chi2 has rounding errors alone.
Options exact_options(AlgorithmKind algorithm) {
  return {.algorithm = algorithm,
          .max_iterations = 500,
          .cost_tolerance = 1e-16,
          .noise_tolerance = 0,
          .step_tolerance = 0,
          .gradient_tolerance = 0};
}

template <int N>
struct Problem {
  using Point = Vector<double, N>;
  Point start, lower, upper;
  Point optimum;
  double chi2 = 0;
};

/// Runs every algorithm that compares chi2. The limits of `optimum` are exact; its other entries were
/// computed with 40 digits.
template <int N, class Error>
void expect_optimum(const Error& error, const Problem<N>& problem) {
  for (const AlgorithmKind algorithm :
       {AlgorithmKind::kAutomatic, AlgorithmKind::kLevenbergMarquardt, AlgorithmKind::kDogleg}) {
    SCOPED_TRACE(to_string(algorithm));
    Graph graph;
    const auto x = graph.add_vertex(problem.start);
    graph.add_edge(error, x);
    for (int i = 0; i < N; ++i) graph.set_bounds(x, i, problem.lower[i], problem.upper[i]);
    const Report report = optimize(graph, exact_options(algorithm));
    EXPECT_TRUE(report.converged()) << report;
    EXPECT_NEAR(report.chi2_final, problem.chi2, 1e-9 * (1e-3 + problem.chi2)) << report;
    std::size_t active = 0;
    for (int i = 0; i < N; ++i) {
      const double value = graph.estimate(x)[i];
      const bool at_limit = problem.optimum[i] == problem.lower[i] || problem.optimum[i] == problem.upper[i];
      EXPECT_GE(value, problem.lower[i]);
      EXPECT_LE(value, problem.upper[i]);
      EXPECT_NEAR(value, problem.optimum[i], at_limit ? 0 : 1e-5 * (1 + std::abs(problem.optimum[i]))) << i;
      active += at_limit;
    }
    EXPECT_EQ(report.active_bounds.size(), active) << report;
    for (const Report::ActiveBound& bound : report.active_bounds) {
      const double h = 1e-6 * std::max(1.0, std::abs(bound.limit));
      const auto chi2_at = [&](double shift) {
        auto moved = graph.estimate(x);
        moved[bound.entry] += shift;
        Graph other;
        other.add_edge(error, other.add_vertex(moved));
        return other.chi2();
      };
      const double slope = (chi2_at(h) - chi2_at(-h)) / (2 * h);
      EXPECT_NEAR(bound.multiplier, bound.is_upper ? -slope : slope, 1e-5 * (1e-3 + std::abs(slope)));
    }
  }
}

constexpr auto kRosenbrock = [](const auto& x) {
  using S = std::decay_t<decltype(x[0])>;
  return Vector<S, 2>(10.0 * (x[1] - x[0] * x[0]), 1.0 - x[0]);
};

// Moré, Garbow and Hillstrom, "Testing unconstrained optimization software" (1981), with the limits of Gay
// (1984) or limits near the unconstrained optimum, and Hock and Schittkowski, "Test examples for nonlinear
// programming codes" (1981).

TEST(Bounds, GiveTheOptimumOfRosenbrock) {
  expect_optimum<2>(kRosenbrock, {{-1.2, 1}, {-50, 0}, {0.5, 100}, {0.5, 0.25}, 0.25});
}

TEST(Bounds, GiveTheOptimumOfHockSchittkowski1) {
  expect_optimum<2>(kRosenbrock, {{-2, 1}, {-kInfinity, -1.5}, {kInfinity, kInfinity}, {1, 1}, 0});
}

TEST(Bounds, GiveTheOptimumOfHockSchittkowski2) {
  const double a = std::sqrt(598.0 / 1200), b = 400 * a * a * a;
  expect_optimum<2>(kRosenbrock, {{2, 5},
                                  {-kInfinity, 1.5},
                                  {kInfinity, kInfinity},
                                  {2 * a * std::cos(std::acos(1 / b) / 3), 1.5},
                                  0.0504261879});
}

TEST(Bounds, GiveTheOptimumOfFreudensteinAndRoth) {
  const auto error = [](const auto& x) {
    using S = std::decay_t<decltype(x[0])>;
    return Vector<S, 2>(-13.0 + x[0] + ((5.0 - x[1]) * x[1] - 2.0) * x[1],
                        -29.0 + x[0] + ((x[1] + 1.0) * x[1] - 14.0) * x[1]);
  };
  expect_optimum<2>(error, {{0.5, -2}, {0, -30}, {20, -0.9}, {11.37, -0.9}, 48.985202});
}

TEST(Bounds, GiveTheOptimumOfBrownsBadlyScaledFunction) {
  const auto error = [](const auto& x) {
    using S = std::decay_t<decltype(x[0])>;
    return Vector<S, 3>(x[0] - 1e6, x[1] - 2e-6, x[0] * x[1] - 2.0);
  };
  expect_optimum<2>(error, {{1, 1}, {0, 3e-5}, {1e6, 100}, {999999.9991600000, 3e-5}, 783.99999929518400});
}

TEST(Bounds, GiveTheOptimumOfBeale) {
  const auto error = [](const auto& x) {
    using S = std::decay_t<decltype(x[0])>;
    const S y2 = x[1] * x[1];
    return Vector<S, 3>(1.5 - x[0] * (1.0 - x[1]), 2.25 - x[0] * (1.0 - y2),
                        2.625 - x[0] * (1.0 - y2 * x[1]));
  };
  expect_optimum<2>(
      error,
      {{1, 1}, {-kInfinity, -kInfinity}, {2.5, kInfinity}, {2.5, 0.3500634945251207}, 0.07270005065353373});
}

TEST(Bounds, GiveTheOptimumOfTheHelicalValley) {
  const auto error = [](const auto& x) {
    using std::atan, std::sqrt;
    using S = std::decay_t<decltype(x[0])>;
    const S turns = atan(x[1] / x[0]) / (2 * std::numbers::pi) + (x[0] < 0 ? 0.5 : 0.0);
    return Vector<S, 3>(10.0 * (x[2] - 10.0 * turns), 10.0 * (sqrt(x[0] * x[0] + x[1] * x[1]) - 1.0), x[2]);
  };
  expect_optimum<3>(error, {{-1, 0.1, 0},
                            {-100, -1, -1},
                            {0.8, 1, 1},
                            {0.8, 0.5619366456706896, 0.9649340753151801},
                            0.9904221209614002});
}

TEST(Bounds, GiveTheOptimumOfBard) {
  const auto error = [](const auto& x) {
    using S = std::decay_t<decltype(x[0])>;
    constexpr std::array kData{0.14, 0.18, 0.22, 0.25, 0.29, 0.32, 0.35, 0.39,
                               0.37, 0.58, 0.73, 0.96, 1.34, 2.10, 4.39};
    Vector<S, 15> result;
    for (int i = 0; i < 15; ++i) {
      const double u = i + 1, v = 15 - i, w = std::min(u, v);
      result[i] = kData[static_cast<std::size_t>(i)] - (x[0] + u / (v * x[1] + w * x[2]));
    }
    return result;
  };
  expect_optimum<3>(error, {{1, 1, 1},
                            {0.1, 0, 0},
                            {50, 100, 1.5},
                            {0.1017487254494203, 2.001529023976604, 1.5},
                            0.01117354694111998});
}

TEST(Bounds, GiveTheOptimumOfKowalikAndOsborne) {
  const auto error = [](const auto& x) {
    using S = std::decay_t<decltype(x[0])>;
    constexpr std::array kY{0.1957, 0.1947, 0.1735, 0.1600, 0.0844, 0.0627,
                            0.0456, 0.0342, 0.0323, 0.0235, 0.0246};
    constexpr std::array kU{4.0, 2.0, 1.0, 0.5, 0.25, 0.167, 0.125, 0.1, 0.0833, 0.0714, 0.0625};
    Vector<S, 11> result;
    for (int i = 0; i < 11; ++i) {
      const double y = kY[static_cast<std::size_t>(i)], u = kU[static_cast<std::size_t>(i)];
      result[i] = y - x[0] * (u * u + u * x[1]) / (u * u + u * x[2] + x[3]);
    }
    return result;
  };
  expect_optimum<4>(error, {{0.2, 0.39, 0.415, 0.39},
                            {0, 0.13, 0, 0.2},
                            {0.2, 1, 1, 1},
                            {0.1874933783190266, 0.337062953590792, 0.1616186376425395, 0.2},
                            0.0003315350939994875});
}

TEST(Bounds, GiveTheOptimumOfPowellsSingularFunction) {
  const auto error = [](const auto& x) {
    using S = std::decay_t<decltype(x[0])>;
    const S a = x[1] - 2.0 * x[2], b = x[0] - x[3];
    return Vector<S, 4>(x[0] + 10.0 * x[1], std::sqrt(5.0) * (x[2] - x[3]), a * a, std::sqrt(10.0) * (b * b));
  };
  expect_optimum<4>(error, {{3, -1, 0.1, 1},
                            {-100, -1, 0.1, 0.01},
                            {100, 100, 100, 100},
                            {0.05540842714030856, -0.005367611618141033, 0.1, 0.09965353780822035},
                            0.001820727047598131});
}

TEST(Bounds, GiveTheOptimumOfWood) {
  const auto error = [](const auto& x) {
    using S = std::decay_t<decltype(x[0])>;
    return Vector<S, 6>(10.0 * (x[1] - x[0] * x[0]), 1.0 - x[0], std::sqrt(90.0) * (x[3] - x[2] * x[2]),
                        1.0 - x[2], std::sqrt(10.0) * (x[1] + x[3] - 2.0), (x[1] - x[3]) / std::sqrt(10.0));
  };
  expect_optimum<4>(error, {{-3, -1, -3, -1},
                            {-10, -10, -10, -10},
                            {0.5, 10, 10, 10},
                            {0.5, 0.2541159079087585, 1.310748082729024, 1.719377630226837},
                            0.5701396836644904});
}

TEST(Bounds, GiveTheOptimumOfBoxsThreeDimensionalFunction) {
  const auto error = [](const auto& x) {
    using std::exp;
    using S = std::decay_t<decltype(x[0])>;
    Vector<S, 10> result;
    for (int i = 0; i < 10; ++i) {
      const double t = 0.1 * (i + 1);
      result[i] = exp(-t * x[0]) - exp(-t * x[1]) - x[2] * (std::exp(-t) - std::exp(-10 * t));
    }
    return result;
  };
  expect_optimum<3>(error, {{0, 9.5, 20},
                            {0, 5, 0},
                            {2, 9.5, 20},
                            {1.037944132770036, 9.5, 0.9722275854201355},
                            0.0001143481802641458});
}

/// A chain of numbers, each of which is measured, with limits that hold about a third of them.
struct Chain {
  explicit Chain(bool eliminates = false) {
    std::uint32_t state = 1;
    const auto number = [&] {
      return static_cast<double>((state = 1664525 * state + 1013904223) >> 8) / 0x1p24;
    };
    for (int k = 0; k < 60; ++k) {
      x.push_back(graph.add_vertex(Vector2(0.5, 0.5)));
      graph.add_edge(
          [a = number(), b = number()](const auto& v) {
            using S = std::decay_t<decltype(v[0])>;
            return Vector<S, 2>(v[0] - a, v[1] * v[1] + v[0] - b);
          },
          x.back());
      if (k > 0)
        graph.add_edge([](const auto& u, const auto& v) { return (0.3 * (u - v)).eval(); }, x[x.size() - 2],
                       x.back());
      graph.set_bounds(x.back(), 0, 0.4, 0.6);
      graph.set_bounds(x.back(), 1, -kInfinity, 0.55);
      if (eliminates && k % 2 == 1) graph.set_eliminated(x.back(), true);
    }
  }
  Graph graph;
  std::vector<VertexHandle<Vector2>> x;
};

/// The largest amount by which the estimates of the chain violate the conditions of a constrained minimum
/// (Karush, Kuhn and Tucker).
double violation_of_conditions(const Chain& chain) {
  double worst = 0;
  for (const auto& x : chain.x) {
    for (const detail::Bound& bound : chain.graph.bounds(x)) {
      const auto slope = [&] {
        double sum = 0;
        for (const EdgeRef edge : chain.graph.edges(x)) {
          const auto vertices = chain.graph.vertices(edge);
          const auto place = std::find(vertices.begin(), vertices.end(), VertexRef(x)) - vertices.begin();
          const Eigen::MatrixXd J = chain.graph.jacobian(edge)[static_cast<std::size_t>(place)];
          const std::vector<double> e = chain.graph.error(edge);
          for (Eigen::Index row = 0; row < J.rows(); ++row)
            sum += J(row, bound.entry) * e[static_cast<std::size_t>(row)];
        }
        return sum;
      }();
      const double value = chain.graph.estimate(x)[bound.entry];
      if (value < bound.lower || value > bound.upper) return kInfinity;
      const double outward = value == bound.lower ? -slope : value == bound.upper ? slope : std::abs(slope);
      worst = std::max(worst, outward);
    }
  }
  return worst;
}

TEST(Bounds, HoldForEverySolverWithAndWithoutElimination) {
  double expected = -1;
  for (const LinearSolverKind solver :
       {LinearSolverKind::kAutomatic, LinearSolverKind::kDense, LinearSolverKind::kPcg}) {
    for (const bool eliminates : {false, true}) {
      for (const AlgorithmKind algorithm : {AlgorithmKind::kLevenbergMarquardt, AlgorithmKind::kDogleg}) {
        SCOPED_TRACE(std::string(to_string(solver)) + " " + std::string(to_string(algorithm)));
        Chain chain(eliminates);
        Options options = exact_options(algorithm);
        options.linear_solver = solver;
        const Report report = optimize(chain.graph, options);
        EXPECT_TRUE(report.converged()) << report;
        EXPECT_LT(violation_of_conditions(chain), 1e-5);
        EXPECT_GT(report.active_bounds.size(), 20u);
        if (expected < 0) expected = report.chi2_final;
        EXPECT_NEAR(report.chi2_final, expected, 1e-9 * expected);
      }
    }
  }
}

TEST(Bounds, GiveTheSameBitsForAnyNumberOfThreads) {
  std::vector<double> chi2;
  for (const int threads : {1, 2, 3}) {
    Chain chain(true);
    chi2.push_back(optimize(chain.graph, {.threads = threads}).chi2_final);
  }
  EXPECT_EQ(chi2[0], chi2[1]);
  EXPECT_EQ(chi2[0], chi2[2]);
}

/// x + (limit − x) is one unit in the last place below the limit for these numbers.
TEST(Bounds, HoldIfTheStepToALimitIsRounded) {
  for (const AlgorithmKind algorithm : kAlgorithms) {
    SCOPED_TRACE(to_string(algorithm));
    Graph graph;
    const auto x = graph.add_vertex(Vector2(-0.7, -0.2));
    graph.set_bounds(x, 0, -kInfinity, 0.1);
    graph.set_bounds(x, 1, 0, kInfinity);
    graph.add_edge(
        [](const auto& p) {
          using S = std::decay_t<decltype(p[0])>;
          return Vector<S, 2>(2.0 * p[0] + p[1] - 6.0, -2.0 * p[0] - 3.0 * p[1] + 4.0);
        },
        x);
    const Report report = optimize(graph, {.algorithm = algorithm});
    EXPECT_TRUE(report.converged()) << report;
    EXPECT_EQ(graph.estimate(x)[0], 0.1);
    EXPECT_NEAR(graph.estimate(x)[1], 1.72, 1e-6);
    EXPECT_NEAR(report.chi2_final, 18.496, 1e-6);
  }
}

/// The steps from the start are a billion times longer than from the limits to the optimum.
TEST(Bounds, HoldForEveryAlgorithmFromAStartFarAway) {
  for (const AlgorithmKind algorithm : kAlgorithms) {
    SCOPED_TRACE(to_string(algorithm));
    Graph graph;
    const auto x = graph.add_vertex(Vector2(-1000, -1000));
    graph.set_bounds(x, 0, -kInfinity, 1e-6);
    graph.set_bounds(x, 1, -kInfinity, 0.01);
    graph.add_edge(
        [](const auto& p) {
          using S = std::decay_t<decltype(p[0])>;
          return Vector<S, 2>(20.0 * p[0] - 0.3 * p[1] - 7.0, 10.0 * p[0] - 4.0);
        },
        x);
    const Report report = optimize(graph, {.algorithm = algorithm});
    EXPECT_TRUE(report.converged()) << report;
    EXPECT_EQ(graph.estimate(x)[0], 1e-6);
    EXPECT_NEAR(report.chi2_final, 16, 1e-3);
  }
}

/// The gauge of both graphs is free, and a vertex would be held without the bounds.
TEST(Bounds, HoldForEveryVertexOfAGraphThatNothingAnchors) {
  for (const AlgorithmKind algorithm : kAlgorithms) {
    SCOPED_TRACE(to_string(algorithm));
    Graph graph;
    const auto a = graph.add_vertex(Vector2(5, 0)), b = graph.add_vertex(Vector2(0, 0));
    graph.add_edge(Between(Vector2(1, 0)), a, b);
    graph.set_bounds(a, 0, 0, 1);
    const Report report = optimize(graph, {.algorithm = algorithm});
    EXPECT_TRUE(report.converged()) << report;
    EXPECT_TRUE(report.gauge.held.empty());
    EXPECT_GE(graph.estimate(a)[0], 0);
    EXPECT_LE(graph.estimate(a)[0], 1);
    EXPECT_NEAR(report.chi2_final, 0, 1e-12);
    EXPECT_EQ(report.degrees_of_freedom, 0);

    graph.set_bounds(a, 0, -1, 1);
    graph.set_bounds(b, 0, -1, 0.5);
    graph.set_estimate(a, Vector2(0.9, 0));
    graph.set_estimate(b, Vector2(0, 0));
    const Report again = optimize(graph, {.algorithm = algorithm});
    EXPECT_TRUE(again.converged()) << again;
    EXPECT_NEAR(again.chi2_final, 0, 1e-12);
    EXPECT_LE(graph.estimate(b)[0], 0.5);
  }
}

TEST(Bounds, DecideWhatIsHeldAlsoIfTheyAreSetOrLiftedBetweenRuns) {
  Graph graph;
  const auto a = graph.add_vertex(Vector2(0, 0)), b = graph.add_vertex(Vector2(0, 0));
  graph.add_edge(Between(Vector2(1, 0)), a, b);
  Optimizer optimizer(graph);
  EXPECT_EQ(optimizer.run().gauge.held.size(), 1u);
  graph.set_bounds(a, 0, 2, 3);
  const Report bounded = optimizer.run();
  EXPECT_TRUE(bounded.converged()) << bounded;
  EXPECT_GE(graph.estimate(a)[0], 2);
  EXPECT_NEAR(bounded.chi2_final, 0, 1e-12);
  EXPECT_TRUE(optimizer.covariance(std::vector<VertexRef>{b}).ok()) << "a covariance ignores bounds";
  const auto c = graph.add_vertex(Vector2(3, 3));
  graph.set_bounds(c, 1, 0, 1);
  graph.add_edge(Between(Vector2(1, 0)), b, c);
  EXPECT_TRUE(optimizer.run().converged());
  EXPECT_LE(graph.estimate(c)[1], 1);
  graph.set_bounds(a, 0, -kInfinity, kInfinity);
  graph.set_bounds(c, 1, -kInfinity, kInfinity);
  EXPECT_EQ(optimizer.run().gauge.held.size(), 1u);
}

TEST(Bounds, HoldForANewVertexOfAGraphWithAHeldVertex) {
  Graph graph;
  const auto a = graph.add_vertex(Vector2(0, 0)), b = graph.add_vertex(Vector2(0, 0));
  graph.add_edge(Between(Vector2(1, 0)), a, b);
  Optimizer optimizer(graph);
  EXPECT_EQ(optimizer.run().gauge.held.size(), 1u);
  const auto c = graph.add_vertex(Vector2(0, 0));
  graph.set_bounds(c, 0, -6, -5);
  graph.add_edge(Between(Vector2(1, 0)), b, c);
  const Report report = optimizer.run();
  EXPECT_TRUE(report.converged()) << report;
  EXPECT_NEAR(report.chi2_final, 0, 1e-9);
  EXPECT_LE(graph.estimate(c)[0], -5);
}

TEST(Bounds, MoveVerticesWithoutEdges) {
  Graph graph;
  const auto a = graph.add_vertex(0.0), alone = graph.add_vertex(5.0), left_out = graph.add_vertex(5.0);
  graph.add_edge([](const auto& x) { return x - 3.0; }, a);
  graph.set_bounds(alone, 0, -1, 1);
  graph.set_bounds(left_out, 0, -1, 1);
  EXPECT_TRUE(optimize(graph, {.vertices = {a, alone}}).converged());
  EXPECT_EQ(graph.estimate(alone), 1);
  EXPECT_EQ(graph.estimate(left_out), 5) << "only the vertices of the options are optimized";
  EXPECT_TRUE(optimize(graph).converged());
  EXPECT_EQ(graph.estimate(left_out), 1);
}

TEST(Bounds, MoveEstimatesThatAreOutsideButNotFixedOnes) {
  Graph graph;
  const auto free = graph.add_vertex(5.0), fixed = graph.add_vertex(5.0);
  const auto direction = graph.add_vertex(Vector2(5, 5));
  graph.fix(fixed);
  graph.fix_directions(direction, {0});
  for (const VertexRef vertex : {VertexRef(free), VertexRef(fixed), VertexRef(direction)})
    graph.set_bounds(vertex, 0, -1, 1);
  graph.add_edge([](const auto& x) { return x - 3.0; }, free);
  graph.add_edge([](const auto& x, const auto& y) { return y[1] - x; }, fixed, direction);
  const Report report = optimize(graph);
  EXPECT_TRUE(report.converged()) << report;
  EXPECT_EQ(graph.estimate(free), 1);
  EXPECT_EQ(graph.estimate(fixed), 5);
  EXPECT_EQ(graph.estimate(direction)[0], 5);
  ASSERT_EQ(report.active_bounds.size(), 1u);
  EXPECT_EQ(report.active_bounds[0].vertex, free);
  EXPECT_TRUE(report.active_bounds[0].is_upper);
  EXPECT_NEAR(report.active_bounds[0].multiplier, 4, 1e-12);
  EXPECT_THAT(to_string(report),
              testing::HasSubstr("vertex 0, entry 0, is at its upper limit 1 (multiplier 4)"));
}

TEST(Bounds, HoldIntrinsicParametersOfACamera) {
  Graph graph;
  const auto camera = graph.add_vertex(BalCamera(500, 0, 0));
  graph.set_bounds(camera, 0, 480, 520);
  graph.set_bounds(camera, 1, 0, 0);
  graph.add_edge([](const auto& x) { return (x.parameters - Vector3(600, 1, 2)).eval(); }, camera);
  EXPECT_TRUE(optimize(graph).converged());
  EXPECT_EQ(graph.estimate(camera).parameters[0], 520);
  EXPECT_EQ(graph.estimate(camera).parameters[1], 0);
  EXPECT_NEAR(graph.estimate(camera).parameters[2], 2, 1e-9);
}

TEST(Bounds, AreGoneAfterTheyWereLiftedOrTheVertexWasRemoved) {
  Graph graph;
  const auto x = graph.add_vertex(0.0);
  graph.set_bounds(x, 0, -1, 1);
  ASSERT_EQ(graph.bounds(x).size(), 1u);
  Graph copy = graph;
  graph.set_bounds(x, 0, -kInfinity, kInfinity);
  EXPECT_TRUE(graph.bounds(x).empty());
  EXPECT_EQ(copy.bounds(copy.vertex<double>(0)).size(), 1u);
  copy.remove(copy.vertex<double>(0));
  EXPECT_TRUE(copy.bounds(copy.add_vertex(0.0)).empty());
}

TEST(Bounds, AreRefusedIfTheyCannotHold) {
  Graph graph;
  const auto pose = graph.add_vertex(SE2());
  const auto x = graph.add_vertex(Product(SE2(), Vector2(1, 2)));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(graph.set_bounds(pose, 0, -1, 1), InvalidArgument) << "⊞ turns the translation";
  EXPECT_THROW(graph.set_bounds(x, 2, -1, 1), InvalidArgument);
  EXPECT_THROW(graph.set_bounds(x, 5, -1, 1), InvalidArgument);
  EXPECT_THROW(graph.set_bounds(x, -1, -1, 1), InvalidArgument);
  EXPECT_THROW(graph.set_bounds(x, 3, 1, -1), InvalidArgument);
  EXPECT_THROW(graph.set_bounds(x, 3, nan, 1), InvalidArgument);
  EXPECT_THROW(graph.set_bounds(x, 3, kInfinity, kInfinity), InvalidArgument);
  graph.set_bounds(x, 4, -1, 1);
  graph.set_bounds(x, 3, -2, 2);
  ASSERT_EQ(graph.bounds(x).size(), 2u);
  EXPECT_EQ(graph.bounds(x)[0], (detail::Bound{3, -2, 2}));
}

}  // namespace
}  // namespace boxplus
