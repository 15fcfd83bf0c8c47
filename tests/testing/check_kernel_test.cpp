// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/testing/check_kernel.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>

namespace boxplus {
namespace {

/// A custom kernel with a wrong second derivative.
class Broken final : public RobustKernel {
 public:
  Rho operator()(double e2) const override { return {std::log1p(e2), 1 / (1 + e2), 1 / (1 + e2)}; }
  std::string_view name() const override { return "Broken"; }
  double delta() const override { return 1; }
  std::unique_ptr<RobustKernel> clone() const override { return std::make_unique<Broken>(*this); }
};

TEST(CheckKernel, NamesTheViolatedLaw) {
  const KernelCheck check = check_kernel(Broken());
  EXPECT_FALSE(check);
  EXPECT_NE(check.message.find("Broken: ρ″ is the derivative of ρ′"), std::string::npos) << check.message;
}

/// ρ = e² exp(−e²), which decreases for e² > 1.
class Falling final : public RobustKernel {
 public:
  Rho operator()(double e2) const override {
    const double f = std::exp(-e2);
    return {e2 * f, (1 - e2) * f, (e2 - 2) * f};
  }
  std::string_view name() const override { return "Falling"; }
  double delta() const override { return 1; }
  std::unique_ptr<RobustKernel> clone() const override { return std::make_unique<Falling>(*this); }
};

TEST(CheckKernel, RefusesAKernelThatDecreases) {
  const KernelCheck check = check_kernel(Falling());
  EXPECT_FALSE(check);
  EXPECT_NE(check.message.find("ρ′ ≥ 0"), std::string::npos) << check.message;
}

}  // namespace
}  // namespace boxplus
