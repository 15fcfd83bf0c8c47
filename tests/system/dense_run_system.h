// SPDX-License-Identifier: BSD-3-Clause
// A System of a run that has nothing in common with BatchSystem: dense matrices by the textbook formulas.
#pragma once

#include <Eigen/Cholesky>
#include <limits>
#include <vector>

#include "linearize/dense_reference.h"
#include "system/run_system.h"

namespace boxplus {

/// Suits graphs without bounds, fixed directions and gauge freedom.
class DenseRunSystem final : public RunSystem {
 public:
  explicit DenseRunSystem(Graph& graph, const PlanRequest& request = {})
      : graph_(graph), plan_(make_plan(graph, request)), trial_(graph, plan_) {}

  double chi2() override {
    if (is_stopped()) return std::numeric_limits<double>::quiet_NaN();
    double sum = 0;
    for (const EdgeList& list : plan_.edges) {
      const detail::EdgePool& pool = *graph_.edge_pools()[list.pool];
      for (const std::uint32_t edge : list.edges) {
        double value = 0;
        pool.chi2(std::span(&edge, 1), &value);
        sum += value;
      }
    }
    return sum;
  }
  bool linearize() override {
    trial_.order().expect_no_trial("System::linearize");
    trial_.order().linearized();
    if (is_stopped()) return false;
    dense_ = dense_reference(graph_, plan_);
    diagonal_ = dense_.hessian.diagonal();
    return dense_.hessian.allFinite() && dense_.gradient.allFinite();
  }
  bool stopped() const override { return stopped_; }
  std::span<const double> gradient() const override { return view(dense_.gradient); }
  std::span<const double> diagonal() const override { return view(diagonal_); }
  double curvature(std::span<const double> d) override {
    const auto along = vector(d);
    return along.dot(dense_.hessian * along);
  }
  StepResult solve(const StepDamping& damping, std::span<double> step) override {
    trial_.order().expect_vector("System::solve", step.size(), plan_.scalars());
    if (stopped_) return {LinearStatus::kStopped};
    if (!dense_.hessian.allFinite() || !dense_.gradient.allFinite()) return {LinearStatus::kNotFinite};
    Eigen::MatrixXd damped = dense_.hessian;
    if (damping.scale == Options::DampingScale::kIdentity) {
      damped.diagonal().array() += damping.lambda;
    } else {
      damped.diagonal() += damping.lambda * diagonal_;
    }
    const Eigen::LLT<Eigen::MatrixXd> factor(damped);
    if (factor.info() != Eigen::Success) return {LinearStatus::kNotPositiveDefinite};
    Eigen::Map<Eigen::VectorXd>(step.data(), dense_.gradient.size()) = factor.solve(-dense_.gradient);
    return {.exact = true};
  }
  double try_step(std::span<const double> step) override {
    trial_.order().expect_vector("System::try_step", step.size(), plan_.scalars());
    return trial_.try_step(
        {.step = step, .diagonal = diagonal(), .arrive = [] {}, .chi2 = [this] { return chi2(); }});
  }

  Facts facts() const override { return {.solver = "dense reference", .statistics = {}}; }
  const Plan& plan() const override { return plan_; }
  const LinearizeOptions& linearize_options() const override { return options_; }
  void set_stop(const StopToken& stop) override { stop_ = stop; }
  Trial& trial() override { return trial_; }
  VertexRef failed_vertex() const override { return plan_.block_vertex.front(); }

 private:
  static std::span<const double> view(const Eigen::VectorXd& v) {
    return {v.data(), static_cast<std::size_t>(v.size())};
  }
  static Eigen::Map<const Eigen::VectorXd> vector(std::span<const double> v) {
    return {v.data(), static_cast<Eigen::Index>(v.size())};
  }
  bool is_stopped() { return stopped_ = stop_.raised(); }

  Graph& graph_;
  Plan plan_;
  Trial trial_;
  DenseSystem dense_;
  Eigen::VectorXd diagonal_;
  LinearizeOptions options_;
  StopToken stop_;
  bool stopped_ = false;
};

}  // namespace boxplus
