// SPDX-License-Identifier: BSD-3-Clause
// Memory that grows on request and is aligned as Eigen's.
#pragma once
#ifndef G2O_DYNAMIC_ALIGNED_BUFFER_HPP
#define G2O_DYNAMIC_ALIGNED_BUFFER_HPP

#include <cstddef>
#include <vector>

#include "g2o/core/eigen_types.h"

namespace g2o {

/// A buffer of Type, which is a type of numbers.
template <typename Type>
struct dynamic_aligned_buffer {
  explicit dynamic_aligned_buffer(std::size_t size) : memory_(size) {}

  /// Room for n elements, valid until a larger request. What they hold is not specified.
  Type* request(std::size_t n) {
    if (n > memory_.size()) memory_.resize(n);
    return memory_.data();
  }

 private:
  std::vector<Type, Eigen::aligned_allocator<Type>> memory_;
};

}  // namespace g2o

#endif  // G2O_DYNAMIC_ALIGNED_BUFFER_HPP
