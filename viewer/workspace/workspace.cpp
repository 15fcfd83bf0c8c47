// SPDX-License-Identifier: BSD-3-Clause
#include "viewer/workspace/workspace.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace boxplus::viewer {
namespace {

using Clock = std::chrono::steady_clock;

constexpr const char* kBusy = "the viewer is busy: wait until the run ends, or stop it";
constexpr const char* kHeld = "the graph is in the hands of its program";
constexpr const char* kRunning = "running";
constexpr const char* kOutdated = "the graph has changed, so choose again";
constexpr const char* kNoGraph = "there is no graph: open a file first";

/// Identifies a graph, also for pages that were connected to an earlier process.
std::uint64_t milliseconds_since_1970() {
  const auto time = std::chrono::system_clock::now().time_since_epoch();
  return static_cast<std::uint64_t>(std::chrono::duration_cast<std::chrono::milliseconds>(time).count());
}

}  // namespace

Workspace::Workspace(Opener opener) : opener_(std::move(opener)) {
  worker_ = std::thread([this] { work(); });
}

Workspace::~Workspace() {
  end();
  worker_.join();
  if (subject_ && !is_held_) subject_->drop_estimates();
}

// ---- Commands ----

void Workspace::optimize(const Settings& settings) {
  request({.kind = Job::Kind::kRun, .settings = settings});
}

void Workspace::step(const Settings& settings) {
  request({.kind = Job::Kind::kStep, .settings = settings});
}

void Workspace::guess(const std::string& start) {
  if (start == to_string(Start::kCurrent) || start == to_string(Start::kAutomatic))
    throw InvalidArgument("expected the name of an initial guess");
  request({.kind = Job::Kind::kGuess, .settings = {{"start", start}}, .name = start});
}

void Workspace::covariances() {
  request({.kind = Job::Kind::kCovariances});
}

void Workspace::reset() {
  request({.kind = Job::Kind::kReset});
}

void Workspace::open(std::string name, std::string text) {
  if (!opener_) throw InvalidArgument("this viewer shows the graph of a program, and opens no files");
  request({.kind = Job::Kind::kOpen, .name = std::move(name), .text = std::move(text)});
}

void Workspace::expect_idle() const {
  const std::lock_guard lock(mutex_);
  if (is_busy_) throw Busy(is_held_ ? kHeld : kBusy);
}

void Workspace::stop() {
  const std::lock_guard lock(mutex_);
  if (!is_held_ || status_ == kRunning) stop_ = true;
}

void Workspace::show(std::unique_ptr<Subject> subject) {
  work_here(false, "reading", [&] { replace(std::move(subject)); });
}

void Workspace::show(GraphFile file, const std::string& name) {
  auto subject = std::make_unique<GraphSubject>(std::move(file), name);
  subject->log_notes(*this);
  show(std::move(subject));
}

std::string Workspace::formatted(const std::string& format) {
  std::string text;
  work_here(true, "saving", [&] { text = subject_->formatted(format); });
  return text;
}

void Workspace::edit(std::uint64_t structure, const Edit& edit) {
  work_here(true, "editing", [&] {
    if (structure != structure_number_) throw InvalidArgument(kOutdated);
    log("info", subject_->edit(edit));
    ++edits_;
    update_structure();
    leave_run(subject_->chi2());
  });
}

std::string Workspace::describe(std::uint64_t structure, const ElementName& name) const {
  const std::lock_guard lock(mutex_);  // so nobody can claim the workspace
  if (is_busy_) throw Busy(is_held_ ? kHeld : kBusy);
  if (!subject_) throw InvalidArgument(kNoGraph);
  if (structure != structure_number_) throw InvalidArgument(kOutdated);
  return subject_->describe(name, structure);
}

Message Workspace::pattern() {
  Message pattern;
  work_here(true, "computing the pattern", [&] {
    try {
      pattern = subject_->pattern(stop_);
    } catch (const Stopped&) {
      throw InvalidArgument("the computation of the pattern was stopped");
    }
  });
  return pattern;
}

/// Works on the calling thread instead of the worker's.
void Workspace::work_here(bool needs_graph, const char* activity, const std::function<void()>& work) {
  {
    const std::lock_guard lock(mutex_);
    claim(needs_graph);
    stop_ = false;
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

const char* Workspace::activity_of(Job::Kind kind) {
  switch (kind) {
    case Job::Kind::kOpen:
      return "reading";
    case Job::Kind::kCovariances:
      return "computing covariances";
    default:
      return "optimizing";
  }
}

/// Makes the caller, who holds mutex_, the only one that uses the graph, until release().
void Workspace::claim(bool needs_graph) {
  if (ending_) throw InvalidArgument("the viewer is ending");
  if (is_busy_) throw Busy(is_held_ ? kHeld : kBusy);
  if (needs_graph && !subject_) throw InvalidArgument(kNoGraph);
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
  if (!is_busy_ && subject_) subject_->check(job.settings);
  claim(job.kind != Job::Kind::kOpen);
  stop_ = false;
  activity_ = activity_of(job.kind);
  job_ = std::move(job);
  has_job_.notify_all();
}

// ---- A program that holds the workspace ----

void Workspace::hold() {
  std::unique_lock lock(mutex_);
  if (is_held_) return;
  stop_ = true;
  has_news_.wait(lock, [this] { return ending_ || !is_busy_; });
  stop_ = false;
  is_busy_ = is_held_ = true;
  activity_ = "in the hands of the program";
  if (subject_) subject_->drop_estimates();
  ++version_;
  has_news_.notify_all();
}

void Workspace::hand_over() {
  if (!is_held_) return;
  update();
  subject_->keep_estimates();
  {
    const std::lock_guard lock(mutex_);
    is_held_ = false;
  }
  release();
}

bool Workspace::watch(const IterationRecord& record) {
  if (record.iteration == 1) begin_run();
  note(record);
  return !stop_;
}

void Workspace::watch_end(const Outcome& outcome) {
  finish(outcome);
}

void Workspace::update() {
  const double chi2 = subject_->chi2();
  {
    const std::lock_guard lock(mutex_);
    chi2_ = chi2;
    if (status_ == kRunning) status_ = "ended";
  }
  make_frame(static_cast<int>(rows_.size()), chi2, true);
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
      log("error", failure);
      const std::lock_guard lock(mutex_);
      if (job.kind == Job::Kind::kOpen) error_ = failure;
      if (job.kind == Job::Kind::kRun || job.kind == Job::Kind::kStep) {
        status_ = "failed";
        headline_ = failure;
      }
    }
    release();
  }
}

