// SPDX-License-Identifier: BSD-3-Clause
#include "optimize.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "boxplus/base/error.h"
#include "boxplus/io/file_format.h"
#include "boxplus/mpi/distributed_optimizer.h"
#include "checkpoint.h"
#include "command_line/message.h"
#include "command_line/option_kinds.h"
#include "command_line/progress.h"
#include "divide_graph.h"
#include "file_part.h"
#include "files/graph_input.h"
#include "files/interrupt.h"
#include "files/outputs.h"
#include "guess/start_table.h"
#include "io/bal/bal_format.h"
#include "io/gzip.h"
#include "io/replace_file.h"
#include "memory.h"
#include "optimize/fix_for_run.h"
#include "optimize/optimize_options.h"
#include "optimize/optimize_report.h"
#include "optimize/optimize_run.h"
#include "optimize/petsc_plugin.h"
#include "optimize/report_json.h"
#include "optimize/run_steps.h"
#include "plan/active_set.h"
#include "results.h"

namespace boxplus::app {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

struct DistributedArguments : OptimizeArguments {
  std::string checkpoint, restart;  ///< files; empty: none
  int checkpoint_every = 10;        ///< iterations
};

/// What the processes have in common, for the report.
struct Distribution {
  DistributedReport report;
  std::vector<std::uint64_t> peak_bytes, edges;  ///< of each process
  std::uint64_t sent_per_iteration = 0;
};

std::string distribution_text(const Distribution& distribution, bool is_divided) {
  constexpr double kMebi = 1 << 20;
  std::string memory;
  for (const std::uint64_t bytes : distribution.peak_bytes)
    memory += fmt::format("{}{:.1f}", memory.empty() ? "" : ", ", static_cast<double>(bytes) / kMebi);
  return fmt::format(
      "\n{} process{} shared the problem{} {} vertices that are not eliminated.\n"
      "Peak memory per process: {} MiB. Sent per iteration: {:.2f} MiB in all{}.\n",
      distribution.report.processes, distribution.report.processes == 1 ? "" : "es",
      is_divided ? ", and the system of the" : "; each solved for all", distribution.report.kept, memory,
      static_cast<double>(distribution.sent_per_iteration) / kMebi,
      is_divided ? ", besides what PETSc sent" : "");
}

/// The report of `boxplus optimize`, with a member for the processes.
std::string distributed_json(const Distribution& distribution, const RunFacts& facts) {
  auto json = nlohmann::ordered_json::parse(report_json(distribution.report, facts));
  json["distribution"] = {{"processes", distribution.report.processes},
                          {"kept", distribution.report.kept},
                          {"edges_per_process", distribution.edges},
                          {"peak_bytes_per_process", distribution.peak_bytes},
                          {"sent_bytes", distribution.report.all_sent_bytes},
                          {"sent_bytes_per_iteration", distribution.sent_per_iteration}};
  return json.dump(2) + "\n";
}

/// A solver of PETSc that divides the system of the kept vertices among the processes.
std::shared_ptr<LinearSolver> load_divided_solver(const std::string& options,
                                                  mpi::Communicator& communicator) {
  void* const make = find_in_petsc_plugin("boxplus_divided_petsc_solver");
  (void)communicator.any(false);  // PETSc starts in all processes, unless one has failed
  return communicator.while_others_wait([&] {
    return std::shared_ptr<LinearSolver>(
        reinterpret_cast<LinearSolver* (*)(MPI_Comm, const char*)>(make)(MPI_COMM_WORLD, options.c_str()));
  });
}

/// Whether the extension of an output, or the lack of one, selects BAL for a graph that was read from BAL.
bool selects_bal(const std::string& output) {
  if (output.empty() || output == kStandardStream || output.ends_with('/') || is_gzip_name(output))
    return false;
  const FileFormat* const format = default_formats().of_path(output);
  std::error_code none;
  return format != nullptr ? format->name == bal_format().name : !std::filesystem::is_directory(output, none);
}

/// Whether nothing depends on vertices and edges that only other processes have.
bool can_use_part(const OptimizeArguments& arguments) {
  const auto holds_place = [](BundlePart part) {
    return part == BundlePart::kPoses || part == BundlePart::kPoints;
  };
  return arguments.fixed.empty() && arguments.moving.empty() &&
         std::ranges::none_of(arguments.held, holds_place) && arguments.kernel_scope == KernelScope::kAll;
}

class DistributedRun {
 public:
  DistributedRun(DistributedArguments arguments, mpi::Communicator& communicator)
      : arguments_(std::move(arguments)), communicator_(communicator) {}

