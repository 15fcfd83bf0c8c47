// SPDX-License-Identifier: BSD-3-Clause
// What a reader of a workspace gets: the state as JSON, and the messages that are new to it.
#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "viewer/workspace/workspace.h"

namespace boxplus::viewer {
namespace {

using Json = nlohmann::json;

Json row_json(const IterationRecord& record) {
  return {{"iteration", record.iteration}, {"chi2", record.chi2},     {"chi2_decrease", record.chi2_decrease},
          {"step_max", record.step_max},   {"lambda", record.lambda}, {"radius", record.radius},
          {"tries", record.tries},         {"time_s", record.time_s}};
}

/// Returns the items from `first` as an array.
template <class Items, class F>
Json news_of(const Items& items, std::size_t first, F&& json) {
  Json news = Json::array();
  for (std::size_t k = first; k < items.size(); ++k) news.push_back(json(items[k]));
  return news;
}

/// Numbers that are not finite become null.
void add_facts(Json& run, const Outcome& outcome) {
  run["stages"] = outcome.stages;
  run["start"] =
      outcome.start.empty() ? Json(nullptr) : Json{{"name", outcome.start}, {"chi2", outcome.chi2_start}};
  run["chi2_per_degree"] = outcome.chi2_per_degree;
  run["degrees_of_freedom"] = outcome.degrees_of_freedom;
  run["false_edges"] = outcome.false_edges;
}

}  // namespace

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
  lines_ = w.first_line_ + w.log_.size();
  if (std::exchange(structure_, w.structure_number_) != w.structure_number_) {
    messages.push_back(w.form_message_);
    messages.push_back(w.structure_message_);
  }
  // A structure ends the truth before it.
  if (std::exchange(truth_, w.truth_number_) != w.truth_number_ && w.truth_message_)
    messages.push_back(w.truth_message_);
  if (frame_ == 0) messages.insert(messages.end(), w.history_.frames().begin(), w.history_.frames().end());
  if (std::exchange(frame_, w.sequence_) != w.sequence_) messages.push_back(w.frame_message_);
  if (std::exchange(diagnosis_, w.diagnosis_number_) != w.diagnosis_number_ && w.diagnosis_message_)
    messages.push_back(w.diagnosis_message_);
  return messages;
}

const char* Workspace::name_of(DiagnosisAge age) {
  switch (age) {
    case DiagnosisAge::kCurrent:
      return "current";
    case DiagnosisAge::kOtherEstimates:
      return "other estimates";
    default:
      return "other graph";
  }
}

std::string Workspace::Reader::state_json() const {
  const Workspace& w = workspace_;
  Json state = greeting_.empty() ? Json::object() : Json::parse(greeting_);
  state["busy"] = w.is_busy_;
  state["activity"] = w.activity_;
  state["error"] = w.error_.empty() ? Json(nullptr) : Json(w.error_);
  state["opens_no_files"] = w.opener_ ? Json(nullptr) : Json(kOpensNothing);
  const std::string no_truth = w.opener_ ? (w.facts_ ? w.facts_->no_truth : "") : kOpensNothing;
  state["opens_no_truth"] = no_truth.empty() ? Json(nullptr) : Json(no_truth);
  state["diagnosis"] = w.diagnosis_message_ ? Json(name_of(w.diagnosis_age_)) : Json(nullptr);
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
    add_facts(state["run"], w.facts_of_run_);
  } else {
    state["run"] = nullptr;
  }
  const std::size_t first_line = std::max(lines_, w.first_line_);
  state["log"] = {{"first", first_line},
                  {"lines", news_of(w.log_, first_line - w.first_line_, [](const Line& line) {
                     return Json{{"level", line.level}, {"text", line.text}};
                   })}};
  // Names and notes may contain bytes of the file that are not valid UTF-8.
  return state.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace boxplus::viewer
