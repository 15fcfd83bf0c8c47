// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/stuff/logger.h"

#include <atomic>
#include <utility>

namespace g2o {
namespace logging {
namespace {

Sink& sink() {
  static Sink instance;
  return instance;
}

std::atomic<Level>& level_threshold() {
  static std::atomic<Level> instance{Level::kWarn};
  return instance;
}

}  // namespace

void setSink(Sink new_sink) {
  sink() = std::move(new_sink);
}

void setLevel(Level level) {
  level_threshold() = level;
}

bool wanted(Level level) {
  return level >= level_threshold() && level != Level::kOff && sink();
}

void log(Level level, const std::string& text) {
  if (wanted(level)) sink()(level, text);
}

}  // namespace logging
}  // namespace g2o
