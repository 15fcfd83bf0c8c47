// SPDX-License-Identifier: BSD-3-Clause
// Measures the time of named parts of a program if the environment variable G2O_ENABLE_TICTOC is set.
#pragma once
#ifndef G2O_TICTOC_H
#define G2O_TICTOC_H

#include <string>

#include "g2o/stuff/g2o_stuff_api.h"

namespace g2o {

/// The first call with a name starts a clock. The second call stops the clock and returns the seconds between
/// the two calls. The third call starts the clock again, and so on. Returns −1 if the call starts a clock or
/// if the environment variable is not set.
G2O_STUFF_API double tictoc(const char* algorithmPart);

/// Returns all results of tictoc(), one line per name: the count, and the total, shortest, mean and longest
/// time.
G2O_STUFF_API std::string tictocReport();

/// Measures the time that a scope takes.
class ScopeTicToc {
 public:
  explicit ScopeTicToc(const std::string& s) : _s(s) { tictoc(_s.c_str()); }
  ~ScopeTicToc() { tictoc(_s.c_str()); }
  ScopeTicToc(const ScopeTicToc&) = delete;
  ScopeTicToc& operator=(const ScopeTicToc&) = delete;

 protected:
  std::string _s;
};
using ScopedTictoc = ScopeTicToc;

}  // namespace g2o

#endif  // G2O_TICTOC_H
