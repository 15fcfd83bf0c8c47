// SPDX-License-Identifier: BSD-3-Clause
// Times of named parts of a program, where the environment variable G2O_ENABLE_TICTOC is set.
#pragma once
#ifndef G2O_TICTOC_H
#define G2O_TICTOC_H

#include <string>

#include "g2o/stuff/g2o_stuff_api.h"

namespace g2o {

/// The first call with a name starts its clock, the second one stops it and returns the seconds between the
/// two; and so on. −1 from a call that starts, and where the variable is not set.
G2O_STUFF_API double tictoc(const char* algorithmPart);

/// What tictoc() has measured so far: name, number, total, shortest, mean and longest time, a line each.
G2O_STUFF_API std::string tictocReport();

/// Measures the time of a scope.
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
