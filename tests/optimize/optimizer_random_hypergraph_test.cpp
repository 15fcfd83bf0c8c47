// SPDX-License-Identifier: BSD-3-Clause
// Optimizes small random hyper-graphs with many types of vertices, kernels and fixed vertices, and compares
// the results with a dense solver.
#include <gtest/gtest.h>

#include <random>

#include "boxplus/manifold/rn.h"
#include "boxplus/manifold/se2.h"
#include "boxplus/manifold/se3.h"
#include "boxplus/optimize/optimizer.h"
#include "boxplus/robust/make_robust_kernel.h"
#include "optimize/dense_problem.h"
#include "optimize/table_entries.h"
#include "sanitized.h"

namespace boxplus {
namespace {

using Dynamic = Vector<double, kDynamic>;

/// Writes the features of an estimate to `out`, and returns their number. Features are smooth functions that
/// together determine the estimate. Edges measure features.
template <class S, int N>
int features(const Vector<S, N>& x, S* out) {
  for (int i = 0; i < x.size(); ++i) out[i] = x[i];
  return static_cast<int>(x.size());
}
template <class S>
int features(const BasicSE2<S>& x, S* out) {
  using std::cos;
  using std::sin;
  const S values[] = {x.x(), x.y(), cos(x.theta()), sin(x.theta())};
  std::copy(std::begin(values), std::end(values), out);
  return 4;
}
template <class S>
int features(const BasicSE3<S>& x, S* out) {
  const Vector<S, 3> a = x * Vector<double, 3>(1, 0, 0), b = x * Vector<double, 3>(0, 1, 0),
                     t = x.translation();
  for (int i = 0; i < 3; ++i) {
    out[i] = t[i];
    out[3 + i] = a[i];
    out[6 + i] = b[i];
  }
  return 9;
}
template <class T>
int features(std::span<const T> tail, auto* out) {
  int n = 0;
  for (const T& x : tail) n += features(x, out + n);
  return n;
}

/// A mildly nonlinear error: e = A f(x) + bend (A f(x))² − z, with the features f(x) of all vertices. The
/// number of rows is a constant, or it is chosen at run time.
template <int Rows>
struct Mix {
  Eigen::MatrixXd A;
  Eigen::VectorXd z;
  double bend = 0;

  template <class First, class... X>
  auto error(const First& first, const X&... x) const {
    using S = typename decltype(scalar_of(first))::Type;
    std::array<S, 64> f;
    int n = features(first, f.data());
    ((n += features(x, f.data() + n)), ...);
    Vector<S, Rows> e(A.rows());
    for (int i = 0; i < A.rows(); ++i) {
      S sum(0.0);
      for (int j = 0; j < n; ++j) sum += A(i, j) * f[static_cast<std::size_t>(j)];
      e[i] = sum + bend * sum * sum - z[i];
    }
    return e;
  }

 private:
  template <class S>
  struct Scalar {
    using Type = S;
  };
  template <class S, int N>
  static Scalar<S> scalar_of(const Vector<S, N>&);
  template <class S>
  static Scalar<S> scalar_of(const BasicSE2<S>&);
  template <class S>
  static Scalar<S> scalar_of(const BasicSE3<S>&);
  template <class T>
  static auto scalar_of(std::span<const T>) -> decltype(scalar_of(std::declval<T>()));
};

template <class T>
struct Twin {
  VertexHandle<T> handle;
  std::shared_ptr<T> value;
  T truth;
};

class RandomProblem {
 public:
  explicit RandomProblem(unsigned seed) : random_(seed) {}

  void build() {
    auto v1 = add_vertices<Vector<double, 1>>(2, [&] { return Vector<double, 1>(normal()); });
    auto v2 = add_vertices<Vector<double, 2>>(2, [&] { return Vector<double, 2>(normal(), normal()); });
    auto v3 =
        add_vertices<Vector<double, 3>>(2, [&] { return Vector<double, 3>(normal(), normal(), normal()); });
    auto poses2 = add_vertices<SE2>(2, [&] { return SE2(normal(), normal(), normal()); });
    auto poses3 = add_vertices<SE3>(2, [&] { return random_se3(); });
    auto dynamic =
        add_vertices<Dynamic>(3, [&] { return random_dynamic(1 + static_cast<int>(random_() % 5)); });
    determine(v1, v2, v3, poses2, poses3, dynamic);
    for (int k = 0; k < 3; ++k) {
      add<3>(3, pick(poses2), pick(v2));
      add<2>(2, pick(v1), pick(v2), pick(v3));
      add<6>(6, pick(poses3), pick(v3));
      add<4>(4, poses3[0], poses3[1]);
      add<kDynamic>(1 + static_cast<int>(random_() % 4), pick(dynamic), pick(v3), pick(poses2), pick(v1));
    }
    add_tail(dynamic);
  }

  Graph graph;
  DenseProblem dense;
  /// For each vertex, the largest difference between its estimates in `graph` and in `dense`.
  std::vector<std::function<double()>> distance;

 private:
  double normal() { return normal_(random_); }
  double uniform() { return std::uniform_real_distribution<>(0, 1)(random_); }

  SE3 random_se3() {
    const double delta[] = {normal(), normal(), normal(), 0.4 * normal(), 0.4 * normal(), 0.4 * normal()};
    return Manifold<SE3>::oplus(SE3(), delta);
  }
  Dynamic random_dynamic(int size) {
    Dynamic x(size);
    for (int i = 0; i < size; ++i) x[i] = normal();
    return x;
  }

