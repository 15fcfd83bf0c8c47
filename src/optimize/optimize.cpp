// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/optimize/optimize.h"

#include <algorithm>
#include <cmath>

#include "boxplus/optimize/initial_guess.h"
#include "optimize/minimize.h"
#include "optimize/session.h"

namespace boxplus {
namespace {

void check(const Options& options) {
  const auto require = [](bool holds, const char* what) {
    if (!holds) throw InvalidArgument(std::string("Options: expected ") + what);
  };
  require(options.max_iterations >= 0, "max_iterations ≥ 0");
  require(options.threads >= 0, "threads ≥ 0");
  require(options.cost_tolerance >= 0, "cost_tolerance ≥ 0");
  require(options.step_tolerance >= 0, "step_tolerance ≥ 0");
  require(options.gradient_tolerance >= 0, "gradient_tolerance ≥ 0");
  require(options.linear_tolerance > 0, "linear_tolerance > 0");
  require(options.initial_lambda >= 0 && options.initial_radius >= 0,
          "initial_lambda and initial_radius ≥ 0");
  require(!std::isnan(options.time_limit_s), "a time_limit_s that is a number");
}

/// Empties the report without giving its memory back.
void reset(Report& report) {
  std::vector<IterationRecord> records = std::move(report.records);
  std::vector<std::string_view> numeric = std::move(report.numeric_jacobians);
  GaugeReport gauge = std::move(report.gauge);
  std::string message = std::move(report.message);
  report = Report();
  records.clear();
  numeric.clear();
  gauge.held.clear();
  gauge.released.clear();
  gauge.damped_components = 0;
  message.clear();
  report.records = std::move(records);
  report.numeric_jacobians = std::move(numeric);
  report.gauge = std::move(gauge);
  report.message = std::move(message);
}

/// One call of optimize().
class Optimization {
 public:
  Optimization(Graph& graph, const Options& options, Report& report)
      : graph_(graph), options_(options), report_(report) {}

  void run() {
    make_plan();
    RunResult result;
    if (system().plan().scalars() == 0) {
      result = {Status::kConverged, Reason::kNothingToOptimize, report_.chi2_initial, 0};
    } else if (options_.gauge == GaugePolicy::kError && system().plan().free_components > 0) {
      result = {Status::kFailed, Reason::kGaugeFreedom, report_.chi2_initial, 0};
    } else {
      result = run_from_starts();
      if (release_observable_vertices(result)) result = run_released(result);
    }
    finish(result);
  }

 private:
  BatchSystem& system() { return session_->system(); }

  void make_plan() {
    {
      const TimeAdder adder(report_.time.plan_s);
      session_ = &Session::find(graph_, options_, report_.plan_reused);
    }
    system().configure(options_, report_.time);
    report_.chi2_initial = system().chi2();
    report_.start.requested = options_.start;
    report_.start.chi2_current = report_.chi2_initial;
    describe_problem();
  }

  void describe_problem() {
    const Plan& plan = system().plan();
    report_.linear_solver = system().linear_solver().name();
    report_.algorithm = session_->algorithm(options_).name();
    report_.vertices = plan.structure.blocks();
    report_.scalars = plan.scalars();
    report_.eliminated = plan.eliminated_blocks;
    report_.edges = plan.edge_count;
    report_.linear = system().linear_solver().statistics();
    report_.threads = resolved_threads(options_);
    report_.workers = system().linearizer().workers();
    report_.gauge.damped_components = plan.damped_components + plan.free_components;
    report_.gauge.held.clear();
    for (const GaugeVertex& gauge : plan.held) report_.gauge.held.push_back(gauge.id);
    report_.gauge.released.clear();
    for (const VertexRef& vertex : session_->released()) report_.gauge.released.push_back(graph_.id(vertex));
    report_.numeric_jacobians.clear();
    report_.disabled_edges = 0;
    for (const EdgeList& list : plan.edges) {
      const EdgePool& pool = *graph_.edge_pools()[list.pool];
      if (options_.numeric_jacobians || pool.jacobian_source() == JacobianSource::kNumeric) {
        report_.numeric_jacobians.push_back(pool.type_name());
      }
      for (std::uint32_t edge : list.edges) report_.disabled_edges += !pool.enabled(edge);
    }
  }

