// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/incremental/smoother.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <string>

#include "boxplus/optimize/optimizer.h"
#include "incremental/closure_judge.h"
#include "incremental/lag_window.h"
#include "incremental/live_covariance.h"
#include "incremental/live_problem.h"
#include "plan/plan.h"

namespace boxplus {

namespace {

void require(bool is_right, const char* expected) {
  if (!is_right) throw InvalidArgument("SmootherOptions: expected " + std::string(expected));
}

void check(const SmootherOptions& options) {
  const auto smallest = [](const TangentDistance& distance) {
    return std::min({distance.length, distance.angle, distance.other});
  };
  require(smallest(options.relinearize) > 0, "positive distances in `relinearize`");
  require(smallest(options.noticeable) >= 0, "no negative distances in `noticeable`");
  require(options.max_iterations >= 1, "max_iterations ≥ 1");
  require(options.max_flops > 0, "max_flops > 0");
  require(!std::isnan(options.time_limit_s), "a number as time_limit_s");
  require(options.lag >= 1 && options.lag_s > 0, "lag ≥ 1 and lag_s > 0");
  require(options.false_alarm > 1e-9 && options.false_alarm < 1, "false_alarm > 1e-9 and < 1");
  const SmootherOptions defaults;
  const bool has_lag = options.lag < defaults.lag || options.lag_s < defaults.lag_s;
  require(!(options.sets_outliers_aside && has_lag), "no lag together with sets_outliers_aside");
}

}  // namespace

class Smoother::Impl {
 public:
  Impl(Graph& graph, const SmootherOptions& options) : graph_(graph), life_(graph.life()), options_(options) {
    check(options_);
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
    is_solved_ = false;
    const StopToken flag(options_.stop), limit(options_.stop, begin, options_.time_limit_s);
    work_ = {};
    try {
      options_.sets_outliers_aside ? judge(report, finishes, flag, limit) : take_changes();
      if (pending_.empty()) iterate(report, finishes, flag, limit);
      const bool is_held = !problem_->held().empty() || problem_->held_directions() > 0;
      if (finishes && report.converged() && !is_broken_ && is_held && anchor())
        iterate(report, finishes, flag, limit);
      if (is_solved_ && !is_broken_) forget(report);
    } catch (...) {
      is_broken_ = true;
      is_solved_ = false;
      if (problem_) problem_->restore();
      throw;
    }
    const double scalars = problem_->factor().scalars();
    report.vertices = problem_->block_count();
    report.edges = problem_->term_count();
    report.ordered = work_.ordered_blocks;
    report.refactored = work_.factorized_fronts;
    report.refactored_share = scalars > 0 ? work_.factorized_scalars / scalars : 0;
    report.flops = work_.flops;
    report.held_directions = static_cast<std::uint32_t>(problem_->held_directions());
    report.held.assign(problem_->held().begin(), problem_->held().end());
    for (const VertexRef& vertex : problem_->left_out()) {
      if (graph_.contains(vertex)) report.held.push_back({vertex, graph_.id(vertex)});
    }
    report.time_s = std::chrono::duration<double>(Clock::now() - begin).count();
    return report;
  }

  Eigen::MatrixXd covariance(std::span<const VertexRef> vertices) {
    if (!is_solved_) throw InvalidArgument("Smoother: expected a successful update before");
    return joint_covariance(graph_, *problem_, vertices);
  }

  EdgePreview preview(EdgeRef edge) {
    if (!is_solved_) throw InvalidArgument("Smoother: expected a successful update before");
    return preview_edge(graph_, *problem_, edge);
  }

  void set_time(VertexRef vertex, double seconds) {
    if (!graph_.contains(vertex)) throw InvalidArgument("Smoother: stale vertex handle");
    if (std::isnan(seconds)) throw InvalidArgument("Smoother: expected a time, got NaN");
    window_.set_time(vertex, seconds);
  }
  std::vector<EdgeRef> set_aside() const { return {judge_.aside().begin(), judge_.aside().end()}; }
  const SmootherOptions& options() const { return options_; }
  void set_options(const SmootherOptions& options) {
    check(options);
    options_ = options;
  }

