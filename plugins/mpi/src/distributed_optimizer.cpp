// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/mpi/distributed_optimizer.h"

#include <algorithm>
#include <optional>
#include <sstream>
#include <string>
#include <utility>

#include "boxplus/algorithm/algorithm_table.h"
#include "boxplus/base/parallel.h"
#include "boxplus/linear/make_linear_solver.h"
#include "boxplus/options/option_table.h"
#include "communicator.h"
#include "distributed_system.h"
#include "linearize/non_finite.h"
#include "optimize/constraints.h"
#include "optimize/descent.h"
#include "optimize/edge_counts.h"
#include "optimize/fill_report.h"
#include "optimize/starts.h"

namespace boxplus {
namespace {

using mpi::Communicator;
using mpi::DistributedSystem;

/// "name=value" for each option that must be the same in all processes.
std::string text_of(const Options& options) {
  std::ostringstream text;
  text.precision(17);
  const auto add = [&](const auto& option) {
    if (option.name == "threads" || option.name == "max_factor_bytes") return;
    const auto& value = options.*option.member;
    if constexpr (std::is_enum_v<std::decay_t<decltype(value)>>) {
      text << option.name << ' ' << static_cast<int>(value) << '\n';
    } else {
      text << option.name << ' ' << value << '\n';
    }
  };
  std::apply([&](const auto&... option) { (add(option), ...); }, detail::kOptions);
  text << "custom_linear_solver " << (options.custom_linear_solver != nullptr) << '\n';
  return text.str();
}

/// Throws InvalidArgument if the options of another process differ from those of the first.
void check_equal(Communicator& communicator, const Options& options) {
  const std::vector<std::string> texts = communicator.gather(text_of(options));
  for (std::size_t rank = 1; rank < texts.size(); ++rank) {
    if (texts[rank] == texts[0]) continue;
    std::istringstream first(texts[0]), other(texts[rank]);
    std::string a, b;
    while (std::getline(first, a) && std::getline(other, b) && a == b) continue;
    throw InvalidArgument(std::string("the options differ between processes: ")
                              .append(a)
                              .append(" in process 0, but ")
                              .append(b)
                              .append(" in process ")
                              .append(std::to_string(rank)));
  }
}

bool has_bounds(const Graph& graph) {
  return std::ranges::any_of(graph.vertex_pools(), [](const auto& pool) { return pool->has_bounds(); });
}

/// Throws InvalidArgument for what only an Optimizer can do.
void check_supported(const Graph& graph, const Options& options, bool has_guess) {
  detail::check_options(options);
  const auto refuse = [](const std::string& what) {
    throw InvalidArgument("a distributed optimization does not support " + what);
  };
  if (options.start != Start::kCurrent && options.start != Start::kAutomatic && !has_guess)
    refuse("the start '" + std::string(to_string(options.start)) +
           "' without a function that makes the guess");
  if (options.gauge == GaugePolicy::kError) refuse("GaugePolicy::kError; expected kFixFirst or kDamp");
  if (options.schur == SchurMode::kImplicit) refuse("SchurMode::kImplicit; expected kAutomatic or kExplicit");
  if (has_bounds(graph)) refuse("bounds of vertices");
  if (Constraints::exist_in(graph)) refuse("constraints");
}

std::shared_ptr<LinearSolver> make_solver(const Options& options) {
  if (options.custom_linear_solver) return options.custom_linear_solver;
  Precision precision = options.precision;
  if (options.algorithm == AlgorithmKind::kGaussNewton && precision == Precision::kAutomatic)
    precision = Precision::kDouble;
  const LinearSolverOptions of_solver{.block_cholesky = {.precision = precision},
                                      .automatic = {.max_factor_bytes = options.max_factor_bytes}};
  return make_linear_solver(options.linear_solver, for_newton_steps(of_solver));
}

}  // namespace

struct DistributedOptimizer::Impl {
  Impl(MPI_Comm parent, Graph& observed, Options given)
      : communicator(parent), graph(&observed), options(std::move(given)) {}

  void run(DistributedReport& report, const Guess& guess);
  void add_up(DistributedReport& report, const DistributedSystem& system);
  void finish(DistributedReport& report, DistributedSystem& system, const RunResult& result);
  std::string culprit(Report::Reason reason, const DistributedSystem& system, double chi2);