  /// Overwrites the estimates with the initial guess `start`; false, with a note in the report, where there
  /// is none.
  bool make_guess(Start start) {
    const TimeAdder adder(report_.time.start_s);
    const GuessResult guess = start == Start::kOdometry       ? guess_odometry(graph_, system().plan())
                              : start == Start::kSpanningTree ? guess_spanning_tree(graph_, system().plan())
                                                              : guess_chordal(graph_, system().plan());
    report_.start.note = guess.note;
    return guess.made;
  }

  RunResult run_from_starts() {
    if (options_.start == Start::kCurrent) return run_algorithm(report_.chi2_initial);
    system().save(VertexPool::kStartLevel);
    const Start guess = options_.start == Start::kAutomatic ? Start::kChordal : options_.start;
    if (!make_guess(guess)) {
      system().restore(VertexPool::kStartLevel);
      return run_algorithm(report_.chi2_initial);
    }
    report_.start.chi2_guess = system().chi2();
    report_.start.used = guess;
    if (options_.start != Start::kAutomatic) return run_algorithm(report_.start.chi2_guess);
    return run_better_start();
  }

  /// Start::kAutomatic, with the chordal guess in the graph and the current estimates at kStartLevel.
  RunResult run_better_start() {
    const double chi2_guess = report_.start.chi2_guess, chi2_current = report_.chi2_initial;
    const bool guess_first = chi2_guess < chi2_current || !std::isfinite(chi2_current);
    if (!guess_first) swap_with_saved(VertexPool::kStartLevel);  // now the guess waits at kStartLevel
    report_.start.used = guess_first ? Start::kChordal : Start::kCurrent;
    const RunResult first = run_algorithm(std::min(chi2_guess, chi2_current));
    const double other_chi2 = guess_first ? chi2_current : chi2_guess;
    const bool good = first.status == Status::kConverged && !(first.chi2 > other_chi2);
    const bool interrupted = first.reason == Reason::kStopFlag || first.reason == Reason::kCallback ||
                             first.reason == Reason::kTimeLimit;
    if (good || interrupted || !std::isfinite(other_chi2)) return first;
    return run_other_start(first, other_chi2);
  }

  /// Runs from the estimates at kStartLevel too, and keeps the better result.
  RunResult run_other_start(const RunResult& first, double other_chi2) {
    report_.start.ran_both = true;
    std::vector<IterationRecord> first_records = std::move(report_.records);
    report_.records.clear();
    swap_with_saved(VertexPool::kStartLevel);  // the first result waits there
    RunResult second = run_algorithm(other_chi2);
    const auto rank = [](const RunResult& r) { return std::pair(r.status == Status::kFailed, r.chi2); };
    const bool keep_second = rank(second) < rank(first);
    report_.start.chi2_other_final = keep_second ? first.chi2 : second.chi2;
    const Start other = report_.start.used == Start::kChordal ? Start::kCurrent : Start::kChordal;
    if (keep_second) {
      report_.start.used = other;
      return second;
    }
    system().restore(VertexPool::kStartLevel);
    report_.records = std::move(first_records);
    return first;
  }

  void swap_with_saved(int level) {
    system().save(VertexPool::kBestLevel);
    system().restore(level);
    for (const VertexList& list : system().plan().vertices) {
      graph_.vertex_pools()[list.pool]->copy_backup(list.slots, VertexPool::kBestLevel, level);
    }
  }