  template <class T>
  std::vector<Twin<T>> add_vertices(int count, auto make) {
    std::vector<Twin<T>> result;
    for (int k = 0; k < count; ++k) {
      const T truth = make();
      std::vector<double> delta(static_cast<std::size_t>(detail::tangent_dim(truth)));
      for (double& d : delta) d = 0.05 * normal();
      const bool fixed = uniform() < 0.2;
      const T start = fixed ? truth : Manifold<T>::oplus(truth, delta.data());
      Twin<T> twin{graph.add_vertex(start), std::make_shared<T>(start), truth};
      graph.set_fixed(twin.handle, fixed);
      dense.add_variable(twin.value, fixed);
      distance.push_back([this, twin] {
        std::vector<double> d(static_cast<std::size_t>(detail::tangent_dim(*twin.value)));
        Manifold<T>::ominus(graph.estimate(twin.handle), *twin.value, d.data());
        double largest = 0;
        for (double v : d) largest = std::max(largest, std::abs(v));
        return largest;
      });
      result.push_back(twin);
    }
    return result;
  }

  template <class T>
  const Twin<T>& pick(const std::vector<Twin<T>>& from) {
    return from[random_() % from.size()];
  }

  /// Adds a prior to every vertex, so that the optimum is unique.
  void determine(const auto&... groups) {
    const auto all = [&](const auto& group) {
      for (const auto& twin : group) add<kDynamic>(detail::tangent_dim(twin.truth) + 4, twin);
    };
    (all(groups), ...);
  }

  Eigen::MatrixXd random_matrix(int rows, int cols) {
    return Eigen::MatrixXd::NullaryExpr(rows, cols, [&] { return normal(); });
  }

  Information random_information(int rows) {
    switch (random_() % 3) {
      case 0:
        return Information(0.1 + uniform());
      case 1: {
        const Eigen::VectorXd d = random_matrix(rows, 1).cwiseAbs().array() + 0.1;
        return Information::diagonal(std::span(d.data(), static_cast<std::size_t>(rows)));
      }
      default: {
        const Eigen::MatrixXd a = random_matrix(rows, rows);
        return Information(Eigen::MatrixXd(a * a.transpose() + 0.1 * Eigen::MatrixXd::Identity(rows, rows)));
      }
    }
  }

  std::shared_ptr<const RobustKernel> random_kernel() {
    static const char* const names[] = {"Huber", "PseudoHuber", "Cauchy", "Fair"};
    if (uniform() < 0.6) return nullptr;
    return make_robust_kernel(names[random_() % 4], 0.5 + uniform());
  }

  template <int Rows, class... T>
  Mix<Rows> make_edge(int rows, const T&... truth) {
    std::array<double, 64> f;
    int n = 0;
    ((n += features(truth, f.data() + n)), ...);
    Mix<Rows> edge{random_matrix(rows, n), Eigen::VectorXd::Zero(rows), 0.02 * normal()};
    edge.z = edge.error(truth...) + 0.05 * random_matrix(rows, 1);
    return edge;
  }

  void mirror(EdgeRef edge, std::function<Eigen::VectorXd()> error) {
    const auto kernel = random_kernel();
    graph.set_kernel(edge, kernel);
    dense.add_edge(std::move(error), graph.information(edge).matrix(), kernel);
  }

  template <int Rows, class... T>
  void add(int rows, const Twin<T>&... twins) {
    const Mix<Rows> edge = make_edge<Rows>(rows, twins.truth...);
    const EdgeRef ref = graph.add_edge(edge, random_information(rows), twins.handle...);
    mirror(ref, [edge, ... values = twins.value] { return Eigen::VectorXd(edge.error(*values...)); });
  }

  void add_tail(const std::vector<Twin<Dynamic>>& twins) {
    std::vector<VertexHandle<Dynamic>> handles;
    std::vector<Dynamic> truth;
    std::vector<std::shared_ptr<Dynamic>> values;
    for (const auto& twin : twins) {
      handles.push_back(twin.handle);
      truth.push_back(twin.truth);
      values.push_back(twin.value);
    }
    const auto edge = make_edge<kDynamic>(3, std::span<const Dynamic>(truth));
    const EdgeRef ref = graph.add_edge(edge, random_information(3), handles);
    mirror(ref, [edge, values] {
      std::vector<Dynamic> x;
      for (const auto& value : values) x.push_back(*value);
      return Eigen::VectorXd(edge.error(std::span<const Dynamic>(x)));
    });
  }

  std::mt19937 random_;
  std::normal_distribution<> normal_;
};

class RandomHypergraph : public testing::TestWithParam<AlgorithmKind> {};

TEST_P(RandomHypergraph, EndsAtTheOptimumOfAnIndependentDenseSolver) {
  for (unsigned seed = 0; seed < (kSanitized || is_emulated() ? 40 : 200); ++seed) {
    RandomProblem problem(seed);
    problem.build();
    ASSERT_NEAR(problem.graph.chi2(), problem.dense.cost(), 1e-10 * problem.dense.cost()) << "seed " << seed;
    Options options;
    options.algorithm = GetParam();
    options.cost_tolerance = 1e-14;
    options.noise_tolerance = 0;
    const Report report = optimize(problem.graph, options);
    const double expected = problem.dense.minimize();
    ASSERT_TRUE(report.converged()) << "seed " << seed << "\n" << to_string(report);
    ASSERT_NEAR(report.chi2_final, expected, 1e-9 * expected) << "seed " << seed << "\n" << to_string(report);
    for (const auto& distance : problem.distance) ASSERT_LT(distance(), 1e-4) << "seed " << seed;
  }
}

INSTANTIATE_TEST_SUITE_P(Algorithms, RandomHypergraph,
                         testing::Values(AlgorithmKind::kDogleg, AlgorithmKind::kLevenbergMarquardt),
                         [](const auto& test) { return test_name(test.param); });

}  // namespace
}  // namespace boxplus
