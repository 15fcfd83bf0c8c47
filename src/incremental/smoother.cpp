// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/incremental/smoother.h"

#include <chrono>
#include <string>

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
    iterate(report, finishes, flag, limit);
    report.vertices = problem_->block_count();
    report.edges = problem_->term_count();
    report.held = held_;
    report.time_s = std::chrono::duration<double>(Clock::now() - begin).count();
    return report;
  }

  SmootherOptions& options() { return options_; }

 private:
  /// Takes over what has changed in the graph. If the function throws, the next update begins anew.
  void take_changes() {
    if (log_.everything || is_broken_) {
      is_broken_ = true;
      problem_.reset();
      problem_ = std::make_unique<LiveProblem>(graph_, options_);
      held_.clear();
    } else {
      is_broken_ = true;
      problem_->apply(log_);
    }
    log_.clear();
    is_broken_ = false;
  }

  void iterate(SmootherReport& report, bool finishes, const StopToken& flag, const StopToken& limit) {
    using Reason = SmootherReport::Reason;
    IncrementalFactor& factor = problem_->factor();
    FactorWork work;
    bool is_anchored = false;
    is_broken_ = true;
    for (;;) {
      if (!problem_->linearize(flag, report.relinearized)) return stop(report, Reason::kStopFlag);
      const auto [status, lost] = factor.factorize(flag, work);
      if (status == LinearStatus::kStopped) return stop(report, Reason::kStopFlag);
      if (status != LinearStatus::kOk) {
        if (is_anchored || !anchor()) return complain(report, lost);
        is_anchored = true;
        continue;
      }
      solved_.clear();
      finishes ? factor.solve_all(solved_) : factor.solve(solved_);
      problem_->move(solved_);
      constexpr double kFinished = 1e-4;
      problem_->relinearize(solved_, finishes ? kFinished : 1.0);
      ++report.iterations;
      report.moved += static_cast<std::uint32_t>(solved_.size());
      if (!problem_->has_queued_edges()) break;
      if (report.iterations >= options_.max_iterations) {
        report.reason = Reason::kMaxIterations;
        break;
      }
      if (limit.raised()) {
        report.reason = flag.raised() ? Reason::kStopFlag : Reason::kTimeLimit;
        break;
      }
    }
    is_broken_ = false;
    report.ordered = work.ordered_blocks;
    report.refactored = work.factorized_fronts;
    report.refactored_share = factor.scalars() > 0 ? work.factorized_scalars / static_cast<double>(factor.scalars()) : 0;
    report.flops = work.flops;
  }

  void stop(SmootherReport& report, SmootherReport::Reason reason) {
    is_broken_ = false;
    report.reason = reason;
  }

  /// Holds vertices of components that nothing anchors. Returns false if there are none.
  bool anchor() {
    PlanRequest request;
    const Plan plan = make_plan(graph_, request);
    if (plan.held.empty()) return false;
    held_ = plan.held;
    problem_->hold(held_);
    return true;
  }

  void complain(SmootherReport& report, LiveProblem::Index block) {
    report.reason = SmootherReport::Reason::kNotDetermined;
    report.message = "vertex " + std::to_string(graph_.id(problem_->vertex(block))) +
                     " is not determined by its edges";
  }

  Graph& graph_;
  std::shared_ptr<detail::LifeState> life_;
  SmootherOptions options_;
  detail::ChangeLog log_;
  std::unique_ptr<LiveProblem> problem_;
  std::vector<detail::GaugeVertex> held_;
  std::vector<LiveProblem::Index> solved_;
  bool is_broken_ = false;
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
