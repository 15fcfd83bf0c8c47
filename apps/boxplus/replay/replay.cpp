// SPDX-License-Identifier: BSD-3-Clause
// boxplus replay FILE: optimizes a graph step by step, as a robot would.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <csignal>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <thread>
#include <utility>

#include "boxplus/base/error.h"
#include "boxplus/optimize/optimizer.h"
#include "boxplus/types/slam2d.h"
#include "command.h"
#include "command_line/message.h"
#include "command_line/option_kinds.h"
#include "files/graph_input.h"
#include "files/interrupt.h"
#include "files/outputs.h"
#include "protocol/serve_commands.h"
#include "replay/file_feed.h"
#include "replay/replay_run.h"
#include "replay/time_chart.h"
#include "view/live_view.h"

namespace boxplus::app {
namespace {

constexpr const char* kReplayFooter =
    "A step adds the vertex with the next id, and the edges between it and the vertices before it. Then\n"
    "it brings all estimates to the optimum (docs/live.md). A new pose begins where its first edge puts\n"
    "it. After the last step, the estimates are brought to the optimum to the last digits.\n"
    "\n"
    "With --online, the graph comes from standard input, in the protocol of g2o_online, as a robot\n"
    "sends it: ADD VERTEX_XYT id; ADD EDGE_XYT from to x y theta information; the same with XYZRPY;\n"
    "FIX id; SOLVE_STATE; and QUERY_STATE, whose answers go to standard output. SOLVE_STATE is a step.\n"
    "If a command is wrong, or nobody reads the answers any more, the map so far is still written, with\n"
    "exit code 2.\n"
    "\n"
    "Examples:\n"
    "  boxplus replay drive.g2o -o map.g2o\n"
    "  boxplus replay drive.g2o --times times.csv --compare-every 100\n"
    "  boxplus replay drive.g2o --json - | jq .time_s\n"
    "  boxplus replay drive.g2o --view --open --seconds 60\n"
    "  robot | boxplus replay --online -o map.g2o\n"
    "\n"
    "Exit codes: 0 converged, 1 not converged, 2 bad input or usage, 3 numerical failure.";

struct ReplayArguments : ServingArguments {
  bool view = false, online = false;
  double seconds = 20;  // how long the page shows the replay, at least
  std::string input, output, json, times, plot;
  int compare_every = 0;
  bool quiet = false;
  SmootherOptions options;
  ReadOptions reading;
};

/// How far a step is from the optimum of the graph so far.
struct Excess {
  std::size_t step = 0;
  double chi2 = 0, chi2_optimum = 0;
  /// 0 if chi2 is as small as rounding makes it.
  double relative() const {
    constexpr double kRounding = 1e-15;
    return chi2_optimum > kRounding ? chi2 / chi2_optimum - 1 : 0;
  }
};

Excess compare_with_batch(const Graph& graph, const Replay& replay) {
  Graph copy = graph;
  const Report batch = optimize(copy, {.start = Start::kCurrent, .threads = 1});
  return {replay.done(), replay.chi2(), batch.chi2_final};
}

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// The result of a replay.
struct Outcome {
  SmootherReport last;
  bool is_whole = true;     // nobody has ended it early
  bool is_refused = false;  // a command was wrong, or an answer could not be written
  double chi2 = 0, worst_s = 0, median_s = 0;
  std::size_t worst_step = 0, failures = 0, aside = 0;
  std::vector<Excess> excesses;
  double largest_excess() const {
    double largest = 0;
    for (const Excess& excess : excesses) largest = std::max(largest, excess.relative());
    return largest;
  }
};

/// Shows the steps of a replay, evenly over the time that the arguments say.
class PacedView {
 public:
  PacedView(LiveView& view, const ReplayArguments& arguments, std::size_t steps)
      : view_(view),
        pause_(std::chrono::duration<double>(arguments.seconds) / std::max(steps, std::size_t{1})) {
    view_.wait_for_page();
    next_ = Clock::now();
  }
  /// Shows a step, until it is time for the next one or Interrupt is raised.
  void show() {
    view_.follow();
    next_ += std::chrono::duration_cast<Clock::duration>(pause_);
    constexpr auto kPatience = std::chrono::milliseconds(50);
    while (!Interrupt::raised() && Clock::now() < next_)
      std::this_thread::sleep_until(std::min(next_, Clock::now() + kPatience));
  }

