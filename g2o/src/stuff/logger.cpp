// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/stuff/logger.h"

#include <atomic>
#include <iostream>
#include <utility>

namespace g2o {
namespace logging {
namespace {

struct Destination {
  Sink sink;
  bool is_set = false;  // true once the program has set a sink
};

Destination& destination() {
  static Destination instance;
  return instance;
}

std::atomic<Level>& level_threshold() {
  static std::atomic<Level> instance{Level::kWarn};
  return instance;
}

}  // namespace

void setSink(Sink new_sink) {
  destination() = {std::move(new_sink), true};
}

void setLevel(Level level) {
  level_threshold() = level;
}

bool wanted(Level level) {
  if (level < level_threshold() || level == Level::kOff) return false;
  return destination().is_set ? static_cast<bool>(destination().sink) : level >= Level::kError;
}

void log(Level level, const std::string& text) {
  if (!wanted(level)) return;
  if (destination().is_set) {
    destination().sink(level, text);
  } else {
    std::cerr << "g2o: " + text + '\n';
  }
}

}  // namespace logging
}  // namespace g2o