  RunResult run_algorithm(double chi2) {
    if (!std::isfinite(chi2)) return {Status::kFailed, Reason::kNotFinite, chi2, 0};
    Algorithm& algorithm = session_->algorithm(options_);
    algorithm.reset(options_, system().plan().scalars());
    const auto go_on = [this](const IterationRecord& record) { return call_back(record); };
    RunResult result = minimize(system(), algorithm, options_, go_on, chi2, clock_, report_.records);
    report_.iterations += result.iterations;
    report_.regularised_steps += algorithm.regularised_steps();
    return result;
  }

  bool call_back(const IterationRecord& record) {
    if (!options_.callback) return true;
    const std::uint64_t revision = graph_.revision();
    const bool go_on = options_.callback(record);
    if (graph_.revision() != revision || graph_.cache().get() != session_) {
      throw InvalidArgument("Options::callback changed the structure of the graph, or optimised it");
    }
    return go_on;
  }

  /// A held vertex whose own gradient does not vanish at the minimum over the others was no gauge freedom: it
  /// is let go, and the caller runs on.
  bool release_observable_vertices(const RunResult& result) {
    constexpr double kNoticeable = 1e-8;
    if (result.status != Status::kConverged || session_->keeps_held()) return false;
    const Plan& plan = system().plan();
    observable_.clear();
    for (std::size_t k = 0; k < plan.held.size(); ++k) {
      const double decrease = system().linearizer().held_vertex_decrease(k, system().linearize_options());
      if (decrease > kNoticeable * result.chi2) {
        observable_.push_back(plan.held[k].vertex);
      }
    }
    if (observable_.empty()) return false;
    plan_again([&] { session_->release(graph_, observable_); });
    return true;
  }

  /// Runs on with the released vertices; where that brings nothing, they are held again, for good.
  RunResult run_released(const RunResult& held) {
    constexpr double kWorthwhile = 1 - 1e-8;
    system().save(VertexPool::kStartLevel);
    const RunResult released = run_algorithm(held.chi2);
    if (released.status != Status::kFailed && released.chi2 < kWorthwhile * held.chi2) return released;
    system().restore(VertexPool::kStartLevel);
    plan_again([&] { session_->hold_again(graph_); });
    return held;
  }

  template <class F>
  void plan_again(F&& change) {
    {
      const TimeAdder adder(report_.time.plan_s);
      change();
    }
    system().configure(options_, report_.time);
    describe_problem();
  }

  void finish(const RunResult& result) {
    report_.status = result.status;
    report_.reason = result.reason;
    report_.chi2_final = system().chi2();
    report_.message.assign(to_string(result.reason));
    if (result.reason == Reason::kNotPositiveDefinite) {
      const VertexRef vertex = system().failed_vertex();
      report_.message += ": the Hessian is singular or indefinite at vertex " +
                         std::to_string(graph_.id(vertex)) + " (" +
                         std::string(graph_.vertex_pools()[vertex.pool]->type_name()) +
                         "); nothing measures it in some direction";
    } else if (result.reason == Reason::kNotFinite) {
      name_non_finite_edge();
    }
    report_.time.total_s = clock_.seconds();
  }

  void name_non_finite_edge() {
    const auto error = system().linearizer().find_non_finite_error();
    const auto edge =
        error ? error : system().linearizer().find_non_finite_jacobian(system().linearize_options());
    if (!edge) return;
    report_.message += error ? ": the error of" : ": a Jacobian of";
    report_.message +=
        " the edge " + std::string(graph_.edge_pools()[edge->pool]->type_name()) + " between vertices";
    for (const VertexRef& vertex : graph_.vertices(*edge))
      report_.message += " " + std::to_string(graph_.id(vertex));
    report_.message += " is NaN or infinite";
  }

  Graph& graph_;
  const Options& options_;
  Report& report_;
  Stopwatch clock_;
  Session* session_ = nullptr;
  std::vector<VertexRef> observable_;
};

}  // namespace

void optimize(Graph& graph, const Options& options, Report& report) {
  check(options);
  reset(report);
  Optimization(graph, options, report).run();
}

Report optimize(Graph& graph, const Options& options) {
  Report report;
  optimize(graph, options, report);
  return report;
}

}  // namespace boxplus