 private:
  using Clock = std::chrono::steady_clock;
  LiveView& view_;
  std::chrono::duration<double> pause_;
  Clock::time_point next_;
};

void step(const ReplayArguments& arguments, const Graph& graph, Replay& replay, Outcome& outcome) {
  const SmootherReport report = replay.step();
  if (!report.message.empty() && outcome.failures++ == 0)
    print_message(fmt::format("step {}: {}", replay.done(), report.message));
  const bool is_due =
      arguments.compare_every > 0 && replay.done() % static_cast<std::size_t>(arguments.compare_every) == 0;
  if (is_due) outcome.excesses.push_back(compare_with_batch(graph, replay));
}

Outcome run_from_file(const ReplayArguments& arguments, Graph& graph, Replay& replay, FileFeed& feed,
                      LiveView* view) {
  Outcome outcome;
  std::optional<PacedView> paced;
  if (view != nullptr) paced.emplace(*view, arguments, feed.steps());
  for (std::size_t k = 0; k < feed.steps() && outcome.is_whole; ++k) {
    feed.add(k);
    step(arguments, graph, replay, outcome);
    if (paced) paced->show();
    outcome.is_whole = !paced || !Interrupt::raised();
  }
  return outcome;
}

Outcome run_online(const ReplayArguments& arguments, Graph& graph, Replay& replay, LiveView* view) {
  Outcome outcome;
  bool is_shown = view == nullptr;
  if (view != nullptr) view->wait_for_page();
  std::signal(SIGPIPE, SIG_IGN);  // a reader that has gone is a write error
  try {
    serve_commands(graph, {.solve =
                               [&] {
                                 step(arguments, graph, replay, outcome);
                                 if (view != nullptr) view->follow(), is_shown = false;
                               },
                           .answer = [](std::string_view text) { write_output(kStandardStream, text); },
                           .idle =
                               [&] {
                                 if (!std::exchange(is_shown, true)) view->show();
                               }});
  } catch (const Error& error) {  // the map so far is worth keeping
    print_message(error.what());
    outcome.is_refused = true;
  }
  outcome.is_whole = !Interrupt::raised();
  return outcome;
}

/// Completes the outcome after the last step.
Outcome finish(Outcome outcome, Replay& replay) {
  outcome.last = replay.finish();
  outcome.aside = replay.smoother().set_aside().size();
  outcome.chi2 = replay.chi2();
  const std::vector<double>& seconds = replay.seconds();
  if (seconds.empty()) return outcome;
  const auto worst = std::max_element(seconds.begin(), seconds.end());
  outcome.worst_s = *worst;
  outcome.worst_step = static_cast<std::size_t>(worst - seconds.begin()) + 1;
  outcome.median_s = median(seconds);
  return outcome;
}

std::string json_of(const ReplayArguments& arguments, const Replay& replay, const Outcome& outcome) {
  const Replay::Totals& totals = replay.totals();
  nlohmann::ordered_json json{
      {"file", arguments.input},
      {"steps", replay.done()},
      {"vertices", outcome.last.vertices},
      {"edges", outcome.last.edges},
      {"converged", outcome.last.converged() && outcome.is_whole},
      {"reason", outcome.is_whole ? to_string(outcome.last.reason) : "interrupted"},
      {"chi2_final", outcome.chi2},
      {"iterations", totals.iterations},
      {"relinearized_edges", totals.relinearized},
      {"ordered_vertices", totals.ordered},
      {"factorized_fronts", totals.refactored},
      {"moved_vertices", totals.moved},
      {"started_over", totals.started_over},
      {"gflop", 1e-9 * totals.flops},
      {"time_s", {{"total", totals.seconds}, {"worst", outcome.worst_s}, {"median", outcome.median_s}}}};
  if (arguments.options.sets_outliers_aside) json["set_aside"] = outcome.aside;
  if (arguments.compare_every > 0) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const Excess& excess : outcome.excesses)
      list.push_back({{"step", excess.step}, {"chi2", excess.chi2}, {"chi2_optimum", excess.chi2_optimum}});
    json["compared"] = list;
  }
  return json.dump(2) + "\n";
}

