// SPDX-License-Identifier: BSD-3-Clause
// Random problems with bounds. Set BOXPLUS_PROBLEMS to run more of them.
#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <limits>
#include <random>
#include <sstream>

#include "boxplus/algorithm/algorithm_table.h"
#include "boxplus/optimize/optimizer.h"

namespace boxplus {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr int kMost = 6;
using Numbers = std::array<double, kMost>;

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  double uniform(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_() >> 11) * 0x1p-53;
  }
  int integer(int low, int high) { return low + static_cast<int>(uniform(0, high - low + 1)); }
  bool has(double probability) { return uniform(0, 1) < probability; }
  /// A number of any sign, with a magnitude from 1e-6 to 1e3 or, more often, from 0.1 to 10.
  double number() {
    const double exponent = has(0.3) ? uniform(-6, 3) : uniform(-1, 1);
    return (has(0.5) ? -1 : 1) * std::pow(10, exponent);
  }

 private:
  std::mt19937_64 engine_;
};

/// The error aᵀx + c sin(dᵀx) − b, which depends on all unknowns or on the two unknowns `first` and `second`.
struct Row {
  Numbers a{}, d{};
  double b = 0, c = 0;
  int first = 0, second = 0;
};

struct RowOfVector {
  Row row;
  template <class X>
  auto operator()(const X& x) const {
    using std::sin;
    using S = std::decay_t<decltype(x[0])>;
    S linear(-row.b), angle(0.0);
    for (int i = 0; i < x.size(); ++i) {
      linear += row.a[static_cast<std::size_t>(i)] * x[i];
      angle += row.d[static_cast<std::size_t>(i)] * x[i];
    }
    return S(linear + row.c * sin(angle));
  }
};

struct RowOfTwo {
  double a, b, c, d, e, f;
  template <class S>
  S operator()(const S& x, const S& y) const {
    using std::sin;
    return a * x + b * y - c + d * sin(e * x + f * y);
  }
};

struct Problem {
  int n = 1;
  bool is_linear = true;
  bool has_vertices = false;  // one for each unknown
  std::vector<Row> rows;
  Numbers lower{}, upper{}, start{};
};

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

Problem random_problem(std::uint64_t seed) {
  Random random(seed);
  Problem problem;
  problem.n = random.integer(1, kMost);
  problem.is_linear = random.has(0.6);
  problem.has_vertices = problem.n > 1 && random.has(0.5);
  const auto nonlinearity = [&] { return problem.is_linear ? 0 : random.uniform(-0.3, 0.3); };
  const auto add_row = [&](int first, int second) {
    Row row{.b = random.uniform(-10, 10), .c = nonlinearity(), .first = first, .second = second};
    for (int i = 0; i < problem.n; ++i) {
      if (problem.has_vertices && i != first && i != second) continue;
      row.a[at(i)] = random.uniform(-3, 3);
      row.d[at(i)] = random.uniform(-0.5, 0.5);
    }
    problem.rows.push_back(row);
  };
  const int rows = problem.n + random.integer(0, 3);
  for (int k = 0; k < rows; ++k) add_row(k % problem.n, (k + 1) % problem.n);
  if (problem.has_vertices) {
    for (int i = 0; i + 1 < problem.n; ++i) add_row(i, i + 1);
  }
  for (int i = 0; i < problem.n; ++i) {
    const double one = random.number(), other = random.has(0.1) ? one : random.number();
    problem.lower[at(i)] = random.has(0.4) ? -kInfinity : std::min(one, other);
    problem.upper[at(i)] = random.has(0.4) ? kInfinity : std::max(one, other);
    const double limit = random.has(0.5) ? problem.lower[at(i)] : problem.upper[at(i)];
    const bool is_at_limit = std::isfinite(limit) && random.has(0.4);
    const double shift = random.has(0.2) ? (random.has(0.5) ? 1 : -1) * 1e-16 * std::abs(limit) : 0;
    problem.start[at(i)] = is_at_limit        ? limit + shift
                           : random.has(0.05) ? 1e3 * random.number()
                                              : random.number();
  }
  return problem;
}

