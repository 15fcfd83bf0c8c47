// SPDX-License-Identifier: BSD-3-Clause
// A custom robust kernel: the logarithm of the hyperbolic cosine. It is similar to Huber's kernel, but
// smooth.
//
// A kernel computes the cost ρ(e²) of an edge from the squared error e² = eᵀΩe, and the first two derivatives
// of ρ.
#include <boxplus/boxplus.h>
#include <boxplus/robust/kernel_base.h>
#include <boxplus/testing/check_kernel.h>

#include <cmath>
#include <cstdio>

using namespace boxplus;

// [kernel]
/// ρ = 2δ² ln cosh(e/δ). It is about e² for small errors and about 2δ|e| for large errors.
class LogCosh final : public KernelBase<LogCosh> {
 public:
  static constexpr std::string_view kName = "LogCosh";
  explicit LogCosh(double delta) : KernelBase(delta) {}

  Rho operator()(double e2) const override {
    const double d2 = delta_ * delta_, t = e2 / d2;
    if (t < 1e-4) return {e2 * (1 - t / 6), 1 - t / 3 + t * t * 2 / 15, (-1 + t * 4 / 5) / (3 * d2)};
    const double s = std::sqrt(t), tangent = std::tanh(s);
    const double log_cosh = s + std::log1p(std::exp(-2 * s)) - std::log(2.0);  // std::cosh(s) would overflow
    return {2 * d2 * log_cosh, tangent / s, ((1 - tangent * tangent) - tangent / s) / (2 * e2)};
  }
};
// [/kernel]

bool contract_holds() {
  // [check_kernel]
  const KernelCheck check = check_kernel(LogCosh(0.7));
  if (!check) std::printf("%s\n", check.message.c_str());
  // [/check_kernel]
  return check.ok;
}

int main() {
  // Estimates the position of a wall from five echoes. One of the echoes is wrong.
  Graph graph;
  const auto wall = graph.add_vertex(0.0);  // a plain double is a vertex, too
  for (const double echo : {4.9, 5.1, 5.0, 5.05, 40.0}) {
    const auto edge = graph.add_edge([echo](const auto& x) { return x - echo; }, 100.0, wall);
    graph.set_kernel(edge, LogCosh(1));
  }
  const Report report = optimize(graph);
  std::printf("the wall is at %.2f m; the mean of the echoes says 12.01 m\n", graph.estimate(wall));
  return report.converged() && std::abs(graph.estimate(wall) - 5.05) < 0.05 && contract_holds() ? 0 : 1;
}
