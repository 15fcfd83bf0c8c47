// SPDX-License-Identifier: BSD-3-Clause
// Functions that read and write vectors, for read() and write() of clients' types.
#pragma once
#ifndef G2O_CORE_IO_HELPER_H
#define G2O_CORE_IO_HELPER_H

// clang-format off: this header comes first, because it sets the alignment of Eigen
#include "g2o/config.h"
// clang-format on

#include <Eigen/Core>
#include <iostream>

namespace g2o {
namespace internal {

/// Reads all values of a vector. Returns false if the stream has fewer values.
template <typename Derived>
bool readVector(std::istream& is, Eigen::DenseBase<Derived>& b) {
  for (Eigen::Index i = 0; i < b.size(); ++i) is >> b(i);
  return !is.fail();
}

/// Writes the values, each followed by a blank.
template <typename Derived>
bool writeVector(std::ostream& os, const Eigen::DenseBase<Derived>& b) {
  for (Eigen::Index i = 0; i < b.size(); ++i) os << b(i) << " ";
  return os.good();
}

}  // namespace internal
}  // namespace g2o

#endif  // G2O_CORE_IO_HELPER_H
