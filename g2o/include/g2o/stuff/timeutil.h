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

/// Seconds since the epoch.
inline double get_time() {
  return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
}

/// Seconds of a clock that never goes backwards.
inline double get_monotonic_time() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// The local date and time of a moment, the numbers alone: "20120131_235959".
G2O_STUFF_API std::string getTimeAsString(std::time_t time);
/// That of this moment.
G2O_STUFF_API std::string getCurrentTimeAsString();

/// Writes how long it lived to std::cerr, behind its title.
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

/// Adds the seconds of its life to a variable, if there is one.
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

/// Runs a command when this line is reached first, and again when `seconds` have passed since it ran.
#define DO_EVERY(seconds, ...)                                      \
  do {                                                              \
    static double doEveryLast = -1;                                 \
    const double doEveryNow = g2o::get_monotonic_time();            \
    if (doEveryLast < 0 || doEveryNow - doEveryLast >= (seconds)) { \
      doEveryLast = doEveryNow;                                     \
      __VA_ARGS__;                                                  \
    }                                                               \
  } while (false)

/// The same by a clock of the caller's, in seconds. A clock that was set back starts anew.
#define DO_EVERY_TS(seconds, currentTime, ...)                               \
  do {                                                                       \
    static double doEveryLast = (currentTime) - (seconds);                   \
    const double doEveryNow = (currentTime);                                 \
    if (doEveryNow - doEveryLast >= (seconds) || doEveryNow < doEveryLast) { \
      doEveryLast = doEveryNow;                                              \
      __VA_ARGS__;                                                           \
    }                                                                        \
  } while (false)

/// Runs code and writes how long it took to std::cerr, behind `text`.
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
/// Writes how long the function took, from here to its end, behind its name.
#define MEASURE_FUNCTION_TIME const g2o::ScopeTime measuredFunctionTime(G2O_FUNCTION_NAME)

#endif  // G2O_TIMEUTIL_H
