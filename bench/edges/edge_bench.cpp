// SPDX-License-Identifier: BSD-3-Clause
// Compares custom edges of boxplus with Ceres (automatic differentiation) and with a handwritten loop. Prints
// a table that `make bench` appends to bench/RESULTS.md.
//
//     edge_bench             measures boxplus, Ceres and the handwritten loop
//     edge_bench dual        repeats only boxplus with dual numbers, for a profiler
//     edge_bench analytic    repeats only boxplus with analytic Jacobians, for a profiler
#include <fmt/core.h>

#include <Eigen/Cholesky>
#include <cstring>
#include <exception>
#include <stdexcept>

#include "boxplus/boxplus.h"
#include "datasets/interleave.h"
#include "datasets/open_blas.h"
#include "edges/ceres_icp.h"
#include "edges/icp_numbers.h"

namespace boxplus::bench {
namespace {

/// An edge whose error is a template of the scalar type, so that dual numbers can differentiate it.
struct Plane {
  Vector3 p, q, n;

  explicit Plane(const Match& match) : p(match.p.data()), q(match.q.data()), n(match.n.data()) {}
  template <class S>
  S error(const BasicSE3<S>& pose) const {
    const Vector<S, 3> world = pose * p;
    return n[0] * (world[0] - q[0]) + n[1] * (world[1] - q[1]) + n[2] * (world[2] - q[2]);
  }
};

/// The same edge with analytic Jacobians: T ⊞ δ moves p by R δ_t + 2 R (δ_q × p).
struct PlaneWithJacobians : Plane {
  using Plane::Plane;
  template <class J>
  void jacobians(const SE3& pose, J&& out) const {
    const Vector3 m = detail::rotate(pose.quaternion().conjugate(), n[0], n[1], n[2]);
    out(0, 0) = m[0];
    out(0, 1) = m[1];
    out(0, 2) = m[2];
    out(0, 3) = 2 * (p[1] * m[2] - p[2] * m[1]);
    out(0, 4) = 2 * (p[2] * m[0] - p[0] * m[2]);
    out(0, 5) = 2 * (p[0] * m[1] - p[1] * m[0]);
  }
};

template <class Edge>
Graph make_graph(const IcpProblem& problem) {
  Graph graph;
  const auto& x = problem.start;
  const auto pose =
      graph.add_vertex(SE3(Vector3(x[0], x[1], x[2]), detail::Quaternion<double>{x[3], x[4], x[5], x[6]}));
  for (const Match& match : problem.matches) graph.add_edge(Edge(match), pose);
  return graph;
}

IcpRun run_ours(Graph& graph) {
  std::vector<double> marks;
  Options options{.max_iterations = kIcpIterations, .cost_tolerance = 0, .threads = 1};
  options.start = Start::kCurrent;
  options.step_tolerance = options.gradient_tolerance = 0;
  options.callback = [&](const IterationRecord&) {
    marks.push_back(thread_seconds());
    return true;
  };
  graph.push();
  const Report report = optimize(graph, options);
  graph.pop();
  return {median_iteration(marks), report.chi2_final};
}

/// The sums of JᵀJ, Jᵀe and chi2 over all matches.
struct NormalEquations {
  double H[6][6] = {}, b[6] = {}, chi2 = 0;
};

__attribute__((noinline)) void accumulate_by_hand(const SE3& pose, const std::vector<Match>& matches,
                                                  NormalEquations& sums) {
  const Matrix<double, 3, 3> R = pose.rotation();
  const Vector3 t = pose.translation();
  sums = {};
  for (const Match& match : matches) {
    const Vector3 p(match.p.data()), q(match.q.data()), n(match.n.data());
    const double e = n.dot(R * p + t - q);
    const Vector3 m = R.transpose() * n;
    const double J[6] = {m[0],
                         m[1],
                         m[2],
                         2 * (p[1] * m[2] - p[2] * m[1]),
                         2 * (p[2] * m[0] - p[0] * m[2]),
                         2 * (p[0] * m[1] - p[1] * m[0])};
    for (int i = 0; i < 6; ++i) {
      for (int j = 0; j <= i; ++j) sums.H[i][j] += J[i] * J[j];
      sums.b[i] += J[i] * e;
    }
    sums.chi2 += e * e;
  }
}

IcpRun run_by_hand(const IcpProblem& problem) {
  const auto& x = problem.start;
  SE3 pose(Vector3(x[0], x[1], x[2]), detail::Quaternion<double>{x[3], x[4], x[5], x[6]});
  std::vector<double> marks;
  NormalEquations sums;
  for (int k = 0; k < kIcpIterations; ++k) {
    accumulate_by_hand(pose, problem.matches, sums);
    Matrix<double, 6, 6> H;
    Vector<double, 6> b;
    for (int i = 0; i < 6; ++i) {
      for (int j = 0; j <= i; ++j) H(i, j) = H(j, i) = sums.H[i][j];
      b[i] = sums.b[i];
    }
    const Vector<double, 6> step = H.ldlt().solve(-b);
    pose = Manifold<SE3>::oplus(pose, step.data());
    marks.push_back(thread_seconds());
  }
  accumulate_by_hand(pose, problem.matches, sums);
  return {median_iteration(marks), sums.chi2};
}

void require_equal(const char* what, double a, double b) {
  if (std::abs(a - b) <= 1e-9 * std::abs(a)) return;
  throw std::runtime_error(fmt::format("{}: expected {:.15g} within 1e-9, got {:.15g}", what, a, b));
}

void print_comparison(std::size_t count) {
  const IcpProblem problem = make_icp_problem(count);
  Graph automatic = make_graph<Plane>(problem), analytic = make_graph<PlaneWithJacobians>(problem);
  CeresIcp ceres(problem);
  const auto figures = [](const IcpRun& run) { return Figures{run.iteration_s, run.chi2}; };
  const auto medians = interleaved_medians(
      {[&] { return figures(run_ours(automatic)); }, [&] { return figures(run_ours(analytic)); },
       [&] { return figures(ceres.run(true)); }, [&] { return figures(ceres.run(false)); },
       [&] { return figures(run_by_hand(problem)); }},
      {.least = 9, .most = 25, .enough_s = 10});
  for (const Figures& figure : medians) require_equal("chi2 at the end", medians[4][1], figure[1]);
  const auto ms = [&](int k) { return 1e3 * medians[static_cast<std::size_t>(k)][0]; };
  const double peer = std::min(ms(2), ms(3));
  fmt::print("| {} | {:.2f} | {:.2f} | {:.2f} | {:.2f} | {:.2f} | {:.2f} | {:.2f} |\n", count, ms(0), peer,
             peer / ms(0), ms(1), peer / ms(1), ms(4), ms(1) / ms(4));
}

/// Repeats boxplus with the edges that `which` names ("dual" or "analytic"), for a profiler.
void repeat(const char* which, std::size_t count) {
  const IcpProblem problem = make_icp_problem(count);
  Graph graph = std::strcmp(which, "analytic") == 0 ? make_graph<PlaneWithJacobians>(problem)
                                                    : make_graph<Plane>(problem);
  constexpr int kRuns = 200;
  for (int k = 0; k < kRuns; ++k) run_ours(graph);
}

}  // namespace
}  // namespace boxplus::bench

int main(int count, char** words) try {
  using namespace boxplus::bench;
  if (count > 1) {
    repeat(words[1], 20'000);
    return 0;
  }
  require_open_blas_with_one_thread();
  fmt::print(
      "\n## Edges of a user\n\n"
      "Point-to-plane ICP: one pose, and for each point one edge with one row. CPU time in ms per\n"
      "iteration on one thread. Ceres uses the faster of DENSE_QR and DENSE_NORMAL_CHOLESKY. By hand: a\n"
      "loop that adds up JᵀJ and Jᵀe and solves a 6 × 6 system. The last column is the time with\n"
      "Jacobians divided by the time by hand.\n\n"
      "| points | dual numbers | Ceres, autodiff | × | with Jacobians | × | by hand | ratio |\n"
      "|--:|--:|--:|--:|--:|--:|--:|--:|\n");
  for (const std::size_t points : {2'000u, 20'000u, 200'000u}) print_comparison(points);
  return 0;
} catch (const std::exception& error) {
  fmt::print(stderr, "edge_bench: {}\n", error.what());
  return 1;
}