void Workspace::carry_out(const Job& job) {
  switch (job.kind) {
    case Job::Kind::kOpen:
      return read(job);
    case Job::Kind::kGuess:
      return make_guess(job.name);
    case Job::Kind::kCovariances:
      return add_covariances();
    case Job::Kind::kReset:
      return restore();
    case Job::Kind::kStep:
      begin_run();
      return finish(subject_->step(job.settings, *this));
    default:
      begin_run();
      return finish(subject_->run(job.settings, *this));
  }
}

void Workspace::read(const Job& job) {
  {
    const std::lock_guard lock(mutex_);
    error_.clear();
  }
  replace(opener_(job.name, job.text, *this));
}

void Workspace::replace(std::unique_ptr<Subject> subject) {
  subject->keep_estimates();
  const double chi2 = subject->chi2();
  const std::uint64_t graph = std::max(graph_number_ + 1, milliseconds_since_1970());
  const Message form = subject->form(), structure = subject->structure(graph, structure_number_ + 1);
  edits_ = 0;
  const std::unique_ptr<Subject> old = std::exchange(subject_, std::move(subject));
  {
    const std::lock_guard lock(mutex_);
    graph_number_ = graph;
    ++structure_number_;
    form_message_ = form;
    structure_message_ = structure;
    facts_ = subject_->facts();
    chi2_ = chi2_initial_ = chi2;
    has_run_ = false;
    rows_.clear();
  }
  make_frame(0, chi2, true);
}

/// The rows of a new run replace those of the last one.
void Workspace::begin_run() {
  next_frame_ = {};
  const std::lock_guard lock(mutex_);
  has_run_ = true;
  ++run_number_;
  rows_.clear();
  status_ = kRunning;
  headline_.clear();
  summary_.clear();
  ++version_;
  has_news_.notify_all();
}

void Workspace::make_guess(const std::string& start) {
  const bool is_made = subject_->guess(start, *this);
  const double chi2 = subject_->chi2();
  set_chi2(chi2);
  if (is_made) make_frame(0, chi2, true);
}

void Workspace::restore() {
  subject_->restore();
  const double chi2 = subject_->chi2();
  if (edits_ > 0) {
    const std::lock_guard lock(mutex_);
    chi2_initial_ = chi2;
  }
  leave_run(chi2);
  log("info", edits_ == 0 ? "the estimates are those of the file"
                          : "the estimates are those of the file; what was edited stays edited");
}

/// Shows estimates that are not the result of the last run.
void Workspace::leave_run(double chi2) {
  {
    const std::lock_guard lock(mutex_);
    chi2_ = chi2;
    has_run_ = false;
    rows_.clear();
    ++run_number_;
  }
  make_frame(0, chi2, true);
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

void Workspace::set_chi2(double chi2) {
  const std::lock_guard lock(mutex_);
  chi2_ = chi2;
}

void Workspace::finish(const Outcome& outcome) {
  {
    const std::lock_guard lock(mutex_);
    rows_ = outcome.rows;
    chi2_ = outcome.chi2;
    status_ = outcome.status;
    headline_ = outcome.headline;
    summary_ = outcome.summary;
    has_run_ = true;
    ++run_number_;  // the kept rows replace those that the readers have
  }
  log(outcome.converged ? "info" : "warning", fmt::format("{}; {}", outcome.headline, outcome.reason));
  make_frame(static_cast<int>(outcome.rows.size()), outcome.chi2, true);
}

void Workspace::log(const char* level, std::string text) {
  const std::lock_guard lock(mutex_);
  log_.push_back({level, std::move(text)});
  ++version_;
  has_news_.notify_all();
}

void Workspace::update_structure() {
  if (!subject_->update_structure()) return;
  const Message form = subject_->form(),
                structure = subject_->structure(graph_number_, structure_number_ + 1);
  const std::lock_guard lock(mutex_);
  ++structure_number_;
  form_message_ = form;
  structure_message_ = structure;
  facts_ = subject_->facts();
}

void Workspace::make_frame(int iteration, double chi2, bool at_rest) {
  update_structure();
  frame_facts_ = {structure_number_, frame_facts_.sequence + 1, iteration, chi2};
  publish(subject_->frame(frame_facts_, at_rest));
}

void Workspace::add_covariances() {
  ++frame_facts_.sequence;
  publish(subject_->uncertain_frame(frame_facts_, *this));
}

void Workspace::publish(Message frame) {
  const std::lock_guard lock(mutex_);
  frame_message_ = std::move(frame);
  sequence_ = frame_facts_.sequence;
  ++version_;
  has_news_.notify_all();
}

}  // namespace boxplus::viewer
