// SPDX-License-Identifier: BSD-3-Clause
#include "viewer/workspace/graph_subject.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "boxplus/base/error.h"
#include "boxplus/io/file_format.h"
#include "viewer/server/diagnosis_json.h"
#include "viewer/server/element_json.h"
#include "viewer/settings/setting_table.h"

namespace boxplus::viewer {

Outcome outcome_of(const Report& report) {
  const std::string text = to_string(report);
  return {.status = std::string(to_string(report.status)),
          .headline = text.substr(0, text.find('\n')),
          .summary = text,
          .reason = report.message,
          .converged = report.converged(),
          .chi2 = report.chi2_final,
          .rows = report.records,
          .verdicts = report.verdicts};
}

GraphSubject::GraphSubject(GraphFile file, std::string name)
    : own_(std::move(file)),
      graph_(&own_->graph),
      file_(&*own_),
      name_(std::move(name)),
      scans_(*own_, name_) {
  structure_ = make_structure(*graph_);
}

GraphSubject::GraphSubject(Graph& graph, std::string name, const GraphFile* file)
    : graph_(&graph), file_(file), name_(std::move(name)) {
  structure_ = make_structure(*graph_);
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
    if (format.can_write() && !format.is_folder()) formats.push_back({format.name, format.extension});
  }
  return form_message(formats, setting_table(), [this](const Setting& setting, std::string_view word) {
    return why_unsuitable(*graph_, setting, word);
  });
}

bool GraphSubject::update_structure() {
  if (structure_.revision == graph_->revision()) return false;
  Structure structure = make_structure(*graph_);
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
  return outcome(optimize(run_settings(settings), listener, true));
}

Outcome GraphSubject::step(const Settings& settings, Listener& listener) {
  RunSettings one = run_settings(settings);
  one.options.start = Start::kCurrent;
  one.options.max_iterations = 1;
  one.options.outliers.reset();  // a search for outliers has no single steps
  return outcome(optimize(one, listener, true));
}

bool GraphSubject::guess(const std::string& start, Listener& listener) {
  RunSettings settings = run_settings({{"start", start}});
  settings.options.max_iterations = 0;
  const Report report = optimize(settings, listener, false);
  if (report.start.used == settings.options.start) {
    listener.log("info", fmt::format("the initial guess {} has chi2 {:.9g}", to_string(report.start.used),
                                     outcome(report).chi2));
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
  const Diagnosis diagnosis = diagnose(*graph_, options);
  if (!diagnosis.is_complete) throw InvalidArgument("the diagnosis was stopped");
  return diagnosis_json(*graph_, structure_, diagnosis, structure);
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

Report GraphSubject::optimize(const RunSettings& settings, Listener& listener, bool is_shown) {
  set_kernels(settings, listener);
  Options options = settings.options;
  options.stop = &listener.stop_flag();
  if (is_shown) options.callback = [&](const IterationRecord& record) { return listener.note(record); };
  if (optimizer_) {
    optimizer_->set_options(std::move(options));
  } else {
    optimizer_ = std::make_unique<Optimizer>(*graph_, std::move(options));
  }
  verdicts_ = {};
  Report report = optimizer_->run();
  note_verdicts(report, listener);
  return report;
}

void GraphSubject::note_verdicts(const Report& report, Listener& listener) {
  verdicts_ = Verdicts(report.verdicts);
  if (!report.outlier_note.empty()) listener.log("warning", report.outlier_note);
  if (report.verdicts.empty()) return;
  const auto count = [&](Verdict verdict) {
    return std::ranges::count(report.verdicts, verdict, &EdgeVerdict::verdict);
  };
  listener.log("info",
               fmt::format("{} of {} suspected edges are false, and {} are undecided; color edges by "
                           "verdict to see them",
                           count(Verdict::kOutlier), report.verdicts.size(), count(Verdict::kUndecided)));
}

/// The report has no chi2 if the run was stopped before it evaluated chi2.
Outcome GraphSubject::outcome(const Report& report) const {
  Outcome outcome = outcome_of(report);
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
