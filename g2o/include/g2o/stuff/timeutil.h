// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>

namespace g2o {

/// Seconds since the epoch.
inline double get_time() {
  return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
}

/// Seconds of a clock that never goes backwards.
inline double get_monotonic_time() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Adds the seconds of its life to a variable, if there is one.
class ScopeTime {
 public:
  explicit ScopeTime(double* total) : total_(total), begin_(get_monotonic_time()) {}
  ~ScopeTime() {
    if (total_ != nullptr) *total_ += get_monotonic_time() - begin_;
  }
  ScopeTime(const ScopeTime&) = delete;
  ScopeTime& operator=(const ScopeTime&) = delete;

 private:
  double* total_;
  double begin_;
};

}  // namespace g2o
