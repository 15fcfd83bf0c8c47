// SPDX-License-Identifier: BSD-3-Clause
#include "viewer/workspace/workspace.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <tuple>
#include <utility>

#include "boxplus/base/error.h"
#include "boxplus/optimize/optimizer.h"

namespace boxplus::viewer {
namespace {

using Json = nlohmann::json;
using Clock = std::chrono::steady_clock;

constexpr const char* kBusy = "the viewer is busy: wait until the run ends, or stop it";

Json row_json(const IterationRecord& record) {
  return {{"iteration", record.iteration}, {"chi2", record.chi2},     {"chi2_decrease", record.chi2_decrease},
          {"step_max", record.step_max},   {"lambda", record.lambda}, {"radius", record.radius},
          {"tries", record.tries},         {"time_s", record.time_s}};
}

/// Returns the items from `first` as an array.
template <class T, class F>
Json news_of(const std::vector<T>& items, std::size_t first, F&& json) {
  Json news = Json::array();
  for (std::size_t k = first; k < items.size(); ++k) news.push_back(json(items[k]));
  return news;
}

}  // namespace

Workspace::Workspace() {
  worker_ = std::thread([this] { work(); });
}

Workspace::~Workspace() {
  end();
  worker_.join();
}

// ---- Commands ----

void Workspace::optimize(RunSettings settings) {
  if (settings.options.max_iterations > kMostIterations)
    throw InvalidArgument(fmt::format("iterations: expected at most {}, got {}", kMostIterations,
                                      settings.options.max_iterations));
  request({.kind = Job::Kind::kRun, .settings = std::move(settings)});
}

void Workspace::step(RunSettings settings) {
  settings.options.start = Start::kCurrent;
  settings.options.max_iterations = 1;
  request({.kind = Job::Kind::kRun, .settings = std::move(settings)});
}

void Workspace::guess(RunSettings settings) {
  if (settings.options.start == Start::kCurrent || settings.options.start == Start::kAutomatic)
    throw InvalidArgument("expected the name of an initial guess");
  settings.options.max_iterations = 0;
  request({.kind = Job::Kind::kGuess, .settings = std::move(settings)});
}

void Workspace::reset() {
  request({.kind = Job::Kind::kReset});
}

void Workspace::open(std::string name, std::string text) {
  request({.kind = Job::Kind::kOpen, .name = std::move(name), .text = std::move(text)});
}

void Workspace::expect_idle() const {
  const std::lock_guard lock(mutex_);
  if (is_busy_) throw Busy(kBusy);
}

void Workspace::stop() {
  stop_ = true;
}

void Workspace::show(GraphFile file, const std::string& name) {
  work_here(false, "reading", [&] { replace(std::move(file), name); });
}

std::string Workspace::formatted(const std::string& format) {
  std::string text;
  work_here(true, "saving", [&] { text = format_graph(*file_, {.format = format}); });
  return text;
}

/// Works on the calling thread instead of the worker's.
void Workspace::work_here(bool needs_graph, const char* activity, const std::function<void()>& work) {
  {
    const std::lock_guard lock(mutex_);
    claim(needs_graph);
    activity_ = activity;
  }
  try {
    work();
  } catch (...) {
    release();
    throw;
  }
  release();
}

void Workspace::end() {
  const std::lock_guard lock(mutex_);
  ending_ = true;
  stop_ = true;
  has_job_.notify_all();
  has_news_.notify_all();
}

/// Makes the caller, who holds mutex_, the only one that uses the graph, until release().
void Workspace::claim(bool needs_graph) {
  if (ending_) throw InvalidArgument("the viewer is ending");
  if (is_busy_) throw Busy(kBusy);
  if (needs_graph && !file_) throw InvalidArgument("there is no graph: open a file first");
  is_busy_ = true;
  ++version_;
  has_news_.notify_all();
}

void Workspace::release() {
  const std::lock_guard lock(mutex_);
  is_busy_ = false;
  activity_ = "";
  ++version_;
  has_news_.notify_all();
}

void Workspace::request(Job job) {
  const std::lock_guard lock(mutex_);
  claim(job.kind != Job::Kind::kOpen);
  stop_ = false;
  activity_ = job.kind == Job::Kind::kOpen ? "reading" : "optimizing";
  job_ = std::move(job);
  has_job_.notify_all();
}

// ---- The worker ----

void Workspace::work() {
  for (;;) {
    Job job;
    {
      std::unique_lock lock(mutex_);
      has_job_.wait(lock, [this] { return ending_ || job_.kind != Job::Kind::kNone; });
      if (ending_) return;
      job = std::exchange(job_, Job());
    }
    std::string failure;
    try {
      carry_out(job);
    } catch (const std::bad_alloc&) {
      failure = "not enough memory";
    } catch (const std::exception& error) {
      failure = error.what();
    }
    if (!failure.empty()) {
      add_line("error", failure);
      const std::lock_guard lock(mutex_);
      if (job.kind == Job::Kind::kOpen) error_ = failure;
      if (job.kind == Job::Kind::kRun) {
        status_ = "failed";
        headline_ = failure;
      }
    }
    release();
  }
}

void Workspace::carry_out(Job& job) {
  switch (job.kind) {
    case Job::Kind::kOpen:
      return read(job);
    case Job::Kind::kGuess:
      return make_guess(job.settings);
    case Job::Kind::kReset:
      return restore();
    default:
      return finish(run(job.settings, true));
  }
}

void Workspace::read(const Job& job) {
  {
    const std::lock_guard lock(mutex_);
    error_.clear();
  }
  GraphFile file = parse_graph(job.text, job.name);
  if (file.graph.vertex_count() == 0)
    throw InputError(job.name, file.lines + 1, 1, "expected a vertex or an edge, got the end of the file");
  if (file.vertices_created) {
    Options options;
    options.start = Start::kChordal;
    options.max_iterations = 0;
    options.stop = &stop_;
    std::ignore = boxplus::optimize(file.graph, options);
    if (stop_) throw InvalidArgument(job.name + ": stopped, so the file was not opened");
  }
  replace(std::move(file), job.name);
}

void Workspace::replace(GraphFile file, const std::string& name) {
  Structure structure = make_structure(file.graph);
  file.graph.push();
  const double chi2 = file.graph.chi2();
  const Message form = form_message(file.graph),
                structure_text = structure_message(structure, structure_number_ + 1);
  optimizer_.reset();  // before its graph
  file_.emplace(std::move(file));
  structure_ = std::move(structure);
  has_kernels_ = false;
  {
    const std::lock_guard lock(mutex_);
    ++structure_number_;
    form_message_ = form;
    structure_message_ = structure_text;
    facts_ = {name, file_->format, file_->graph.vertex_count(), file_->graph.edge_count(),
              structure_.dimension};
    chi2_ = chi2_initial_ = chi2;
    has_run_ = false;
    rows_.clear();
  }
  make_frame(0, chi2, true);
  add_line("info", fmt::format("{}: {} vertices, {} edges", name, file_->graph.vertex_count(),
                               file_->graph.edge_count()));
  constexpr std::size_t kMostNotes = 100;
  for (std::size_t k = 0; k < std::min(file_->notes.size(), kMostNotes); ++k) {
    const GraphFile::Note& note_of_file = file_->notes[k];
    add_line("warning", note_of_file.line > 0
                            ? fmt::format("{}:{}: {}", name, note_of_file.line, note_of_file.text)
                            : fmt::format("{}: {}", name, note_of_file.text));
  }
  if (file_->notes.size() > kMostNotes)
    add_line("warning", fmt::format("… and {} more notes", file_->notes.size() - kMostNotes));
  if (structure_.left_out > 0)
    add_line("warning", fmt::format("{} lines are not drawn, because there are more than {}",
                                    structure_.left_out, Structure::kMostLines));
}

/// Sets the kernels that a run wants, and removes those of the last run.
void Workspace::set_kernels(const RunSettings& settings) {
  if (!has_kernels_ && settings.kernel.empty()) return;
  const KernelFacts facts = robustify(file_->graph, settings);
  has_kernels_ = facts.edges > 0;
  if (!facts.name.empty()) add_line("info", fmt::format("{} kernel on {} edges", facts.name, facts.edges));
}

/// The rows of a run that is shown replace those of the last one.
Report Workspace::run(const RunSettings& settings, bool is_shown) {
  set_kernels(settings);
  if (is_shown) {
    const std::lock_guard lock(mutex_);
    has_run_ = true;
    ++run_number_;
    rows_.clear();
    status_ = "running";
    headline_.clear();
    summary_.clear();
    ++version_;
    has_news_.notify_all();
  }
  Options options = settings.options;
  options.stop = &stop_;
  if (is_shown) options.callback = [this](const IterationRecord& record) { return note(record); };
  if (optimizer_) {
    optimizer_->set_options(std::move(options));
  } else {
    optimizer_ = std::make_unique<Optimizer>(file_->graph, std::move(options));
  }
  next_frame_ = {};
  return optimizer_->run();
}

void Workspace::make_guess(const RunSettings& settings) {
  const Report report = run(settings, false);
  const double chi2 = final_chi2(report);
  {
    const std::lock_guard lock(mutex_);
    chi2_ = chi2;
  }
  if (report.start.used != settings.options.start) {
    add_line("warning", fmt::format("no initial guess {} was made: {}", to_string(settings.options.start),
                                    report.start.note.empty() ? report.message : report.start.note));
    return;
  }
  add_line("info", fmt::format("the initial guess {} has chi2 {:.9g}", to_string(report.start.used), chi2));
  make_frame(0, chi2, true);
}

void Workspace::restore() {
  set_kernels({});
  file_->graph.pop();
  file_->graph.push();
  const double chi2 = file_->graph.chi2();
  {
    const std::lock_guard lock(mutex_);
    chi2_ = chi2;
    has_run_ = false;
    rows_.clear();
    ++run_number_;
  }
  make_frame(0, chi2, true);
  add_line("info", "the estimates are those of the file");
}

bool Workspace::note(const IterationRecord& record) {
  {
    const std::lock_guard lock(mutex_);
    rows_.push_back(record);
    chi2_ = record.chi2;
    ++version_;
    has_news_.notify_all();
  }
  if (readers_ == 0 || Clock::now() < next_frame_) return true;
  constexpr auto kShortest = std::chrono::milliseconds(33);
  constexpr int kShare = 25;
  const auto begin = Clock::now();
  make_frame(record.iteration, record.chi2, false);
  const auto end = Clock::now();
  next_frame_ = end + std::max<Clock::duration>(kShortest, kShare * (end - begin));
  return true;
}

/// chi2 at the end of a run. The report has none if the run was stopped before it evaluated chi2.
double Workspace::final_chi2(const Report& report) const {
  return std::isfinite(report.chi2_final) ? report.chi2_final : file_->graph.chi2();
}

void Workspace::finish(const Report& report) {
  const std::string text = to_string(report);
  const double chi2 = final_chi2(report);
  {
    const std::lock_guard lock(mutex_);
    rows_ = report.records;
    chi2_ = chi2;
    status_ = to_string(report.status);
    headline_ = text.substr(0, text.find('\n'));
    summary_ = text;
    ++run_number_;  // the kept rows replace those that the readers have
  }
  add_line(report.converged() ? "info" : "warning", fmt::format("{}; {}", headline_, report.message));
  make_frame(report.iterations, chi2, true);
}

void Workspace::add_line(const char* level, std::string text) {
  const std::lock_guard lock(mutex_);
  log_.push_back({level, std::move(text)});
  ++version_;
  has_news_.notify_all();
}

void Workspace::make_frame(int iteration, double chi2, bool at_rest) {
  const Positions positions = read_positions(file_->graph, structure_);
  const std::vector<float> errors =
      at_rest && structure_.is_bundle ? read_point_errors(file_->graph, structure_) : std::vector<float>();
  const std::uint64_t sequence = sequence_ + 1;  // only this thread writes it
  Message message =
      frame_message({structure_number_, sequence, iteration, chi2}, structure_, positions, errors);
  const std::lock_guard lock(mutex_);
  frame_message_ = std::move(message);
  sequence_ = sequence;
  ++version_;
  has_news_.notify_all();
}

Workspace::Reader::Reader(Workspace& workspace, std::string greeting)
    : workspace_(workspace), greeting_(std::move(greeting)) {
  ++workspace_.readers_;
}

Workspace::Reader::~Reader() {
  --workspace_.readers_;
}

std::vector<Message> Workspace::Reader::wait(std::chrono::milliseconds patience) {
  Workspace& w = workspace_;
  std::unique_lock lock(w.mutex_);
  w.has_news_.wait_for(lock, patience, [&] { return w.ending_ || w.version_ != version_; });
  std::vector<Message> messages;
  if (w.version_ == version_) return messages;
  version_ = w.version_;
  messages.push_back(make_message(MessageKind::kState, state_json()));
  greeting_.clear();
  run_ = w.run_number_;
  rows_ = w.rows_.size();
  lines_ = w.log_.size();
  if (std::exchange(structure_, w.structure_number_) != w.structure_number_) {
    messages.push_back(w.form_message_);
    messages.push_back(w.structure_message_);
  }
  if (std::exchange(frame_, w.sequence_) != w.sequence_) messages.push_back(w.frame_message_);
  return messages;
}

std::string Workspace::Reader::state_json() const {
  const Workspace& w = workspace_;
  Json state = greeting_.empty() ? Json::object() : Json::parse(greeting_);
  state["busy"] = w.is_busy_;
  state["activity"] = w.activity_;
  state["error"] = w.error_.empty() ? Json(nullptr) : Json(w.error_);
  state["file"] = nullptr;
  if (w.facts_) {
    state["file"] = {{"name", w.facts_->name},
                     {"format", w.facts_->format},
                     {"vertices", w.facts_->vertices},
                     {"edges", w.facts_->edges},
                     {"dimension", w.facts_->dimension}};
  }
  state["chi2"] = w.chi2_;
  state["chi2_initial"] = w.chi2_initial_;
  state["can_step"] = !w.is_busy_ && w.facts_ && w.facts_->edges > 0;
  if (w.has_run_) {
    const std::size_t first = run_ == w.run_number_ ? rows_ : 0;
    state["run"] = {
        {"number", w.run_number_}, {"first_row", first},      {"rows", news_of(w.rows_, first, row_json)},
        {"status", w.status_},     {"headline", w.headline_}, {"summary", w.summary_}};
  } else {
    state["run"] = nullptr;
  }
  state["log"] = {{"first", lines_}, {"lines", news_of(w.log_, lines_, [](const Line& line) {
                                        return Json{{"level", line.level}, {"text", line.text}};
                                      })}};
  // Names and notes may contain bytes of the file that are not valid UTF-8.
  return state.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace boxplus::viewer