  int run(const std::string& command_line) {
    communicator_.together([&] { read(command_line); });
    const Interrupt interrupt;
    options_.stop = Interrupt::flag();
    distribution_.report = DistributedOptimizer(MPI_COMM_WORLD, file_->graph, options_).run([&](Start start) {
      return guess(start);
    });
    Report& report = distribution_.report;
    if (!arguments_.checkpoint.empty()) write_checkpoint();
    add_gauge(report);
    std::exception_ptr refusal;
    communicator_.together([&] { refusal = write(); });
    if (refusal) std::rethrow_exception(refusal);
    return exit_code(report.status);
  }

 private:
  void read(const std::string& command_line) {
    const std::vector<std::string> lines = communicator_.gather(command_line);
    for (std::size_t rank = 1; rank < lines.size(); ++rank) {
      if (lines[rank] == lines[0]) continue;
      throw InvalidArgument(
          fmt::format("the arguments differ between processes: '{}' in process 0, but '{}' in process {}",
                      lines[0], lines[rank], rank));
    }
    if (communicator_.is_first()) {
      std::vector<Output> outputs = outputs_of(arguments_);
      outputs.push_back({"--checkpoint", arguments_.checkpoint});
      check_outputs(outputs);
      refuse_to_replace({"--json", arguments_.json}, {arguments_.input});
      refuse_to_replace({"--checkpoint", arguments_.checkpoint}, {arguments_.input});
    }
    load();
    if (communicator_.is_first()) {
      print_notes(*file_, arguments_.input);
      require_representable(arguments_.output, *file_);
    }
    facts_.input = input_name(arguments_.input);
    facts_.skipped_lines = file_->skipped;
    facts_.indefinite_edges = file_->indefinite;
    set_pixel_sigma(file_->graph, arguments_);
    facts_.kernel = set_kernels(file_->graph, arguments_);
    if (part_) facts_.kernel.edges = facts_.kernel.name.empty() ? 0 : facts_.edges;
    prepare();
    facts_.load_s = seconds_since(begin_);
  }

  /// Reads the part of this process if that is enough, and otherwise the whole file.
  void load() {
    if (communicator_.size() > 1 && arguments_.input == kStandardStream)
      throw InvalidArgument("expected a file, because only process 0 has standard input");
    if (communicator_.size() > 1 && can_use_part(arguments_))
      part_ = read_part(arguments_.input, arguments_.reading, communicator_.rank(), communicator_.size());
    file_ = part_ ? std::move(part_->file) : read_input(arguments_.input, arguments_.reading);
    facts_.edges = part_ ? part_->all_edges : file_->graph.edge_count();
    if (!part_) require_edges(*file_, arguments_.input);
  }

  /// Fixes what is fixed in this run, and chooses the edges of this process.
  void prepare() {
    Graph& graph = file_->graph;
    fixed_.emplace(graph, arguments_);
    options_ = arguments_.options;
    if (arguments_.petsc)
      options_.custom_linear_solver = load_divided_solver(*arguments_.petsc, communicator_);
    options_.vertices = find_vertices(graph, arguments_.moving, "--only-vertices");
    PlanRequest request{.level = options_.level, .vertices = options_.vertices, .gauge = options_.gauge};
    const Gauge gauge = find_active_set(graph, request).gauge;
    held_ = part_ ? held_by_first(gauge.held) : gauge.held;
    freedoms_ = gauge.freedoms;
    for (const detail::GaugeVertex& held : held_) graph.fix(held.vertex);
    // A sample of the edges leaves these free, which may mislead if something is held. This policy tests all
    // edges.
    if (!freedoms_.empty() && !(arguments_.held.empty() && arguments_.fixed.empty())) {
      request.gauge = GaugePolicy::kDamp;
      std::vector<detail::GaugeFreedom> tested = find_active_set(graph, request).gauge.freedoms;
      // A component is named by its first vertex, which may be held by now.
      for (std::size_t i = 0; i < tested.size() && tested.size() == freedoms_.size(); ++i)
        tested[i].id = freedoms_[i].id;
      freedoms_ = std::move(tested);
    }
    if (communicator_.size() > 1) choose_edges();
    if (!arguments_.checkpoint.empty() || (!arguments_.output.empty() && communicator_.size() > 1))
      results_.emplace(graph, communicator_.size() == 1 ? graph.all_edges() : own_edges());
    if (!arguments_.restart.empty()) {
      options_.start = Start::kCurrent;
      ChangedGraph changed(graph, part_.has_value());
      apply_checkpoint(arguments_.restart, facts_.edges, changed);
    }
    options_.callback = [this](const IterationRecord& record) {
      if (communicator_.is_first() && arguments_.verbose)
        write_to_stderr(fmt::format("iteration {:3}  chi2 {:<13.7g}  step {:<10.3e}  {:.2f} s\n",
                                    record.iteration, record.chi2, record.step_max, record.time_s));
      if (!arguments_.checkpoint.empty() && record.iteration % arguments_.checkpoint_every == 0)
        write_checkpoint();
      return true;
    };
  }