 private:
  /// Takes over what has changed in the graph. If the function throws, the next update begins anew.
  void take_changes() {
    const bool begins = log_.everything || is_broken_;
    is_broken_ = true;
    if (begins) {
      log_.clear();
      problem_.reset();
      problem_ = std::make_unique<LiveProblem>(graph_, options_, judge_.aside());
    } else {
      problem_->apply(log_);
      log_.clear();
    }
    problem_->begin();
    if (problem_->may_be_anchored()) anchor();
  }

  /// Judges the closures that are new, and, if it is time, all of them. If the search changes any verdict,
  /// the problem begins anew from its estimates.
  void judge(SmootherReport& report, bool finishes, const StopToken& flag, const StopToken& limit) {
    const bool begins = log_.everything || is_broken_;
    std::vector<EdgeRef> held = judge_.hold_closures(graph_, begins ? everything_in(graph_) : log_);
    if (begins) {
      for (const EdgeRef& edge : held) judge_.take_back(edge);
      judge_.expect_search();
      pending_.clear();
    }
    take_changes();
    std::erase_if(pending_, [&](EdgeRef edge) { return !judge_.aside().contains(edge); });
    held.insert(held.end(), pending_.begin(), pending_.end());
    pending_.clear();
    if (!begins && !held.empty() && !judge_each(held, report, flag, limit)) return;
    if (!judge_.is_search_due(finishes)) return;
    std::vector<EdgeRef> changed;
    try {
      changed = judge_.search(graph_, options_.false_alarm, options_.stop);
    } catch (const InvalidArgument&) {
      judge_.give_up_search();  // because there is no odometry that could judge closures
    }
    for (const EdgeRef& edge : changed) {
      const bool is_aside = judge_.aside().contains(edge);
      if (std::erase(is_aside ? report.taken_back : report.set_aside, edge) == 0)
        (is_aside ? report.set_aside : report.taken_back).push_back(edge);
    }
    if (!changed.empty()) log_.everything = true, take_changes();
  }

  /// Judges new closures one by one, from a solution without them. Returns false if the stop flag was raised
  /// before: then they wait for the next update.
  bool judge_each(const std::vector<EdgeRef>& held, SmootherReport& report, const StopToken& flag,
                  const StopToken& limit) {
    iterate(report, false, flag, limit);
    if (report.reason == SmootherReport::Reason::kStopFlag) {
      pending_ = held;
      return false;
    }
    const bool can_preview = is_solved_ && !is_broken_;
    is_broken_ = true;
    std::vector<EdgeRef> needed;
    std::copy_if(held.begin(), held.end(), std::back_inserter(needed),
                 [&](EdgeRef edge) { return !can_preview || needs(edge); });
    for (const EdgeRef& edge : held) {
      if (std::find(needed.begin(), needed.end(), edge) != needed.end()) {
        judge_.take_back(edge);
      } else if (!judge_.accepts(edge, preview_edge(graph_, *problem_, edge), options_.false_alarm)) {
        report.set_aside.push_back(edge);
      }
    }
    for (const EdgeRef& edge : held) problem_->apply_verdict(edge);
    return true;
  }

  /// Whether a vertex of the edge has no other edge that takes part, or the edge joins parts of the graph.
  bool needs(EdgeRef edge) const {
    if (free_part_of(graph_, *problem_, edge)) return true;
    for (const VertexRef& vertex : graph_.vertices(edge)) {
      if (!problem_->takes_part(vertex)) return true;
    }
    return false;
  }

