// SPDX-License-Identifier: BSD-3-Clause
// What a workspace does with its subject: on the worker's thread, or on the thread of the program that holds
// it.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "viewer/workspace/workspace.h"

namespace boxplus::viewer {
namespace {

using Clock = std::chrono::steady_clock;

/// Identifies a graph, also for pages that were connected to an earlier process.
std::uint64_t milliseconds_since_1970() {
  const auto time = std::chrono::system_clock::now().time_since_epoch();
  return static_cast<std::uint64_t>(std::chrono::duration_cast<std::chrono::milliseconds>(time).count());
}

}  // namespace

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
    } catch (...) {
      failure = kUnknownException;
    }
    if (!failure.empty()) {
      log("error", failure);
      const std::lock_guard lock(mutex_);
      if (job.kind == Job::Kind::kOpen || job.kind == Job::Kind::kOpenTruth) error_ = failure;
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
    case Job::Kind::kOpenTruth:
      return read_truth(job);
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

void Workspace::read_truth(const Job& job) {
  {
    const std::lock_guard lock(mutex_);
    error_.clear();
  }
  subject_->open_truth(job.name, job.text, *this);
  set_truth(subject_->truth(structure_number_));
  ++frame_facts_.sequence;
  publish(subject_->frame(frame_facts_, true));
}

void Workspace::set_truth(Message truth) {
  const std::lock_guard lock(mutex_);
  truth_message_ = std::move(truth);
  ++truth_number_;
}

void Workspace::replace(std::unique_ptr<Subject> subject) {
  subject->keep_estimates();
  const double chi2 = subject->chi2();
  const std::uint64_t graph = std::max(graph_number_ + 1, milliseconds_since_1970());
  const Message form = subject->form(), structure = subject->structure(graph, structure_number_ + 1);
  const Message truth = subject->truth(structure_number_ + 1);
  edits_ = 0;
  set_diagnosis(nullptr);
  const std::unique_ptr<Subject> old = std::exchange(subject_, std::move(subject));
  {
    const std::lock_guard lock(mutex_);
    graph_number_ = graph;
    ++structure_number_;
    form_message_ = form;
    structure_message_ = structure;
    truth_message_ = truth;
    ++truth_number_;
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
  outdate_diagnosis(DiagnosisAge::kOtherEstimates);
  const std::lock_guard lock(mutex_);
  has_run_ = true;
  ++run_number_;
  rows_.clear();
  facts_of_run_ = {};
  history_.clear();
  if (frame_facts_.structure == structure_number_) history_.add(frame_of_iteration(*frame_message_, 0));
  is_first_frame_ = true;
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
  if_due([&] { make_frame(record.iteration, record.chi2, false); });
  return true;
}

/// Calls `show`, unless nobody reads, or the last call was too short ago for its share of the time.
void Workspace::if_due(const std::function<void()>& show) {
  if (readers_ == 0 || Clock::now() < next_frame_) return;
  constexpr auto kShortest = std::chrono::milliseconds(33);
  constexpr int kShare = 25;
  const auto begin = Clock::now();
  show();
  const auto end = Clock::now();
  next_frame_ = end + std::max<Clock::duration>(kShortest, kShare * (end - begin));
}

void Workspace::note_stage(const std::string& name, const IterationRecord& record) {
  {
    const std::lock_guard lock(mutex_);
    facts_of_run_.stages.push_back(name);
  }
  next_frame_ = {};  // a stage is always shown
  note(record);
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
    facts_of_run_ = outcome;
    facts_of_run_.rows.clear();
    facts_of_run_.verdicts.clear();
    has_run_ = true;
    ++run_number_;  // the kept rows replace those that the readers have
  }
  log(outcome.converged ? "info" : "warning", fmt::format("{}; {}", outcome.headline, outcome.reason));
  make_frame(static_cast<int>(outcome.rows.size()), outcome.chi2, true);
}

void Workspace::log(const char* level, std::string text) {
  const std::lock_guard lock(mutex_);
  log_.push_back({level, std::move(text)});
  if (log_.size() > kMostLines) {
    log_.pop_front();
    ++first_line_;
  }
  ++version_;
  has_news_.notify_all();
}

void Workspace::update_structure() {
  if (!subject_->update_structure()) return;
  outdate_diagnosis(DiagnosisAge::kOtherGraph);
  const Message form = subject_->form(),
                structure = subject_->structure(graph_number_, structure_number_ + 1),
                truth = subject_->truth(structure_number_ + 1);
  const std::lock_guard lock(mutex_);
  ++structure_number_;
  form_message_ = form;
  structure_message_ = structure;
  truth_message_ = truth;
  ++truth_number_;
  facts_ = subject_->facts();
  history_.clear();  // its frames belong to another structure
}

/// Keeps the newest frame before another one replaces it. A frame of iteration 0 begins anew.
void Workspace::keep_in_history(int iteration) {
  const std::lock_guard lock(mutex_);
  if (iteration == 0) history_.clear();
  // The frame before a run is in the history already.
  if (std::exchange(is_first_frame_, false)) return;
  if (frame_facts_.iteration < iteration && frame_facts_.structure == structure_number_)
    history_.add(frame_message_);
}

void Workspace::make_frame(int iteration, double chi2, bool at_rest) {
  update_structure();
  keep_in_history(iteration);
  outdate_diagnosis(DiagnosisAge::kOtherEstimates);
  frame_facts_ = {structure_number_, frame_facts_.sequence + 1, iteration, chi2};
  publish(subject_->frame(frame_facts_, at_rest));
}

void Workspace::add_covariances() {
  ++frame_facts_.sequence;
  publish(subject_->uncertain_frame(frame_facts_, *this));
}

void Workspace::set_diagnosis(Message diagnosis) {
  const std::lock_guard lock(mutex_);
  diagnosis_message_ = std::move(diagnosis);
  diagnosis_age_ = DiagnosisAge::kCurrent;
  ++diagnosis_number_;
}

/// A graph that has changed does not become the one that was diagnosed again.
void Workspace::outdate_diagnosis(DiagnosisAge age) {
  const std::lock_guard lock(mutex_);
  diagnosis_age_ = std::max(diagnosis_age_, age);
}

void Workspace::publish(Message frame) {
  const std::lock_guard lock(mutex_);
  frame_message_ = std::move(frame);
  sequence_ = frame_facts_.sequence;
  ++version_;
  has_news_.notify_all();
}

}  // namespace boxplus::viewer