  Communicator communicator;
  Graph* graph;
  Options options;
};

void DistributedOptimizer::Impl::run(DistributedReport& report, const Guess& guess) {
  const Stopwatch clock;
  const std::uint64_t sent_before = communicator.sent_bytes();
  check_equal(communicator, options);
  check_supported(*graph, options, guess != nullptr);
  Options of_run = options;
  if (of_run.threads == 0)
    of_run.threads = std::max(1, detail::hardware_threads() / communicator.neighbors());
  begin_report(report, of_run);
  RunStop stop(of_run, clock.start());
  std::optional<DistributedSystem> system;
  {
    const ScopedTimer adder(report.time.plan_s);
    const PlanRequest request{
        .level = of_run.level,
        .vertices = of_run.vertices,
        .edges = of_run.edges,
        .gauge = GaugePolicy::kError,  // a part of a graph has more freedom than the graph
        .threads = of_run.threads,
        .columns = of_run.numeric_jacobians ? ColumnStorage::kAll : ColumnStorage::kAutomatic};
    system.emplace(communicator, *graph, request, make_solver(of_run), true);
  }
  system->configure(of_run, report.time);
  if (of_run.algorithm == AlgorithmKind::kAutomatic)
    of_run.algorithm = communicator.any(system->plan().eliminated_blocks > 0)
                           ? AlgorithmKind::kLevenbergMarquardt
                           : AlgorithmKind::kDogleg;
  const std::unique_ptr<Algorithm> algorithm = make_algorithm(of_run.algorithm);
  report.algorithm = algorithm->name();
  EdgeCounter counter;
  describe_problem(report, *graph, *system, of_run, counter);
  add_up(report, *system);
  report.chi2_initial = report.start.chi2_current = system->chi2();
  RunResult result{Report::Status::kConverged, Report::Reason::kNothingToOptimize, report.chi2_initial, 0};
  if (report.scalars > 0) {
    Descent descent(*graph, *system, *algorithm, of_run, stop, clock, report);
    StartMemory memory;
    result = minimize_from_starts(descent, report.start, report.time.start_s, memory,
                                  [&](Start start, const GuessLimits&) -> GuessResult {
                                    if (guess && guess(start)) return {.made = true, .note = {}};
                                    return {.made = false, .note = "no initial guess was made"};
                                  });
    report.start.other_iterations = descent.iterations() - static_cast<int>(report.records.size());
    report.regularized_steps = descent.regularized_steps();
    report.displaced_directions = descent.displaced_directions();
  }
  report.iterations = static_cast<int>(report.records.size());
  finish(report, *system, result);
  report.sent_bytes = communicator.sent_bytes() - sent_before;
  report.all_sent_bytes =
      static_cast<std::uint64_t>(communicator.sum(static_cast<double>(report.sent_bytes)));
  report.time.total_s = clock.seconds();
}

/// Replaces the sizes of the part of this process by those of the whole problem.
void DistributedOptimizer::Impl::add_up(DistributedReport& report, const DistributedSystem& system) {
  const mpi::KeptVertices& kept = system.kept();
  const auto total = [&](auto& here) {
    here = static_cast<std::decay_t<decltype(here)>>(communicator.sum(static_cast<double>(here)));
  };
  report.processes = communicator.size();
  report.kept = kept.count();
  report.own_edges = report.edges;
  report.own_kept = static_cast<std::uint32_t>(kept.local().size());
  report.own_eliminated = report.vertices - report.own_kept;
  report.eliminated = report.own_eliminated;
  report.vertices = report.own_eliminated + kept.own_count();
  report.scalars = kept.own_unknowns();
  total(report.vertices);
  total(report.eliminated);
  total(report.scalars);
  total(report.edges);
  total(report.rows);
  total(report.degrees_of_freedom);
  total(report.disabled_edges);
  total(report.robust_edges);
  report.gauge.free.clear();  // what the edges of a part leave free, others may determine
}

/// One sentence on the cause of a failure, which is the same in all processes; empty if there is none.
std::string DistributedOptimizer::Impl::culprit(Report::Reason reason, const DistributedSystem& system,
                                                double chi2) {
  if (reason == Report::Reason::kNotPositiveDefinite) {
    const std::optional<Id> id = system.failed_kept();
    return ": the Hessian is singular or indefinite" + (id ? " at vertex " + std::to_string(*id) : "") +
           "; nothing measures it in some direction";
  }
  if (reason != Report::Reason::kNotFinite) return {};
  const bool is_here = find_non_finite_error(*graph, system.plan()) ||
                       find_non_finite_jacobian(*graph, system.plan(), system.linearize_options());
  const std::vector<std::string> texts = communicator.gather(
      is_here ? ": " + describe_non_finite(*graph, system.plan(), system.linearize_options(), chi2) : "");
  const auto cause = std::ranges::find_if(texts, [](const std::string& text) { return !text.empty(); });
  return cause == texts.end() ? ": the sum of errors or Jacobians is not finite" : *cause;
}

void DistributedOptimizer::Impl::finish(DistributedReport& report, DistributedSystem& system,
                                        const RunResult& result) {
  report.chi2_final = system.chi2();
  report.status = result.status;
  report.reason = result.reason;
  if (is_interruption(result.reason)) {  // only the first process knows for certain what has stopped it
    const auto reason = static_cast<double>(communicator.is_first() ? static_cast<int>(result.reason) : 0);
    report.reason = static_cast<Report::Reason>(static_cast<int>(communicator.max(reason)));
  }
  report.linear = system.facts().statistics;
  report.message = std::string(to_string(report.reason)) + culprit(report.reason, system, report.chi2_final);
}

DistributedOptimizer::DistributedOptimizer(MPI_Comm communicator, Graph& graph, Options options)
    : impl_(std::make_unique<Impl>(communicator, graph, std::move(options))) {}
DistributedOptimizer::~DistributedOptimizer() = default;
DistributedOptimizer::DistributedOptimizer(DistributedOptimizer&&) noexcept = default;
DistributedOptimizer& DistributedOptimizer::operator=(DistributedOptimizer&&) noexcept = default;

DistributedReport DistributedOptimizer::run(const Guess& guess) {
  DistributedReport report;
  impl_->communicator.together([&] { impl_->run(report, guess); });
  return report;
}

}  // namespace boxplus