  /// Linearizes, factorizes and solves until no vertex has to be linearized anew.
  void iterate(SmootherReport& report, bool finishes, const StopToken& flag, const StopToken& limit) {
    using Reason = SmootherReport::Reason;
    IncrementalFactor& factor = problem_->factor();
    bool is_anchored = false;
    double farthest = std::numeric_limits<double>::infinity();
    int growths = 0;
    for (;;) {
      is_solved_ = false;
      const auto linearized = problem_->linearize(flag, report.relinearized);
      if (linearized == LiveProblem::Linearized::kStopped) return end(report, Reason::kStopFlag);
      if (linearized == LiveProblem::Linearized::kNonFinite) return fail_at_edge(report);
      const auto [status, lost, is_suspicious] = factor.factorize(flag, work_);
      if (status == LinearStatus::kStopped) return end(report, Reason::kStopFlag);
      const bool is_lost = status != LinearStatus::kOk;
      if ((is_lost || (is_suspicious && problem_->may_be_cut())) && !is_anchored) {
        is_anchored = true;
        if (anchor()) continue;
      }
      if ((is_lost || is_suspicious) && problem_->leave_out_with_few_rows()) continue;
      if (is_lost && problem_->leave_out_undetermined(lost)) continue;
      if (is_lost) return fail(report, lost);
      solved_.clear();
      finishes ? factor.solve_all(solved_) : factor.solve(solved_);
      is_solved_ = true;
      problem_->move(solved_);
      constexpr double kFinished = 1e-6;
      const double distance = problem_->relinearize(
          solved_, finishes ? kFinished : 1.0,
          finishes ? std::numeric_limits<double>::infinity() : options_.max_flops - work_.flops,
          report.iterations == 0);
      ++report.iterations;
      report.moved += static_cast<std::uint32_t>(solved_.size());
      if (!problem_->has_queued_edges())
        return end(report, problem_->has_waiting_blocks() ? Reason::kMaxFlops : Reason::kConverged);
      growths = distance > farthest && distance > 1 ? growths + 1 : 0;
      farthest = distance;
      constexpr int kMostGrowths = 3, kPatience = 12, kMostToFinish = 40;
      const bool diverges = growths >= kMostGrowths || !std::isfinite(distance);
      const bool wanders = report.iterations >= kPatience && distance > 1;
      const bool is_slow = finishes && report.iterations >= kMostToFinish;
      if (diverges || wanders || is_slow) return start_over(report, finishes);
      if (!finishes && report.iterations >= options_.max_iterations)
        return end(report, Reason::kMaxIterations);
      if (limit.raised()) return end(report, flag.raised() ? Reason::kStopFlag : Reason::kTimeLimit);
    }
  }

  /// Marginalizes what has left the lag.
  void forget(SmootherReport& report) {
    const SmootherOptions defaults;
    if (options_.lag == defaults.lag && options_.lag_s == defaults.lag_s) return;
    // The terms that are marginalized must hold at the linearization points.
    if (problem_->linearize(StopToken(), report.relinearized) != LiveProblem::Linearized::kAll) return;
    for (const VertexRef& vertex : problem_->take_new_vertices()) window_.add(graph_, vertex);
    std::vector<VertexRef> leaving = window_.take_leaving(graph_, options_.lag, options_.lag_s);
    std::erase_if(leaving, [&](VertexRef vertex) { return graph_.is_fixed(vertex); });
    if (leaving.empty()) return;
    const auto stays = [&](VertexRef vertex) { return window_.contains(vertex); };
    const std::vector<VertexRef> followers = problem_->followers(leaving, stays);
    leaving.insert(leaving.end(), followers.begin(), followers.end());
    problem_->marginalize(leaving);
    report.marginalized = static_cast<std::uint32_t>(leaving.size() + problem_->remove_stranded());
  }

  /// Ends an update that the next one can continue.
  void end(SmootherReport& report, SmootherReport::Reason reason) {
    is_broken_ = false;
    report.reason = reason;
  }

  /// Gauss-Newton steps diverge: lets optimize() look for the optimum, from the estimates before the update.
  void start_over(SmootherReport& report, bool finishes) {
    problem_->restore();
    is_solved_ = false;
    Options options{.start = Start::kAutomatic, .threads = 1};
    options.stop = options_.stop;
    if (!finishes) options.time_limit_s = options_.time_limit_s;
    options.numeric_jacobians = options_.numeric_jacobians;
    if (finishes) {  // however small the steps are
      constexpr int kMostIterations = 2000;
      options.noise_tolerance = 0;
      options.cost_tolerance = 1e-15;
      options.max_iterations = kMostIterations;
    }
    Graph copy = judge_.copy_without_aside(graph_);
    const Report batch = optimize(copy, options);
    take_estimates(graph_, copy);
    log_.everything = true;
    report.started_over = true;
    report.reason = batch.converged()                            ? SmootherReport::Reason::kConverged
                    : batch.reason == Report::Reason::kStopFlag  ? SmootherReport::Reason::kStopFlag
                    : batch.reason == Report::Reason::kTimeLimit ? SmootherReport::Reason::kTimeLimit
                                                                 : SmootherReport::Reason::kMaxIterations;
    if (!batch.converged()) return;
    take_changes();
    const auto factorize = [&] {
      return problem_->linearize(StopToken(), report.relinearized) == LiveProblem::Linearized::kAll &&
             problem_->factor().factorize(StopToken(), work_).status == LinearStatus::kOk;
    };
    is_solved_ = factorize() || (anchor() && factorize());
    if (is_solved_) is_broken_ = false;
  }

