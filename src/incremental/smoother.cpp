// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/incremental/smoother.h"

#include <chrono>
#include <cmath>
#include <limits>
#include <string>

#include "boxplus/optimize/optimizer.h"
#include "incremental/live_problem.h"
#include "plan/plan.h"

namespace boxplus {

class Smoother::Impl {
 public:
  Impl(Graph& graph, SmootherOptions options)
      : graph_(graph), life_(graph.life()), options_(std::move(options)) {
    if (graph.change_log() != nullptr) throw InvalidArgument("Smoother: the graph has a Smoother already");
    log_.everything = true;
    graph.set_change_log(&log_);
  }
  ~Impl() {
    if (!life_->is_over) graph_.set_change_log(nullptr);
  }

  /// Updates the estimates, or finishes them.
  SmootherReport update(bool finishes) {
    using Clock = std::chrono::steady_clock;
    const Clock::time_point begin = Clock::now();
    if (life_->is_over) throw InvalidArgument("Smoother: its graph was destroyed or moved");
    SmootherReport report;
    const StopToken flag(options_.stop), limit(options_.stop, begin, options_.time_limit_s);
    take_changes();
    work_ = {};
    try {
      iterate(report, finishes, flag, limit);
    } catch (...) {
      problem_->restore();
      throw;
    }
    const double scalars = problem_->factor().scalars();
    report.vertices = problem_->block_count();
    report.edges = problem_->term_count();
    report.ordered = work_.ordered_blocks;
    report.refactored = work_.factorized_fronts;
    report.refactored_share = scalars > 0 ? work_.factorized_scalars / scalars : 0;
    report.flops = work_.flops;
    report.held.assign(problem_->held().begin(), problem_->held().end());
    report.time_s = std::chrono::duration<double>(Clock::now() - begin).count();
    return report;
  }

  SmootherOptions& options() { return options_; }

 private:
  /// Takes over what has changed in the graph. If the function throws, the next update begins anew.
  void take_changes() {
    const bool begins = log_.everything || is_broken_;
    is_broken_ = true;
    if (begins) {
      log_.clear();
      problem_.reset();
      problem_ = std::make_unique<LiveProblem>(graph_, options_);
    } else {
      problem_->apply(log_);
      log_.clear();
    }
    problem_->begin();
    if (problem_->may_be_anchored()) anchor();
  }

  /// Linearizes, factorizes and solves until no vertex has to be linearized anew.
  void iterate(SmootherReport& report, bool finishes, const StopToken& flag, const StopToken& limit) {
    using Reason = SmootherReport::Reason;
    IncrementalFactor& factor = problem_->factor();
    bool is_anchored = false;
    double farthest = std::numeric_limits<double>::infinity();
    int growths = 0;
    for (;;) {
      if (!problem_->linearize(flag, report.relinearized)) return end(report, Reason::kStopFlag);
      const auto [status, lost, is_suspicious] = factor.factorize(flag, work_);
      if (status == LinearStatus::kStopped) return end(report, Reason::kStopFlag);
      const bool is_lost = status != LinearStatus::kOk;
      if ((is_lost || is_suspicious) && !is_anchored) {
        is_anchored = true;
        if (anchor()) continue;
      }
      if (is_lost) return fail(report, lost);
      solved_.clear();
      finishes ? factor.solve_all(solved_) : factor.solve(solved_);
      problem_->move(solved_);
      constexpr double kFinished = 1e-4;
      const double distance = problem_->relinearize(solved_, finishes ? kFinished : 1.0);
      ++report.iterations;
      report.moved += static_cast<std::uint32_t>(solved_.size());
      if (!problem_->has_queued_edges()) return end(report, Reason::kConverged);
      growths = distance > farthest ? growths + 1 : 0;
      farthest = distance;
      constexpr int kMostGrowths = 3;
      if (growths >= kMostGrowths || !std::isfinite(distance)) return start_over(report);
      if (report.iterations >= options_.max_iterations) return end(report, Reason::kMaxIterations);
      if (limit.raised()) return end(report, flag.raised() ? Reason::kStopFlag : Reason::kTimeLimit);
    }
  }

  /// Ends an update that the next one can continue.
  void end(SmootherReport& report, SmootherReport::Reason reason) {
    is_broken_ = false;
    report.reason = reason;
  }

  /// Gauss-Newton steps diverge: lets optimize() look for the optimum, from the estimates before the update.
  void start_over(SmootherReport& report) {
    problem_->restore();
    Options options{.start = Start::kAutomatic, .threads = 1};
    options.stop = options_.stop;
    options.numeric_jacobians = options_.numeric_jacobians;
    const Report batch = optimize(graph_, options);
    report.started_over = true;
    report.reason = batch.converged()                            ? SmootherReport::Reason::kConverged
                    : batch.reason == Report::Reason::kStopFlag ? SmootherReport::Reason::kStopFlag
                                                                 : SmootherReport::Reason::kMaxIterations;
  }

  /// Holds vertices and directions of components that nothing anchors, and no others. Returns false if
  /// nothing changes.
  bool anchor() {
    return problem_->hold(make_plan(graph_, {}));
  }

  void fail(SmootherReport& report, LiveProblem::Index block) {
    report.reason = SmootherReport::Reason::kNotDetermined;
    report.message = "vertex " + std::to_string(graph_.id(problem_->vertex(block))) +
                     " is not determined by its edges";
    problem_->restore();
  }

  Graph& graph_;
  std::shared_ptr<detail::LifeState> life_;
  SmootherOptions options_;
  detail::ChangeLog log_;
  std::unique_ptr<LiveProblem> problem_;
  FactorWork work_;  // of the current update
  std::vector<LiveProblem::Index> solved_;
  bool is_broken_ = false;  // the next update begins anew
};

Smoother::Smoother(Graph& graph, SmootherOptions options)
    : impl_(std::make_unique<Impl>(graph, std::move(options))) {}
Smoother::~Smoother() = default;
Smoother::Smoother(Smoother&&) noexcept = default;
Smoother& Smoother::operator=(Smoother&&) noexcept = default;

SmootherReport Smoother::update() {
  return impl_->update(false);
}

SmootherReport Smoother::finish() {
  return impl_->update(true);
}

const SmootherOptions& Smoother::options() const {
  return impl_->options();
}

void Smoother::set_options(const SmootherOptions& options) {
  impl_->options() = options;
}

}  // namespace boxplus
