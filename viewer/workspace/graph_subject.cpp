// SPDX-License-Identifier: BSD-3-Clause
#include "viewer/workspace/graph_subject.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>
#include <tuple>
#include <utility>

#include "boxplus/base/error.h"
#include "boxplus/io/file_format.h"
#include "settings/setting_table.h"
#include "viewer/protocol/diagnosis_json.h"
#include "viewer/protocol/element_json.h"

namespace boxplus::viewer {

namespace {

/// The report of a run that was stopped early has no chi2.
bool has_chi2(const Report& report) {
  const bool is_stopped =
      report.reason == Report::Reason::kStopFlag || report.reason == Report::Reason::kTimeLimit;
  return !is_stopped || std::isfinite(report.chi2_initial);
}

std::string counted(std::size_t number, const char* what) {
  return fmt::format("{} {}{}", number, what, number == 1 ? "" : "s");
}

}  // namespace

Outcome outcome_of(const Report& report) {
  Outcome outcome{.status = std::string(to_string(report.status)),
                  .headline = {},
                  .summary = to_string(report),
                  .reason = report.message,
                  .converged = report.converged(),
                  .chi2 = report.chi2_final,
                  .rows = report.records,
                  .chi2_per_degree = report.chi2_per_degree(),
                  .degrees_of_freedom = report.degrees_of_freedom};
  if (!has_chi2(report))
    outcome.summary =
        fmt::format("{}: stopped before chi2 was computed; the estimates are unchanged", outcome.status);
  outcome.headline = outcome.summary.substr(0, outcome.summary.find('\n'));
  if (report.start.used != Start::kCurrent && !report.records.empty()) {
    outcome.start = to_string(report.start.used);
    outcome.chi2_start = report.start.chi2_guess;
  }
  return outcome;
}

Outcome outcome_of(const OutlierReport& found) {
  Outcome outcome = outcome_of(found.report);
  outcome.verdicts = found.verdicts;
  outcome.false_edges = found.count(Verdict::kOutlier);
  return outcome;
}

GraphSubject::GraphSubject(GraphFile file, std::string name)
    : own_(std::move(file)),
      graph_(&own_->graph),
      file_(&*own_),
      name_(std::move(name)),
      scans_(*own_, name_) {
  structure_ = make_structure(*graph_);
}

GraphSubject::GraphSubject(Graph& graph, std::string name, const GraphFile* file, Drawn drawn)
    : graph_(&graph), file_(file), name_(std::move(name)), drawn_(drawn) {
  structure_ = make_structure(*graph_, drawn_);
  if (file_ != nullptr) scans_ = ScansOfFile(*file_, name_);
}

Subject::Facts GraphSubject::facts() const {
  return {name_,
          file_ != nullptr ? file_->format : "",
          graph_->vertex_count(),
          graph_->edge_count(),
          structure_.dimension,
          ""};
}

Message GraphSubject::form() const {
  std::vector<FormatName> formats;
  for (const FileFormat& format : default_formats().all()) {
    const bool is_suitable = format.name != "bal" || structure_.is_bundle;
    if (is_suitable && format.can_write() && !format.is_folder())
      formats.push_back({format.name, format.extension});
  }
  return form_message(formats, setting_table(), [this](const Setting& setting, std::string_view word) {
    return why_unsuitable(*graph_, setting, word);
  });
}

bool GraphSubject::update_structure() {
  if (structure_.revision == graph_->revision()) return false;
  Structure structure = make_structure(*graph_, drawn_);
  if (structure_.count > 0) structure.center = structure_.center;  // so that the picture does not move
  structure_ = std::move(structure);
  return true;
}

Message GraphSubject::structure(std::uint64_t graph, std::uint64_t number) const {
  return structure_message(structure_, graph, number, scans_.of(*graph_, structure_));
}

Message GraphSubject::frame(const FrameFacts& facts, bool at_rest) const {
  return frame(facts, at_rest, {});
}

Message GraphSubject::uncertain_frame(const FrameFacts& facts, Listener& listener) const {
  const Uncertainty uncertainty = read_uncertainty(*graph_, structure_, listener.stop_flag());
  listener.log(uncertainty.vertices.empty() ? "warning" : "info", uncertainty.note);
  return frame(facts, true, uncertainty);
}

Message GraphSubject::frame(const FrameFacts& facts, bool at_rest, const Uncertainty& uncertainty) const {
  const Positions positions = read_positions(*graph_, structure_);
  const Errors errors = at_rest ? read_errors(*graph_, structure_, verdicts_) : Errors();
  return frame_message(facts, structure_, positions, errors, uncertainty,
                       truth_ ? truth_->fit(*graph_, structure_) : std::nullopt);
}

void GraphSubject::open_truth(const std::string& name, const std::string& text, Listener& listener) {
  set_truth(parse_truth(name, text), listener);
}

void GraphSubject::set_truth(Truth truth, Listener& listener) {
  truth.match(*graph_, file_, name_);
  const TruthFacts& facts = truth.facts();
  listener.log("info",
               fmt::format("{} is the truth: {} of {} poses match {} of {} true poses by {}", facts.name,
                           facts.matched, facts.poses, facts.matched, facts.true_poses, facts.matched_by));
  truth_ = std::move(truth);
  std::ignore = truth_->place(*graph_, structure_);
}

Message GraphSubject::truth(std::uint64_t structure) {
  if (!truth_) return nullptr;
  const TruthPlaces places = truth_->place(*graph_, structure_);
  return truth_message(structure, truth_->facts(), places);
}

std::string GraphSubject::describe(const ElementName& name, std::uint64_t structure) const {
  return element_json(*graph_, structure_, name, structure, verdicts_);
}

std::string GraphSubject::edit(const Edit& edit) {
  if (!own_) throw InvalidArgument("the graph is that of a program, so pages cannot edit it");
  return apply(edit, *graph_, structure_);
}

std::string GraphSubject::remove_false_edges() {
  if (!own_) throw InvalidArgument("the graph is that of a program, so pages cannot edit it");
  const std::vector<EdgeRef> edges = verdicts_.edges(Verdict::kOutlier);
  if (edges.empty()) throw InvalidArgument("the last run found no false edges");
  std::size_t removed = 0;
  for (const EdgeRef edge : edges) {
    if (!graph_->contains(edge)) continue;
    graph_->remove(edge);
    ++removed;
  }
  verdicts_ = {};
  return fmt::format("{} {} removed", counted(removed, "false edge"), removed == 1 ? "is" : "are");
}

void GraphSubject::check(const Settings& settings) const {
  std::ignore = run_settings(settings);
  for (const Setting& setting : setting_table()) {
    const auto chosen = settings.find(setting.name);
    if (setting.kind != Setting::Kind::kChoice || chosen == settings.end()) continue;
    const std::string reason = why_unsuitable(*graph_, setting, chosen->second);
    if (!reason.empty())
      throw InvalidArgument(fmt::format("{} {}: {}", setting.name, chosen->second, reason));
  }
}

Outcome GraphSubject::run(const Settings& settings, Listener& listener) {
  const RunSettings chosen = run_settings(settings);
  if (chosen.suspects) return search(chosen, listener);
  return outcome(outcome_of(
      optimize(chosen, listener, [&](const IterationRecord& record) { return listener.note(record); })));
}

/// Shows the stages of a search for false edges as rows before the iterations of the last run, which begins
/// where the search ends: often at the minimum.
Outcome GraphSubject::search(const RunSettings& settings, Listener& listener) {
  const double chi2_before = graph_->chi2();
  const auto begin = std::chrono::steady_clock::now();
  std::vector<IterationRecord> stages;
  try_odometry(settings, chi2_before, listener, stages);
  const auto note_search = [&](double chi2) {
    const double before = stages.empty() ? chi2_before : stages.back().chi2;
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - begin;
    stages.push_back({.iteration = static_cast<int>(stages.size()) + 1,
                      .chi2 = chi2,
                      .chi2_decrease = before - chi2,
                      .time_s = time.count()});
    listener.note_stage("search", stages.back());
  };
  bool is_searching = true;
  const auto shifted = [&](IterationRecord record) {
    record.iteration += static_cast<int>(stages.size());
    record.time_s += stages.back().time_s;
    return record;
  };
  const Options options = begin_run(settings, listener, [&](const IterationRecord& record) {
    if (std::exchange(is_searching, false)) note_search(record.chi2 + record.chi2_decrease);
    return listener.note(shifted(record));
  });
  const OutlierReport found = find_outliers(*graph_, {.options = options, .suspects = *settings.suspects});
  const Report& report = found.report;
  note_verdicts(found, listener);
  Outcome result = outcome(outcome_of(found));
  if (is_searching) note_search(std::isfinite(report.chi2_initial) ? report.chi2_initial : result.chi2);
  std::ranges::transform(result.rows, result.rows.begin(), shifted);
  result.rows.insert(result.rows.begin(), stages.begin(), stages.end());
  result.stages =
      stages.size() > 1 ? std::vector<std::string>{"odometry", "search"} : std::vector<std::string>{"search"};
  if (!has_chi2(report)) return result;
  const std::size_t undecided = found.count(Verdict::kUndecided);
  result.headline = fmt::format("{}: chi2 {:.9g} → {:.9g} without {}{}", result.status, chi2_before,
                                result.chi2, counted(result.false_edges, "false edge"),
                                undecided > 0 ? fmt::format(" ({} of {} undecided)", undecided,
                                                            counted(found.verdicts.size(), "suspect"))
                                              : "");
  result.summary = fmt::format("{}\n\nThe last run, after the search:\n{}", result.headline, result.summary);
  return result;
}

/// The search begins with the odometry, if there is any: it is the first stage. The estimates stay.
void GraphSubject::try_odometry(const RunSettings& settings, double chi2_before, Listener& listener,
                                std::vector<IterationRecord>& stages) {
  RunSettings guess = settings;
  guess.options.start = Start::kOdometry;
  guess.options.max_iterations = 0;
  graph_->push();
  try {
    const Report report = optimize(guess, listener, {});
    if (report.start.used == Start::kOdometry && std::isfinite(report.chi2_final)) {
      stages.push_back({.iteration = 1,
                        .chi2 = report.chi2_final,
                        .chi2_decrease = chi2_before - report.chi2_final,
                        .time_s = report.time.total_s});
      listener.note_stage("odometry", stages.back());
    }
  } catch (...) {
    graph_->pop();
    throw;
  }
  graph_->pop();
}

Outcome GraphSubject::step(const Settings& settings, Listener& listener) {
  RunSettings one = run_settings(settings);
  one.options.start = Start::kCurrent;
  one.options.max_iterations = 1;
  return outcome(outcome_of(
      optimize(one, listener, [&](const IterationRecord& record) { return listener.note(record); })));
}

bool GraphSubject::guess(const std::string& start, Listener& listener) {
  RunSettings settings = run_settings({{"start", start}});
  settings.options.max_iterations = 0;
  const Report report = optimize(settings, listener, {});
  if (report.start.used == settings.options.start) {
    listener.log("info", fmt::format("the initial guess {} has chi2 {:.9g}", to_string(report.start.used),
                                     outcome(outcome_of(report)).chi2));
    return true;
  }
  listener.log("warning", fmt::format("no initial guess {} was made: {}", to_string(settings.options.start),
                                      report.start.note.empty() ? report.message : report.start.note));
  return false;
}

void GraphSubject::restore() {
  verdicts_ = {};
  if (std::exchange(has_kernels_, false)) robustify(*graph_, {});
  graph_->pop();
  graph_->push();
}

void GraphSubject::drop_estimates() {
  graph_->discard_top();
}

std::string GraphSubject::diagnosis(std::uint64_t structure, const std::atomic<bool>& stop) const {
  Options options;
  options.stop = &stop;
  // Otherwise, the false edges pull at the minimum that was found without them.
  const std::vector<EdgeRef> all = graph_->all_edges();
  std::ranges::copy_if(all, std::back_inserter(options.edges),
                       [&](EdgeRef edge) { return verdicts_.of(edge) != Verdict::kOutlier; });
  const std::size_t left_out = all.size() - options.edges.size();
  if (left_out == 0) options.edges.clear();
  const Diagnosis diagnosis = diagnose(*graph_, options);
  if (!diagnosis.is_complete) throw InvalidArgument("the diagnosis was stopped");
  return diagnosis_json(*graph_, structure_, diagnosis, structure, left_out);
}

Message GraphSubject::pattern(const std::atomic<bool>& stop) const {
  return pattern_message(read_pattern(*graph_, StopToken(&stop)));
}

std::string GraphSubject::formatted(const std::string& format) const {
  return file_ != nullptr ? format_graph(*file_, {.format = format})
                          : format_graph(*graph_, {.format = format});
}

void GraphSubject::log_notes(Listener& listener) const {
  listener.log("info",
               fmt::format("{}: {} vertices, {} edges", name_, graph_->vertex_count(), graph_->edge_count()));
  constexpr std::size_t kMostNotes = 100;
  for (std::size_t k = 0; k < std::min(file_->notes.size(), kMostNotes); ++k) {
    const GraphFile::Note& note = file_->notes[k];
    listener.log("warning", note.line > 0 ? fmt::format("{}:{}: {}", name_, note.line, note.text)
                                          : fmt::format("{}: {}", name_, note.text));
  }
  if (file_->notes.size() > kMostNotes)
    listener.log("warning", fmt::format("… and {} more notes", file_->notes.size() - kMostNotes));
  for (const std::string& note : scans_.notes()) listener.log("warning", note);
  if (structure_.left_out > 0) {
    listener.log("warning", fmt::format("{} lines are not drawn, because there are more than {}",
                                        structure_.left_out, Structure::kMostLines));
  }
}

/// Returns the options of a run that begins.
Options GraphSubject::begin_run(const RunSettings& settings, Listener& listener, const Callback& callback) {
  verdicts_ = {};
  set_kernels(settings, listener);
  Options options = settings.options;
  options.stop = &listener.stop_flag();
  options.callback = callback;
  return options;
}

Report GraphSubject::optimize(const RunSettings& settings, Listener& listener, const Callback& callback) {
  Options options = begin_run(settings, listener, callback);
  if (optimizer_) {
    optimizer_->set_options(std::move(options));
  } else {
    optimizer_ = std::make_unique<Optimizer>(*graph_, std::move(options));
  }
  return optimizer_->run();
}

void GraphSubject::note_verdicts(const OutlierReport& found, Listener& listener) {
  verdicts_ = Verdicts(found.verdicts);
  if (!found.note.empty()) listener.log("warning", found.note);
  if (found.verdicts.empty()) return;
  listener.log("info", fmt::format("{} of {} suspected edges are false, and {} are undecided; color edges by "
                                   "verdict to see them",
                                   found.count(Verdict::kOutlier), found.verdicts.size(),
                                   found.count(Verdict::kUndecided)));
}

/// There is no chi2 if the run was stopped before it evaluated chi2.
Outcome GraphSubject::outcome(Outcome outcome) const {
  if (!std::isfinite(outcome.chi2)) outcome.chi2 = graph_->chi2();
  return outcome;
}

/// Sets the kernels that a run wants, and removes those of the last run.
void GraphSubject::set_kernels(const RunSettings& settings, Listener& listener) {
  if (!has_kernels_ && settings.kernel.empty()) return;
  const KernelFacts facts = robustify(*graph_, settings);
  has_kernels_ = facts.edges > 0;
  if (!facts.name.empty())
    listener.log("info", fmt::format("{} kernel on {} edges", facts.name, facts.edges));
}

std::unique_ptr<Subject> open_graph(const std::string& name, const std::string& text, Listener& listener) {
  GraphFile file = parse_graph(text, name);
  if (file.graph.vertex_count() == 0)
    throw InputError(name, file.lines + 1, 1, "expected a vertex or an edge, got the end of the file");
  if (file.vertices_created) {
    Options options;
    options.start = Start::kChordal;
    options.max_iterations = 0;
    options.stop = &listener.stop_flag();
    std::ignore = boxplus::optimize(file.graph, options);
    if (listener.stop_flag()) throw InvalidArgument(name + ": stopped, so the file was not opened");
  }
  auto subject = std::make_unique<GraphSubject>(std::move(file), name);
  subject->log_notes(listener);
  return subject;
}

}  // namespace boxplus::viewer
