// SPDX-License-Identifier: BSD-3-Clause
#include "viewer/workspace/workspace.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "boxplus/base/error.h"

namespace boxplus::viewer {
namespace {

using Json = nlohmann::json;
using Clock = std::chrono::steady_clock;

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

Workspace::Workspace(GraphFile file, std::string name)
    : file_(std::move(file)), structure_(make_structure(file_.graph)), name_(std::move(name)) {
  file_.graph.push();
  chi2_ = chi2_initial_ = file_.graph.chi2();
  structure_message_ = structure_message(structure_, structure_number_);
  add_line("info", fmt::format("{}: {} vertices, {} edges", name_, file_.graph.vertex_count(),
                               file_.graph.edge_count()));
  constexpr std::size_t kMostNotes = 100;
  for (std::size_t k = 0; k < std::min(file_.notes.size(), kMostNotes); ++k) {
    const GraphFile::Note& note = file_.notes[k];
    add_line("warning", note.line > 0 ? fmt::format("{}:{}: {}", name_, note.line, note.text)
                                      : fmt::format("{}: {}", name_, note.text));
  }
  if (file_.notes.size() > kMostNotes)
    add_line("warning", fmt::format("… and {} more notes", file_.notes.size() - kMostNotes));
  if (structure_.left_out > 0)
    add_line("warning", fmt::format("{} lines are not drawn, because there are more than {}",
                                    structure_.left_out, Structure::kMostLines));
  make_frame(0, chi2_, true);
  worker_ = std::thread([this] { work(); });
}

Workspace::~Workspace() {
  end();
  worker_.join();
}

void Workspace::optimize(int iterations) {
  if (iterations < 1 || iterations > kMostIterations)
    throw InvalidArgument(
        fmt::format("iterations: expected a number from 1 to {}, got {}", kMostIterations, iterations));
  request(Job::kOptimize, iterations);
}

void Workspace::step() {
  request(Job::kStep, 1);
}

void Workspace::reset() {
  request(Job::kReset, 0);
}

void Workspace::stop() {
  stop_ = true;
}

void Workspace::end() {
  const std::lock_guard lock(mutex_);
  ending_ = true;
  stop_ = true;
  has_job_.notify_all();
  has_news_.notify_all();
}

void Workspace::request(Job job, int iterations) {
  const std::lock_guard lock(mutex_);
  if (ending_) throw InvalidArgument("the viewer is ending");
  if (is_busy_) throw InvalidArgument("a run is in progress: stop it first");
  stop_ = false;
  job_ = job;
  iterations_ = iterations;
  is_busy_ = true;
  if (job != Job::kReset) {
    ++run_number_;
    rows_.clear();
    status_ = "running";
    headline_.clear();
    summary_.clear();
  }
  ++version_;
  has_job_.notify_all();
  has_news_.notify_all();
}

void Workspace::work() {
  for (;;) {
    Job job;
    int iterations;
    {
      std::unique_lock lock(mutex_);
      has_job_.wait(lock, [this] { return ending_ || job_ != Job::kNone; });
      if (ending_) return;
      job = std::exchange(job_, Job::kNone);
      iterations = iterations_;
    }
    std::string failure;
    try {
      job == Job::kReset ? restore() : run(job, iterations);
    } catch (const std::bad_alloc&) {
      failure = "not enough memory";
    } catch (const std::exception& error) {
      failure = error.what();
    }
    if (!failure.empty()) add_line("error", failure);
    const std::lock_guard lock(mutex_);
    if (!failure.empty()) {
      status_ = "failed";
      headline_ = failure;
    }
    is_busy_ = false;
    ++version_;
    has_news_.notify_all();
  }
}

void Workspace::run(Job job, int iterations) {
  Options options;
  options.start = job == Job::kOptimize ? Start::kAutomatic : Start::kCurrent;
  options.max_iterations = iterations;
  options.stop = &stop_;
  options.callback = [this](const IterationRecord& record) { return note(record); };
  if (optimizer_) {
    optimizer_->set_options(std::move(options));
  } else {
    optimizer_ = std::make_unique<Optimizer>(file_.graph, std::move(options));
  }
  next_frame_ = {};
  finish(optimizer_->run());
}

void Workspace::restore() {
  file_.graph.pop();
  file_.graph.push();
  const double chi2 = file_.graph.chi2();
  {
    const std::lock_guard lock(mutex_);
    chi2_ = chi2;
    rows_.clear();
    status_ = headline_ = summary_ = {};
    run_number_ = run_number_ == 0 ? 0 : run_number_ + 1;
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

void Workspace::finish(const Report& report) {
  const std::string text = to_string(report);
  {
    const std::lock_guard lock(mutex_);
    rows_ = report.records;
    chi2_ = report.chi2_final;
    status_ = to_string(report.status);
    headline_ = text.substr(0, text.find('\n'));
    summary_ = text;
    ++run_number_;  // the kept rows replace those that the readers have
  }
  add_line(report.converged() ? "info" : "warning", fmt::format("{}; {}", headline_, report.message));
  make_frame(report.iterations, report.chi2_final, true);
}

void Workspace::add_line(const char* level, std::string text) {
  const std::lock_guard lock(mutex_);
  log_.push_back({level, std::move(text)});
  ++version_;
  has_news_.notify_all();
}

void Workspace::make_frame(int iteration, double chi2, bool at_rest) {
  const Positions positions = read_positions(file_.graph, structure_);
  const std::vector<float> errors =
      at_rest && structure_.is_bundle ? read_point_errors(file_.graph, structure_) : std::vector<float>();
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
  if (std::exchange(structure_, w.structure_number_) != w.structure_number_)
    messages.push_back(w.structure_message_);
  if (std::exchange(frame_, w.sequence_) != w.sequence_) messages.push_back(w.frame_message_);
  return messages;
}

std::string Workspace::Reader::state_json() const {
  const Workspace& w = workspace_;
  Json state = greeting_.empty() ? Json::object() : Json::parse(greeting_);
  state["busy"] = w.is_busy_;
  state["activity"] = w.is_busy_ ? "optimizing" : "";
  state["file"] = {{"name", w.name_},
                   {"format", w.file_.format},
                   {"vertices", w.file_.graph.vertex_count()},
                   {"edges", w.file_.graph.edge_count()},
                   {"dimension", w.structure_.dimension}};
  state["chi2"] = w.chi2_;
  state["chi2_initial"] = w.chi2_initial_;
  state["can_step"] = !w.is_busy_ && w.file_.graph.edge_count() > 0;
  if (w.run_number_ > 0) {
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