/// A graph of the problem, and its unknowns.
template <int N>
struct Solved {
  explicit Solved(const Problem& problem) : n(problem.n) {
    if (problem.has_vertices) {
      for (int i = 0; i < n; ++i) numbers.push_back(graph.add_vertex(problem.start[at(i)]));
      for (const Row& row : problem.rows) {
        const std::size_t i = at(row.first), j = at(row.second);
        graph.add_edge(RowOfTwo{row.a[i], row.a[j], row.b, row.c, row.d[i], row.d[j]}, numbers[i],
                       numbers[j]);
      }
    } else {
      x = graph.add_vertex(Vector<double, N>(Vector<double, N>::Map(problem.start.data())));
      for (const Row& row : problem.rows) graph.add_edge(RowOfVector{row}, x);
    }
    for (int i = 0; i < n; ++i)
      graph.set_bounds(vertex(i), entry(i), problem.lower[at(i)], problem.upper[at(i)]);
  }
  VertexRef vertex(int i) const { return numbers.empty() ? VertexRef(x) : VertexRef(numbers[at(i)]); }
  int entry(int i) const { return numbers.empty() ? i : 0; }
  double value(int i) const {
    return numbers.empty() ? graph.estimate(x)[i] : graph.estimate(numbers[at(i)]);
  }

  Graph graph;
  int n;
  VertexHandle<Vector<double, N>> x;
  std::vector<VertexHandle<double>> numbers;
};

double chi2_at(const Problem& problem, const Numbers& x) {
  double sum = 0;
  for (const Row& row : problem.rows) {
    const double error = RowOfVector{row}(Eigen::Map<const Eigen::VectorXd>(x.data(), problem.n));
    sum += error * error;
  }
  return sum;
}

/// The least chi2 of a linear problem: tries all active sets.
double optimum_of(const Problem& problem) {
  const int n = problem.n;
  Eigen::MatrixXd A(problem.rows.size(), n);
  Eigen::VectorXd b(problem.rows.size());
  for (std::size_t k = 0; k < problem.rows.size(); ++k) {
    for (int i = 0; i < n; ++i) A(static_cast<Eigen::Index>(k), i) = problem.rows[k].a[at(i)];
    b[static_cast<Eigen::Index>(k)] = problem.rows[k].b;
  }
  const Eigen::MatrixXd H = A.transpose() * A;
  const Eigen::VectorXd g = A.transpose() * b;
  double best = kInfinity;
  Eigen::VectorXd x = Eigen::VectorXd::Zero(n);
  std::vector<int> free;
  const std::function<void(int)> try_from = [&](int i) {
    if (i < n) {
      free.push_back(i);
      try_from(i + 1);
      free.pop_back();
      for (const double limit : {problem.lower[at(i)], problem.upper[at(i)]}) {
        if (!std::isfinite(limit)) continue;
        x[i] = limit;
        try_from(i + 1);
      }
      return;
    }
    for (const int k : free) x[k] = 0;
    const auto m = std::ssize(free);
    Eigen::MatrixXd of_free(m, m);
    for (int r = 0; r < m; ++r) {
      for (int c = 0; c < m; ++c) of_free(r, c) = H(free[at(r)], free[at(c)]);
    }
    const Eigen::VectorXd rest = g - H * x;
    const Eigen::VectorXd solution = of_free.ldlt().solve(Eigen::VectorXd(rest(free)));
    for (int r = 0; r < m; ++r) {
      const int k = free[at(r)];
      const double slack = 1e-9 * (1 + std::abs(solution[r]));
      if (!(solution[r] >= problem.lower[at(k)] - slack && solution[r] <= problem.upper[at(k)] + slack))
        return;
      x[k] = std::clamp(solution[r], problem.lower[at(k)], problem.upper[at(k)]);
    }
    best = std::min(best, (A * x - b).squaredNorm());
  };
  try_from(0);
  return best;
}

