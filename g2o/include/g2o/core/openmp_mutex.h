// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_OPENMP_MUTEX
#define G2O_OPENMP_MUTEX

#include <iostream>

namespace g2o {

/// Does nothing, because no lock is necessary. Edges are linearized on one thread unless their type is
/// declared thread-safe, and edges on different threads never write to the same block.
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