std::string summary(const ReplayArguments& arguments, const Replay& replay, const Outcome& outcome) {
  const Replay::Totals& totals = replay.totals();
  std::string text = fmt::format(
      "{} steps: {}, chi2 {:.9g}\n"
      "time     {:.3f} s in total, {:.1f} us in the median, {:.2f} ms in the worst step ({})\n"
      "work     {} iterations, {} linearized edges, {} fronts, {} moved vertices, {:.3f} Gflop\n",
      replay.done(), outcome.is_whole ? to_string(outcome.last.reason) : "interrupted", outcome.chi2,
      totals.seconds, 1e6 * outcome.median_s, 1e3 * outcome.worst_s, outcome.worst_step, totals.iterations,
      totals.relinearized, totals.refactored, totals.moved, 1e-9 * totals.flops);
  if (arguments.options.sets_outliers_aside)
    text += fmt::format("outliers {} loop closures are set aside\n", outcome.aside);
  if (arguments.compare_every > 0)
    text += fmt::format("excess   chi2 is at most {:.2g} times above the optimum so far, in {} comparisons\n",
                        outcome.largest_excess(), outcome.excesses.size());
  return text;
}

std::string csv_of(const std::vector<double>& seconds) {
  std::string text = "step,seconds\n";
  for (std::size_t k = 0; k < seconds.size(); ++k) text += fmt::format("{},{:.9g}\n", k + 1, seconds[k]);
  return text;
}

std::string chart_of(const ReplayArguments& arguments, const Replay& replay, const Outcome& outcome) {
  const auto ends_with = [&](std::string_view extension) { return arguments.plot.ends_with(extension); };
  const PictureFormat format = ends_with(".png")   ? PictureFormat::kPng
                               : ends_with(".pdf") ? PictureFormat::kPdf
                                                   : PictureFormat::kSvg;
  const std::string facts =
      fmt::format("{} steps in {:.3g} s  ·  median {:.3g} µs, worst {:.3g} ms", replay.done(),
                  replay.totals().seconds, 1e6 * outcome.median_s, 1e3 * outcome.worst_s);
  return draw_time_chart(replay.seconds(), input_name(arguments.input), facts, format);
}

/// A graph of the types that the protocol has.
GraphFile sample_of_protocol() {
  GraphFile file;
  const auto a = file.graph.add_vertex(SE2()), b = file.graph.add_vertex(SE2(1, 0, 0));
  file.graph.add_edge(Between(SE2(1, 0, 0)), 1.0, a, b);
  return file;
}

int replay_file(const ReplayArguments& arguments) {
  const std::vector<Output> outputs{graph_output("--output", arguments.output, arguments.input),
                                    {"--json", arguments.json},
                                    {"--times", arguments.times},
                                    {"--plot", arguments.plot},
                                    {"--online", arguments.online ? kStandardStream : ""}};
  for (const Output& output : {outputs[1], outputs[2], outputs[3]})
    refuse_to_replace(output, {arguments.input});
  check_outputs(outputs);
  GraphFile file;
  if (!arguments.online) file = read_input(arguments.input, arguments.reading, arguments.quiet);
  print_notes(file, arguments.input);
  if (!arguments.output.empty())
    require_representable(arguments.output, arguments.online ? sample_of_protocol() : file);
  std::optional<FileFeed> feed;
  if (!arguments.online) feed.emplace(file.graph);
  Replay replay(file.graph, arguments.options);
  std::optional<Interrupt> interrupt;
  std::optional<LiveView> view;
  if (arguments.view || arguments.online) interrupt.emplace();
  if (arguments.view) view.emplace(file, arguments.input, arguments, viewer::Drawn::kTakingPart);
  LiveView* const shown = view ? &*view : nullptr;
  const Outcome outcome = finish(feed ? run_from_file(arguments, file.graph, replay, *feed, shown)
                                      : run_online(arguments, file.graph, replay, shown),
                                 replay);
  if (!arguments.json.empty()) write_output(arguments.json, json_of(arguments, replay, outcome));
  if (!arguments.times.empty()) write_output(arguments.times, csv_of(replay.seconds()));
  if (!arguments.plot.empty()) write_output(arguments.plot, chart_of(arguments, replay, outcome));
  if (!arguments.output.empty()) save_graph(arguments.output, file, {}, arguments.quiet);
  if (!arguments.quiet) print_summary(outputs, summary(arguments, replay, outcome));
  const bool is_good = outcome.last.converged() && outcome.is_whole;
  const int code = outcome.is_refused              ? kBadInput
                   : !outcome.last.message.empty() ? kNumericalFailure
                   : is_good                       ? kSuccess
                                                   : kNotConverged;
  if (view) view->serve(code);
  return code;
}

