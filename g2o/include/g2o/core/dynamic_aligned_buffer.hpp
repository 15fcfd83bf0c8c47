// SPDX-License-Identifier: BSD-3-Clause
// Memory that grows on request and is aligned for Eigen.
#pragma once
#ifndef G2O_DYNAMIC_ALIGNED_BUFFER_HPP
#define G2O_DYNAMIC_ALIGNED_BUFFER_HPP

#include <cstddef>
#include <vector>

#include "g2o/core/eigen_types.h"

namespace g2o {

/// A buffer of scalars.
template <typename Type>
struct dynamic_aligned_buffer {
  explicit dynamic_aligned_buffer(std::size_t size) : memory_(size) {}

  /// Returns memory for n elements. The memory stays valid until a call with a larger n. Its contents are
  /// unspecified.
  Type* request(std::size_t n) {
    if (n > memory_.size()) memory_.resize(n);
    return memory_.data();
  }

 private:
  std::vector<Type, Eigen::aligned_allocator<Type>> memory_;
};

}  // namespace g2o

#endif  // G2O_DYNAMIC_ALIGNED_BUFFER_HPP
