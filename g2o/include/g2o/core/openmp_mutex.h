// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_OPENMP_MUTEX
#define G2O_OPENMP_MUTEX

#include <iostream>

namespace g2o {

/// Edges are linearised by one thread unless their type opts in, and those that do add to memory of their
/// own: there is nothing to lock.
class OpenMPMutex {
 public:
  void lock() {}
  void unlock() {}
};

class ScopedOpenMPMutex {
 public:
  explicit ScopedOpenMPMutex(OpenMPMutex*) {}
  ScopedOpenMPMutex(const ScopedOpenMPMutex&) = delete;
  ScopedOpenMPMutex& operator=(const ScopedOpenMPMutex&) = delete;
};

}  // namespace g2o

#endif  // G2O_OPENMP_MUTEX
