// SPDX-License-Identifier: BSD-3-Clause
// A custom inexact linear solver for A x = b: conjugate gradients that stop at a given tolerance.
//
// The solver needs only the diagonal blocks of A, and products of A with vectors. It stops when the residual
// reaches the tolerance in SolveControl (the forcing term of an inexact Newton method), or when the stop
// token is raised. It does not report its solution as exact, so the optimization algorithm needs one more
// product with A to compute the predicted decrease of chi2.
#include <boxplus/boxplus.h>
#include <boxplus/linear/linear_solver.h>

#include <Eigen/Core>
#include <cmath>
#include <cstdio>
#include <memory>
#include <random>
#include <vector>

using namespace boxplus;

// [solver]
class JacobiCg final : public LinearSolver {
 public:
  std::string_view name() const override { return "jacobi_cg"; }
  Needs needs() const override { return Needs::kOperator; }

  void analyze(const BlockStructure& structure, const AnalyzeHints& /*hints*/,
               const StopToken& /*stop*/) override {
    structure_ = &structure;
    for (auto* vector : {&diagonal_, &damping_, &r_, &z_, &p_, &q_}) vector->resize(structure.scalars());
    std::size_t values = 0;
    for (std::uint32_t j = 0; j < structure.blocks(); ++j) values += structure.dim(j) * structure.dim(j);
    diagonal_blocks_.resize(values);
  }

  /// Computes no factorization. Stores the diagonal of A + λD as the preconditioner, and a pointer to A for
  /// products.
  FactorResult factorize(const BlockSystem& system, const Damping& damping,
                         const SolveControl& /*control*/) override {
    system_ = &system;
    system.block_diagonal(diagonal_blocks_.data());
    const double* block = diagonal_blocks_.data();
    for (std::uint32_t j = 0; j < structure_->blocks(); ++j) {
      const std::uint32_t dim = structure_->dim(j), first = structure_->offset[j];
      for (std::uint32_t k = 0; k < dim; ++k) {
        damping_[first + k] = damping(first + k);
        diagonal_[first + k] = block[k * (dim + 1)] + damping_[first + k];
        if (!(diagonal_[first + k] > 0)) return {LinearStatus::kNotPositiveDefinite, j, first + k};
      }
      block += dim * dim;
    }
    return {};
  }

  /// Starts from x = 0. The arrays b and x may be the same.
  SolveResult solve(const double* b, int columns, double* x, const SolveControl& control) override {
    SolveResult total;  // total.exact stays false
    for (int c = 0; c < columns && total.status == LinearStatus::kOk; ++c, b += r_.size(), x += r_.size()) {
      r_ = Eigen::Map<const Eigen::VectorXd>(b, r_.size());
      Eigen::Map<Eigen::VectorXd> solution(x, r_.size());
      solution.setZero();
      total.status = iterate(solution, control, total.iterations);
    }
    return total;
  }

 private:
  LinearStatus iterate(Eigen::Map<Eigen::VectorXd>& x, const SolveControl& control, int& iterations) {
    const double target = control.relative_tolerance * r_.norm();
    const Eigen::Index most = control.max_iterations > 0 ? control.max_iterations : 2 * r_.size() + 100;
    double previous = 1;
    p_.setZero();
    for (Eigen::Index k = 0; r_.norm() > target; ++k, ++iterations) {
      if (control.stop.raised()) return LinearStatus::kStopped;
      if (k == most) return LinearStatus::kNotConverged;
      z_ = r_.cwiseQuotient(diagonal_);
      const double rz = r_.dot(z_);
      p_ = z_ + rz / previous * p_;
      previous = rz;
      system_->multiply(p_.data(), q_.data());
      q_ += damping_.cwiseProduct(p_);
      const double curvature = p_.dot(q_);
      if (!(curvature > 0)) return LinearStatus::kNotPositiveDefinite;
      x += rz / curvature * p_;
      r_ -= rz / curvature * q_;
    }
    return LinearStatus::kOk;
  }

  const BlockStructure* structure_ = nullptr;
  const BlockSystem* system_ = nullptr;
  std::vector<double> diagonal_blocks_;
  Eigen::VectorXd diagonal_, damping_, r_, z_, p_, q_;
};
// [/solver]

/// A robot drives two laps around a circle. It measures each pose of the second lap from the previous pose
/// and also from the pose one lap earlier.
Graph circle() {
  constexpr int kLap = 40;
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0, 0.02);
  const SE2 step(1, 0, 2 * kPi / kLap);
  const auto noisy = [&](const SE2& motion) {
    return motion * SE2(noise(random), noise(random), noise(random));
  };
  Graph graph;
  std::vector<VertexHandle<SE2>> poses{graph.add_vertex(SE2())};
  graph.fix(poses[0]);
  for (int k = 1; k <= 2 * kLap; ++k) {
    const SE2 measured = noisy(step);
    poses.push_back(graph.add_vertex(graph.estimate(poses.back()) * measured));
    graph.add_edge(Between(measured), 2500.0, poses[k - 1], poses[k]);
    if (k >= kLap) graph.add_edge(Between(noisy(SE2())), 2500.0, poses[k - kLap], poses[k]);
  }
  return graph;
}

int main() {
  Graph by_factor = circle(), by_cg = by_factor;
  const double expected = optimize(by_factor).chi2_final;

  // [use]
  Options options;
  options.custom_linear_solver = std::make_shared<JacobiCg>();
  options.linear_tolerance = 0.1;  // cheaper steps, but usually more iterations
  const Report report = optimize(by_cg, options);
  // [/use]
  int products = 0;
  for (const IterationRecord& record : report.records) products += record.linear_iterations;
  std::printf("%d iterations with %d products, chi2 %.6f (with a factorization: %.6f)\n", report.iterations,
              products, report.chi2_final, expected);
  return report.converged() && std::abs(report.chi2_final - expected) < 1e-4 * expected ? 0 : 1;
}
