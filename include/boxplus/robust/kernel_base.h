// SPDX-License-Identifier: BSD-3-Clause
// The common base of kernels with one width.
#pragma once

#include "boxplus/robust/robust_kernel.h"

namespace boxplus {

namespace detail {
/// The range of widths. Outside it, the square of a width or its reciprocal may overflow.
constexpr double kSmallestKernelWidth = 1e-100, kLargestKernelWidth = 1e100;

/// Returns `delta` if it is in this range; throws InvalidArgument otherwise.
double checked_kernel_width(double delta, std::string_view kernel);
}  // namespace detail

/// Base of a kernel K with a width: K provides kName and operator().
template <class K>
class KernelBase : public RobustKernel {
 public:
  explicit KernelBase(double delta) : delta_(detail::checked_kernel_width(delta, K::kName)) {}
  std::string_view name() const final { return K::kName; }
  double delta() const final { return delta_; }
  std::unique_ptr<RobustKernel> clone() const final {
    return std::make_unique<K>(static_cast<const K&>(*this));
  }

 protected:
  double delta_;
};

}  // namespace boxplus