  /// What the first process holds. Rounding errors decide, so that other parts might lead to other vertices.
  std::vector<detail::GaugeVertex> held_by_first(const std::vector<detail::GaugeVertex>& here) const {
    std::vector<std::uint64_t> ids;
    for (const detail::GaugeVertex& held : here) ids.push_back(static_cast<std::uint64_t>(held.id));
    std::vector<int> counts;
    ids = communicator_.gather(ids, &counts);
    std::vector<detail::GaugeVertex> result;
    for (const std::uint64_t word : std::span(ids).first(static_cast<std::size_t>(counts[0]))) {
      const Id id = static_cast<Id>(word);
      const std::optional<VertexRef> vertex = file_->graph.find_vertex(id);
      if (vertex) result.push_back({*vertex, id});  // each part has all poses and cameras
    }
    return result;
  }

  void write_checkpoint() {
    communicator_.together([&] {
      app::write_checkpoint(arguments_.checkpoint, facts_.edges, results_->changes(file_->graph),
                            communicator_);
    });
  }

  /// Leaves this process its own edges.
  void choose_edges() {
    Graph& graph = file_->graph;
    if (part_) {
      for (const EdgeRef& edge : part_->others) graph.remove(edge);
    } else {
      options_.edges = mpi::edges_of_part(graph, communicator_.rank(), communicator_.size());
    }
    if (own_edges().empty())
      throw InvalidArgument(fmt::format("{}: too few edges for {} processes", input_name(arguments_.input),
                                        communicator_.size()));
  }

  /// The edges of this process, if there are several.
  const std::vector<EdgeRef>& own_edges() const { return part_ ? file_->edges : options_.edges; }

  /// Replaces the estimates by an initial guess, which every process computes for the whole graph. There is
  /// none for BAL problems, so that these need no second plan, and if this process has only a part.
  bool guess(Start start) {
    if (part_ || file_->format == bal_format().name) return false;
    Graph& graph = file_->graph;
    const PlanRequest request{
        .level = options_.level, .vertices = options_.vertices, .gauge = options_.gauge};
    const auto table = detail::start_table();
    const auto entry = std::ranges::find(table, start, &detail::StartEntry::start);
    return entry != table.end() && entry->guess != nullptr &&
           entry->guess(graph, make_plan(graph, request), {.threads = options_.threads}).made;
  }

  /// Reports the gauge freedom of the whole graph.
  void add_gauge(Report& report) const {
    for (const detail::GaugeVertex& held : held_) report.gauge.held.push_back(held.id);
    report.gauge.free = freedoms_;
    for (const detail::GaugeFreedom& freedom : freedoms_) report.degrees_of_freedom += freedom.directions;
  }

  /// Reads the file in the first process, without its edges if it can do without them, and moves its vertices
  /// as all processes have moved theirs.
  void collect() {
    for (const detail::GaugeVertex& held : held_) file_->graph.unfix(held.vertex);
    fixed_.reset();
    if (arguments_.output.empty() || communicator_.size() == 1) return;
    const std::vector<std::uint64_t> changes = results_->changes(file_->graph);
    results_.reset();
    options_ = {};
    has_vertices_only_ = part_ && file_->format == bal_format().name && selects_bal(arguments_.output);
    file_.reset();
    std::optional<ChangedGraph> changed;
    if (communicator_.is_first()) {
      if (has_vertices_only_) {
        file_ = read_bal_vertices(TextSource::of_file(arguments_.input), arguments_.reading);
      } else {
        file_ = read_input(arguments_.input, arguments_.reading);
        set_pixel_sigma(file_->graph, arguments_);
        if (!arguments_.kernel.empty()) robustify(file_->graph, arguments_);
      }
      changed.emplace(file_->graph);
    }
    communicator_.visit_at_first(
        changes, [&](std::span<const std::uint64_t> of_process) { changed->apply(of_process); });
  }

