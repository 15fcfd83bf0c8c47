// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace g2o {
namespace internal {

/// The places of the blocks of H, and of the parts of the gradient, in memory.
class HessianPlaces {
 public:
  HessianPlaces() = default;
  HessianPlaces(const HessianPlaces&) = delete;
  HessianPlaces& operator=(const HessianPlaces&) = delete;
  virtual ~HessianPlaces() = default;
  /// The offset of the block of two vertices, given by Hessian index, among the values of H.
  struct Block {
    std::uint32_t offset;
    bool transposed;  ///< whether the block (j, i) is stored
  };
  virtual Block block(int i, int j) const = 0;
  /// The offset of a vertex in the gradient.
  virtual std::uint32_t gradient(int i) const = 0;
  /// The numbers of values of H, and of the gradient. Sums of parts are stored behind them.
  virtual std::uint32_t values() const = 0;
  virtual std::uint32_t scalars() const = 0;
};

}  // namespace internal
}  // namespace g2o