/// The decrease of chi2 that a single unknown could still give, by the conditions of Karush, Kuhn and Tucker.
template <int N>
double possible_decrease(const Problem& problem, const Solved<N>& solved) {
  Eigen::VectorXd gradient = Eigen::VectorXd::Zero(problem.n), curvature = gradient;
  for (const EdgeRef edge : solved.graph.all_edges()) {
    const std::vector<Eigen::MatrixXd> J = solved.graph.jacobian(edge);
    const double error = solved.graph.error(edge)[0];
    const auto vertices = solved.graph.vertices(edge);
    for (int i = 0; i < problem.n; ++i) {
      for (std::size_t k = 0; k < J.size(); ++k) {
        if (vertices[k] != solved.vertex(i)) continue;
        const double slope = J[k](0, solved.entry(i));
        gradient[i] += slope * error;
        curvature[i] += slope * slope;
      }
    }
  }
  double most = 0;
  for (int i = 0; i < problem.n; ++i) {
    const double limit = gradient[i] > 0 ? problem.lower[at(i)] : problem.upper[at(i)];
    const double way = std::min(std::abs(limit - solved.value(i)), std::abs(gradient[i]) / curvature[i]);
    most = std::max(most, way * std::abs(gradient[i]));
  }
  return most;
}

/// Whether a result is at the optimum, as far as the default tolerances of optimize() demand.
bool is_near(double chi2, double optimum) {
  return std::abs(chi2 - optimum) <= 1e-5 * optimum + 1e-9;
}

std::string describe(const Problem& problem) {
  std::ostringstream out;
  out.precision(17);
  out << "n " << problem.n << (problem.is_linear ? " linear" : "")
      << (problem.has_vertices ? " vertices" : "");
  for (int i = 0; i < problem.n; ++i)
    out << "\n  " << problem.lower[at(i)] << " <= x <= " << problem.upper[at(i)] << ", start "
        << problem.start[at(i)];
  return out.str();
}

template <int N>
void expect_optimum(const Problem& problem, int& converged) {
  constexpr int kMostToEnumerate = 5;
  const bool enumerates =
      problem.is_linear && (problem.n <= kMostToEnumerate || std::getenv("BOXPLUS_PROBLEMS"));
  const double optimum = enumerates ? optimum_of(problem) : 0;
  for (const AlgorithmKind kind :
       {AlgorithmKind::kLevenbergMarquardt, AlgorithmKind::kDogleg, AlgorithmKind::kGaussNewton}) {
    Solved<N> solved(problem);
    const Report report = optimize(solved.graph, {.algorithm = kind, .threads = 1});
    SCOPED_TRACE(testing::Message() << to_string(kind) << "\n" << report);
    // At a local minimum with a singular H, dogleg may find no step. Gauss-Newton may end anywhere.
    EXPECT_TRUE(report.converged() || !problem.is_linear);
    converged += report.converged();
    if (!report.converged() && kind == AlgorithmKind::kGaussNewton) continue;
    Numbers x{};
    for (int i = 0; i < problem.n; ++i) {
      x[at(i)] = solved.value(i);
      EXPECT_TRUE(x[at(i)] >= problem.lower[at(i)] && x[at(i)] <= problem.upper[at(i)]);
    }
    EXPECT_NEAR(report.chi2_final, chi2_at(problem, x), 1e-12 + 1e-9 * report.chi2_final);
    EXPECT_TRUE(!enumerates || is_near(report.chi2_final, optimum)) << "optimum " << optimum;
    EXPECT_LE(possible_decrease(problem, solved), 1e-5 * report.chi2_final + 1e-9);
    const AlgorithmKind other =
        kind == AlgorithmKind::kDogleg ? AlgorithmKind::kLevenbergMarquardt : AlgorithmKind::kDogleg;
    const Report again = optimize(solved.graph, {.algorithm = other, .threads = 1});
    EXPECT_TRUE(is_near(report.chi2_final, again.chi2_final)) << "from there\n" << again;
  }
}

TEST(Bounds, GiveTheOptimumOfRandomProblems) {
  const char* const wanted = std::getenv("BOXPLUS_PROBLEMS");
  const int problems = wanted != nullptr ? std::atoi(wanted) : 2000;
  int converged = 0;
  for (int seed = 0; seed < problems; ++seed) {
    const Problem problem = random_problem(static_cast<std::uint64_t>(seed));
    SCOPED_TRACE(testing::Message() << "seed " << seed << ", " << describe(problem));
    constexpr std::array kRun{expect_optimum<1>, expect_optimum<2>, expect_optimum<3>,
                              expect_optimum<4>, expect_optimum<5>, expect_optimum<6>};
    kRun[at(problem.n - 1)](problem, converged);
  }
  EXPECT_GE(converged, 3 * problems - problems / 100);
}

}  // namespace
}  // namespace boxplus
