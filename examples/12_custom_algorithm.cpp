// SPDX-License-Identifier: BSD-3-Clause
// A custom algorithm: implements the interface in boxplus/algorithm/algorithm.h as Gauss-Newton with a line
// search.
//
// An algorithm uses neither the graph nor matrices, but only the class System. It asks the System to
// linearize, to compute a step, and to try the step. Then it accepts or rejects the step.
#include <boxplus/algorithm/algorithm.h>
#include <boxplus/boxplus.h>

#include <cstddef>
#include <cstdio>
#include <vector>

using namespace boxplus;

// [algorithm]
class LineSearch final : public Algorithm {
 public:
  std::string_view name() const override { return "line search"; }
  void reset(const Options& /*options*/, std::size_t scalars) override { step_.resize(scalars); }

  IterationOutcome iterate(System& system, double chi2, IterationRecord& record) override {
    if (!system.linearize()) return IterationOutcome::kNotFinite;
    if (system.solve({}, step_).status != LinearStatus::kOk) return IterationOutcome::kNotPositiveDefinite;
    for (std::size_t k = 0; k < step_.size(); ++k)
      record.predicted_decrease -= system.gradient()[k] * step_[k];
    for (record.tries = 1; record.tries < 30; ++record.tries) {
      if (system.try_step(step_) < chi2) {
        system.accept();
        return IterationOutcome::kAccepted;
      }
      system.reject();
      for (double& entry : step_) entry /= 2;
    }
    return IterationOutcome::kNoFurtherDecrease;
  }

 private:
  std::vector<double> step_;
};
// [/algorithm]

int main() {
  Graph graph;
  const auto x = graph.add_vertex(Vector2(-1.2, 1));  // Rosenbrock's function has its minimum at (1, 1)
  graph.add_edge([](const auto& p) { return 10.0 * (p[1] - p[0] * p[0]); }, x);
  graph.add_edge([](const auto& p) { return 1.0 - p[0]; }, x);

  // [run]
  LineSearch line_search;
  const Report report = Optimizer(graph).run(line_search);
  // [/run]
  const Vector2 found = graph.estimate(x);
  std::printf("%d iterations: (%.6f, %.6f)\n", report.iterations, found[0], found[1]);
  return (found - Vector2(1, 1)).norm() < 1e-6 ? 0 : 1;
}