  /// Holds vertices and directions of components that nothing anchors, and no others. Returns false if
  /// nothing changes.
  bool anchor() {
    problem_->forget_cuts();
    const std::vector<EdgeRef> edges = problem_->edges();
    return problem_->hold(edges.empty() ? Plan() : make_plan(graph_, {.edges = edges}));
  }

  void fail(SmootherReport& report, LiveProblem::Index block) {
    report.reason = SmootherReport::Reason::kNotDetermined;
    report.message =
        "vertex " + std::to_string(graph_.id(problem_->vertex(block))) + " is not determined by its edges";
    problem_->restore();
    is_solved_ = false;
  }

  void fail_at_edge(SmootherReport& report) {
    report.reason = SmootherReport::Reason::kNonFinite;
    report.message = "the error or the Jacobian of an edge is not finite: edge of";
    for (const VertexRef& vertex : graph_.vertices(problem_->non_finite()))
      report.message +=
          (report.message.ends_with("of") ? " vertex " : ", ") + std::to_string(graph_.id(vertex));
    problem_->restore();
    is_solved_ = false;
  }

  Graph& graph_;
  std::shared_ptr<detail::LifeState> life_;
  SmootherOptions options_;
  detail::ChangeLog log_;
  ClosureJudge judge_;
  std::unique_ptr<LiveProblem> problem_;
  FactorWork work_;  // of the current update
  LagWindow window_;
  std::vector<EdgeRef> pending_;  // closures that could not be judged yet
  std::vector<LiveProblem::Index> solved_;
  bool is_broken_ = false;  // the next update begins anew
  bool is_solved_ = false;  // the last update has a factor and a solution
};

std::string_view to_string(SmootherReport::Reason reason) {
  switch (reason) {
    case SmootherReport::Reason::kConverged:
      return "converged";
    case SmootherReport::Reason::kMaxIterations:
      return "maximum number of iterations";
    case SmootherReport::Reason::kMaxFlops:
      return "operations limit";
    case SmootherReport::Reason::kTimeLimit:
      return "time limit";
    case SmootherReport::Reason::kStopFlag:
      return "stop flag";
    case SmootherReport::Reason::kNonFinite:
      return "not finite";
    case SmootherReport::Reason::kNotDetermined:
      return "not determined";
  }
  return "unknown";
}

Smoother::Smoother(Graph& graph, const SmootherOptions& options)
    : impl_(std::make_unique<Impl>(graph, options)) {}
Smoother::~Smoother() = default;
Smoother::Smoother(Smoother&&) noexcept = default;
Smoother& Smoother::operator=(Smoother&&) noexcept = default;

SmootherReport Smoother::update() {
  return impl_->update(false);
}

SmootherReport Smoother::finish() {
  return impl_->update(true);
}

std::vector<EdgeRef> Smoother::set_aside() const {
  return impl_->set_aside();
}

void Smoother::set_time(VertexRef vertex, double seconds) {
  impl_->set_time(vertex, seconds);
}

Eigen::MatrixXd Smoother::covariance(std::span<const VertexRef> vertices) const {
  return impl_->covariance(vertices);
}

EdgePreview Smoother::preview(EdgeRef edge) const {
  return impl_->preview(edge);
}

const SmootherOptions& Smoother::options() const {
  return impl_->options();
}

void Smoother::set_options(const SmootherOptions& options) {
  impl_->set_options(options);
}

}  // namespace boxplus
