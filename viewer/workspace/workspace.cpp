// SPDX-License-Identifier: BSD-3-Clause
#include "viewer/workspace/workspace.h"

#include <utility>

namespace boxplus::viewer {
namespace {

constexpr const char* kBusy = "the viewer is busy: wait until the run ends, or stop it";
constexpr const char* kHeld = "the graph is in the hands of its program";
constexpr const char* kOutdated = "the graph has changed, so choose again";
constexpr const char* kNoGraph = "there is no graph: open a file first";

/// Does the work. What a function of the user throws becomes an InvalidArgument.
template <class F>
auto translated(F&& work) {
  try {
    return work();
  } catch (const InvalidArgument&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw InvalidArgument("not enough memory");
  } catch (const std::exception& error) {
    throw InvalidArgument(error.what());
  } catch (...) {
    throw InvalidArgument(kUnknownException);
  }
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
  if (!opener_) throw InvalidArgument(kOpensNothing);
  request({.kind = Job::Kind::kOpen, .name = std::move(name), .text = std::move(text)});
}

void Workspace::open_truth(std::string name, std::string text) {
  if (!opener_) throw InvalidArgument(kOpensNothing);
  request({.kind = Job::Kind::kOpenTruth, .name = std::move(name), .text = std::move(text)});
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

void Workspace::show(GraphFile file, const std::string& name, std::optional<Truth> truth) {
  auto subject = std::make_unique<GraphSubject>(std::move(file), name);
  subject->log_notes(*this);
  if (truth) subject->set_truth(std::move(*truth), *this);
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
    outdate_diagnosis(DiagnosisAge::kOtherGraph);
    update_structure();
    leave_run(translated([&] { return subject_->chi2(); }));
  });
}

void Workspace::remove_false_edges() {
  work_here(true, "editing", [&] {
    log("info", subject_->remove_false_edges());
    ++edits_;
    outdate_diagnosis(DiagnosisAge::kOtherGraph);
    update_structure();
    leave_run(translated([&] { return subject_->chi2(); }));
  });
}

std::string Workspace::describe(std::uint64_t structure, const ElementName& name) const {
  const std::lock_guard lock(mutex_);  // so nobody can claim the workspace
  if (is_busy_) throw Busy(is_held_ ? kHeld : kBusy);
  if (!subject_) throw InvalidArgument(kNoGraph);
  if (structure != structure_number_) throw InvalidArgument(kOutdated);
  return translated([&] { return subject_->describe(name, structure); });
}

std::string Workspace::diagnosis() {
  std::string diagnosis;
  work_here(true, "diagnosing", [&] {
    diagnosis = translated([&] { return subject_->diagnosis(structure_number_, stop_); });
    set_diagnosis(make_message(MessageKind::kDiagnosis, diagnosis));
  });
  return diagnosis;
}

Message Workspace::pattern() {
  Message pattern;
  work_here(true, "computing the pattern", [&] {
    pattern = translated([&] {
      try {
        return subject_->pattern(stop_);
      } catch (const Stopped&) {
        throw InvalidArgument("the computation of the pattern was stopped");
      }
    });
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
    case Job::Kind::kOpenTruth:
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
  subject_->set_verdicts(outcome.verdicts);
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

void Workspace::follow() {
  if_due([this] { update(); });
}

}  // namespace boxplus::viewer
