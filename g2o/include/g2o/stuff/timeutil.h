// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_TIMEUTIL_H
#define G2O_TIMEUTIL_H

#include <chrono>
#include <ctime>
#include <iostream>
#include <string>
#include <utility>

#include "g2o/stuff/g2o_stuff_api.h"

namespace g2o {

/// Returns the seconds since the epoch.
inline double get_time() {
  return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
}

/// Returns the seconds of a clock that never runs backwards.
inline double get_monotonic_time() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Returns the local date and time as digits, for example "20120131_235959".
G2O_STUFF_API std::string getTimeAsString(std::time_t time);
/// Returns the current local date and time in the same format.
G2O_STUFF_API std::string getCurrentTimeAsString();

/// A timer for a scope. The destructor writes the title and the lifetime of the object to std::cerr.
class G2O_STUFF_API ScopeTime {
 public:
  explicit ScopeTime(std::string title) : _title(std::move(title)), _startTime(get_monotonic_time()) {}
  ~ScopeTime();
  ScopeTime(const ScopeTime&) = delete;
  ScopeTime& operator=(const ScopeTime&) = delete;

 private:
  std::string _title;
  double _startTime;
};

namespace internal {

/// A timer for a scope. The destructor adds the lifetime (seconds) of the object to `*total`, unless `total`
/// is nullptr.
class AddedTime {
 public:
  explicit AddedTime(double* total) : total_(total), begin_(get_monotonic_time()) {}
  ~AddedTime() {
    if (total_ != nullptr) *total_ += get_monotonic_time() - begin_;
  }
  AddedTime(const AddedTime&) = delete;
  AddedTime& operator=(const AddedTime&) = delete;

 private:
  double* total_;
  double begin_;
};

}  // namespace internal
}  // namespace g2o

/// Runs a statement when this line is reached for the first time. Later, runs it only if at least `seconds`
/// seconds have passed since its last run.
#define DO_EVERY(seconds, ...)                                      \
  do {                                                              \
    static double doEveryLast = -1;                                 \
    const double doEveryNow = g2o::get_monotonic_time();            \
    if (doEveryLast < 0 || doEveryNow - doEveryLast >= (seconds)) { \
      doEveryLast = doEveryNow;                                     \
      __VA_ARGS__;                                                  \
    }                                                               \
  } while (false)

/// Does the same as DO_EVERY, but reads the time (seconds) from `currentTime`. Also runs the statement if
/// `currentTime` has decreased.
#define DO_EVERY_TS(seconds, currentTime, ...)                               \
  do {                                                                       \
    static double doEveryLast = (currentTime) - (seconds);                   \
    const double doEveryNow = (currentTime);                                 \
    if (doEveryNow - doEveryLast >= (seconds) || doEveryNow < doEveryLast) { \
      doEveryLast = doEveryNow;                                              \
      __VA_ARGS__;                                                           \
    }                                                                        \
  } while (false)

/// Runs code and writes `text` and the elapsed time to std::cerr.
#define MEASURE_TIME(text, ...)                \
  do {                                         \
    const g2o::ScopeTime measuredTime((text)); \
    __VA_ARGS__;                               \
  } while (false)

#if defined(__GNUC__)
#define G2O_FUNCTION_NAME __PRETTY_FUNCTION__
#else
#define G2O_FUNCTION_NAME __func__
#endif
/// Writes the name of the function, and the time between this line and the end of the function, to std::cerr.
#define MEASURE_FUNCTION_TIME const g2o::ScopeTime measuredFunctionTime(G2O_FUNCTION_NAME)

#endif  // G2O_TIMEUTIL_H
