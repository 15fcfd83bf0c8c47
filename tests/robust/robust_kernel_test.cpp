// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "boxplus/robust/huber.h"
#include "boxplus/robust/kernel_table.h"
#include "boxplus/robust/make_robust_kernel.h"
#include "boxplus/robust/redescending.h"
#include "boxplus/testing/check_kernel.h"

namespace boxplus {
namespace {

/// The argument of make_robust_kernel() for a kernel of the table. Fails if the kernel has a parameter and
/// there is no example of it here.
std::string name_of(const detail::KernelEntry& kernel) {
  if (!kernel.takes_parameter()) return std::string(kernel.name);
  static const std::map<std::string_view, std::string> examples = {{"Barron:ALPHA", "Barron:-1.5"}};
  const auto example = examples.find(kernel.name);
  if (example != examples.end()) return example->second;
  ADD_FAILURE() << "add an example of " << kernel.name << " to examples";
  return "Huber";
}

TEST(RobustKernels, ObeyTheContractAtEveryWidth) {
  for (const detail::KernelEntry& kernel : detail::kernel_table()) {
    const std::string name = name_of(kernel);
    for (const double delta : {0.01, 1.0, 2.5, 300.0}) {
      const KernelCheck check = check_kernel(*make_robust_kernel(name, delta));
      EXPECT_TRUE(check) << check.message << ", delta " << delta;
    }
  }
}

TEST(RobustKernels, StayFiniteForHugeErrors) {
  std::vector<std::string> names = {"Barron:1", "Barron:-inf"};
  for (const detail::KernelEntry& kernel : detail::kernel_table()) names.push_back(name_of(kernel));
  for (const std::string& name : names) {
    for (const double delta : {detail::kSmallestKernelWidth, 1.0, detail::kLargestKernelWidth}) {
      for (const double e2 : {0.0, 1e-300, 1.0, 1e100, 1e300, std::numeric_limits<double>::max()}) {
        const RobustKernel::Rho rho = (*make_robust_kernel(name, delta))(e2);
        EXPECT_TRUE(std::isfinite(rho.value) && std::isfinite(rho.first) && std::isfinite(rho.second))
            << name << " of width " << delta << " at " << e2;
      }
    }
  }
}

void expect_rho(const RobustKernel& kernel, double e2, double value, double first) {
  SCOPED_TRACE(testing::Message() << kernel.name() << " at " << e2);
  EXPECT_NEAR(kernel(e2).value, value, 1e-14 * std::abs(value));
  EXPECT_NEAR(kernel(e2).first, first, 1e-14);
}

TEST(RobustKernels, HaveTheValuesOfTheirFormulas) {
  const double d = 2, near = 1, far = 9;  // squared errors
  expect_rho(Huber(d), near, 1, 1);
  expect_rho(Huber(d), far, 2 * d * 3 - d * d, d / 3);
  expect_rho(PseudoHuber(d), far, 8 * (std::sqrt(1 + 9.0 / 4) - 1), 1 / std::sqrt(1 + 9.0 / 4));
  expect_rho(Cauchy(d), far, 4 * std::log(1 + 9.0 / 4), 1 / (1 + 9.0 / 4));
  expect_rho(GemanMcClure(d), far, 2 * 9.0 / 11, 4.0 / 121);
  expect_rho(Welsch(d), far, 4 * (1 - std::exp(-9.0 / 4)), std::exp(-9.0 / 4));
  expect_rho(Fair(d), far, 8 * (1.5 - std::log(2.5)), 1 / 2.5);
  expect_rho(Tukey(d), near, 4.0 / 3 * (1 - 27.0 / 64), 9.0 / 16);
  expect_rho(Tukey(d), far, 4.0 / 3, 0);
  expect_rho(Saturated(d), near, 1, 1);
  expect_rho(Saturated(d), far, 4, 0);
  expect_rho(DCS(d), near, 1, 1);
  expect_rho(DCS(d), far, 6 - 16.0 / 11, 16.0 / 121);
}

TEST(RobustKernels, DynamicCovarianceScalingHasThePublishedWeight) {
  for (const double phi : {0.5, 1.0, 5.0}) {
    for (const double e2 : {0.1, 0.9, 5.0, 100.0, 1e6}) {
      const double s = std::min(1.0, 2 * phi / (phi + e2));
      EXPECT_NEAR(DCS(phi)(e2).first, s * s, 1e-15) << phi << " " << e2;
    }
  }
}

TEST(RobustKernels, FairKeepsItsSecondDerivativeFiniteAtZero) {
  EXPECT_TRUE(std::isfinite(Fair(1)(0).second));
  EXPECT_EQ(Fair(1)(0).second, Fair(1)(1e-13).second);
}

TEST(RobustKernels, LoseNoDigitsForTinyErrors) {
  const double e2 = 1e-20;
  for (const char* name :
       {"PseudoHuber", "Cauchy", "GemanMcClure", "Welsch", "Tukey", "Fair", "Barron:0.5"}) {
    EXPECT_NEAR((*make_robust_kernel(name, 1.0))(e2).value / e2, 1, 1e-9) << name;
  }
}

TEST(RobustKernels, AreCopiedByClone) {
  const std::unique_ptr<RobustKernel> copy = Huber(3).clone();
  EXPECT_EQ(copy->name(), "Huber");
  EXPECT_EQ(copy->delta(), 3);
  EXPECT_EQ((*copy)(100).first, 0.3);
}

}  // namespace
}  // namespace boxplus