void add_options(CLI::App& command, ReplayArguments& arguments) {
  CLI::Option* const file =
      command.add_option("FILE", arguments.input, "The graph, or - for standard input")->check(file_name());
  CLI::Option* const online =
      command
          .add_flag("--online", arguments.online,
                    "Instead of FILE, execute commands of standard input as they arrive, and answer")
          ->excludes(file);
  command.add_option("-o,--output", arguments.output, "Write the result to this file")->check(file_name());
  command.add_option("--json", arguments.json, "Write a report to this file, or - for standard output")
      ->check(file_name());
  command.add_option("--times", arguments.times, "Write the time of each step to this CSV file")
      ->check(file_name());
  command
      .add_option("--plot", arguments.plot,
                  "Draw the time of each step in this file: .png, .pdf, or any other name for SVG")
      ->check(file_name());
  command
      .add_option("--compare-every", arguments.compare_every,
                  "Compare chi2 with that of a batch optimization after every so many steps")
      ->type_name("STEPS")
      ->check(whole_number_from(1));
  SmootherOptions& options = arguments.options;
  command
      .add_option("--max-iterations", options.max_iterations,
                  "The largest number of linearizations in a step; the next step goes on")
      ->check(whole_number_from(1))
      ->capture_default_str();
  command
      .add_option("--relinearize", options.relinearize.length,
                  "Linearize a vertex anew when it has moved so many meters, or 0.15 times as many radians")
      ->type_name("METERS")
      ->check(number_above(0))
      ->capture_default_str();
  command
      .add_option("--noticeable", options.noticeable.length,
                  "Do not pass on changes of a vertex below so many meters, and half as many radians")
      ->type_name("METERS")
      ->check(number_above(0))
      ->capture_default_str();
  command.add_flag("--outliers", options.sets_outliers_aside,
                   "Set false loop closures aside, and take them back");
  command.add_flag("-q,--quiet", arguments.quiet, "Print no summary");
  add_reading_options(command, arguments.reading);
  for (const char* const option : {"--lenient", "--rename", "--information"})
    online->excludes(command.get_option(option));
  CLI::Option* const view = command.add_flag(
      "--view", arguments.view, "Wait for a browser, show it each step, and serve the page until Ctrl-C");
  view->group("View");
  command.add_option("--seconds", arguments.seconds, "How long the page shows the replay, at least")
      ->check(number_within(0, 1e6))
      ->capture_default_str()
      ->group("View")
      ->needs(view);
  add_serving_options(command, arguments, view);
  command.footer(kReplayFooter);
}

}  // namespace

void add_replay(CLI::App& app, Action& action) {
  CLI::App& command = *app.add_subcommand("replay", "Optimize a graph step by step, as a robot would");
  const auto arguments = std::make_shared<ReplayArguments>();
  add_options(command, *arguments);
  command.callback([arguments, &action] {
    if (arguments->online) arguments->input = kStandardStream;
    if (arguments->input.empty()) throw CLI::RequiredError("FILE or --online");
    SmootherOptions& options = arguments->options;
    options.relinearize.angle = options.relinearize.other = 0.15 * options.relinearize.length;
    options.noticeable.angle = options.noticeable.other = 0.5 * options.noticeable.length;
    action = [arguments] { return replay_file(*arguments); };
  });
}

}  // namespace boxplus::app
