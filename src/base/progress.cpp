// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/base/progress.h"

#include <utility>

namespace boxplus {
namespace {

thread_local const ProgressWatch* newest_watch = nullptr;

}  // namespace

ProgressWatch::ProgressWatch(Function function)
    : function_(std::move(function)), outer_(std::exchange(newest_watch, this)) {}

ProgressWatch::~ProgressWatch() {
  newest_watch = outer_;
}

namespace detail {

void note_progress(double share, std::string_view stage) {
  if (newest_watch != nullptr) newest_watch->function()(stage, share);
}

bool is_watched() {
  return newest_watch != nullptr;
}

}  // namespace detail

}  // namespace boxplus