  /// Writes the vertices, and copies the observations of the input.
  void save_vertices() {
    Progress progress(choose_progress(arguments_.quiet, false));
    progress.later(fmt::format("writing {} …", arguments_.output));
    replace_file(arguments_.output, [&](TextSink sink) {
      write_bal_vertices(file_->graph, TextSource::of_file(arguments_.input), arguments_.reading, sink);
    });
    facts_.output = arguments_.output;
  }

  /// Collects the results, and writes them in the first process.
  std::exception_ptr write() {
    DistributedReport& report = distribution_.report;
    collect();
    std::exception_ptr refusal;
    if (communicator_.is_first() && has_vertices_only_) {
      save_vertices();
    } else if (communicator_.is_first() && !arguments_.output.empty()) {
      refusal = save_result(arguments_, *file_, facts_);
    }
    distribution_.peak_bytes = communicator_.gather(std::vector{memory_of_process().peak});
    distribution_.edges = communicator_.gather(std::vector{std::uint64_t{report.own_edges}});
    distribution_.sent_per_iteration =
        report.all_sent_bytes / static_cast<std::uint64_t>(std::max(1, report.iterations));
    if (!communicator_.is_first()) return nullptr;
    facts_.total_s = seconds_since(begin_);
    if (!arguments_.json.empty()) write_output(arguments_.json, distributed_json(distribution_, facts_));
    if (!arguments_.quiet) {
      print_report(report, facts_, arguments_);
      print_summary(outputs_of(arguments_), distribution_text(distribution_, arguments_.petsc.has_value()));
    }
    print_why_stopped(report, facts_, arguments_);
    return refusal;
  }

  DistributedArguments arguments_;
  mpi::Communicator& communicator_;
  const Clock::time_point begin_ = Clock::now();
  Options options_;
  std::optional<FilePart> part_;  // if this process has not read the whole file; without its file
  std::optional<GraphFile> file_;
  bool has_vertices_only_ = false;  // at the end
  std::optional<FixForRun> fixed_;
  std::vector<detail::GaugeVertex> held_;
  std::vector<detail::GaugeFreedom> freedoms_;  // while these are held
  std::optional<Results> results_;
  RunFacts facts_;
  Distribution distribution_;
};

void add_checkpoint_options(CLI::App& command, DistributedArguments& arguments) {
  const auto add_file = [&](const char* option, std::string& path, const char* help) {
    return command.add_option(option, path, help)
        ->check(file_name())
        ->type_name("FILE")
        ->group("Checkpoints");
  };
  CLI::Option* checkpoint =
      add_file("--checkpoint", arguments.checkpoint,
               "Where to write the estimates every few iterations and at the end of the run");
  command.add_option("--checkpoint-every", arguments.checkpoint_every, "The iterations from one to the next")
      ->check(whole_number_from(1))
      ->default_str("10")
      ->group("Checkpoints")
      ->needs(checkpoint);
  add_file("--restart", arguments.restart, "Begin with the estimates of a checkpoint of the same FILE")
      ->excludes(command.get_option("--start"));
}

/// The arguments as one line, for comparisons.
std::string command_line_of(const CLI::App& command) {
  return command.config_to_str(false, false);
}

}  // namespace

void add_distributed_optimize(CLI::App& app, Action& action, mpi::Communicator& communicator) {
  auto arguments = std::make_shared<DistributedArguments>();
  CLI::App* command =
      app.add_subcommand("optimize", "Moves the vertices of a graph to minimize the errors of its edges");
  add_optimize_options(*command, *arguments);
  for (const char* option : {"--outliers", "--write-outliers", "--remove-outliers", "--certify",
                             "--position-priors", "--view", "--port", "--host", "--open"})
    command->remove_option(command->get_option(option));
  add_checkpoint_options(*command, *arguments);
  command->footer(
      "Examples:\n"
      "  mpirun -n 4 boxplus-mpi optimize scene.bal -o optimized.bal\n"
      "  mpirun -n 4 boxplus-mpi optimize scene.bal --petsc ''\n"
      "  mpirun -n 4 boxplus-mpi optimize scene.bal --checkpoint scene.checkpoint\n"
      "  mpirun -n 4 boxplus-mpi optimize scene.bal --restart scene.checkpoint\n"
      "\n"
      "Exit codes: 0 converged, 1 not converged, 2 bad input or usage, 3 numerical failure.");
  command->callback([&action, &communicator, command, arguments] {
    require_needed_values(*command);
    action = [&communicator, arguments, line = command_line_of(*command)] {
      return DistributedRun(*arguments, communicator).run(line);
    };
  });
}

}  // namespace boxplus::app
