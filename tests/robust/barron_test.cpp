// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/robust/barron.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "boxplus/base/error.h"
#include "boxplus/robust/huber.h"
#include "boxplus/robust/redescending.h"
#include "boxplus/testing/check_kernel.h"

namespace boxplus {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

void expect_near(const RobustKernel::Rho& a, const RobustKernel::Rho& b, double tolerance) {
  EXPECT_NEAR(a.value, b.value, tolerance);
  EXPECT_NEAR(a.first, b.first, tolerance);
  EXPECT_NEAR(a.second, b.second, tolerance);
}

TEST(Barron, ObeysTheContractOfRobustKernelsForEveryShape) {
  for (const double shape : {-kInfinity, -100.0, -2.0, -1e-9, 0.0, 1e-9, 1.0, 1.5, 2 - 1e-9, 2.0, 2.5, 4.0}) {
    KernelCheckOptions options;
    options.largest = shape > 2 ? 10 : 1e4;
    const KernelCheck check = check_kernel(Barron(shape, 0.7), options);
    EXPECT_TRUE(check) << check.message << ", shape " << shape;
  }
}

TEST(Barron, EqualsAClassicKernelForSomeShapes) {
  const double c = 1.5;
  for (const double e2 : {0.0, 0.1, 1.0, 20.0}) {
    expect_near(Barron(2, c)(e2), {e2, 1, 0}, 0);
    expect_near(Barron(1, c)(e2), PseudoHuber(c)(e2), 1e-13);
    expect_near(Barron(0, c)(e2), Cauchy(std::sqrt(2) * c)(e2), 1e-13);
    expect_near(Barron(-2, c)(e2), GemanMcClure(4 * c * c)(e2), 1e-13);
    expect_near(Barron(-kInfinity, c)(e2), Welsch(std::sqrt(2) * c)(e2), 1e-13);
  }
}

TEST(Barron, IsContinuousInItsShape) {
  for (const double e2 : {0.1, 1.0, 20.0}) {
    expect_near(Barron(1e-10, 1)(e2), Barron(0, 1)(e2), 1e-7);
    expect_near(Barron(-1e-10, 1)(e2), Barron(0, 1)(e2), 1e-7);
    expect_near(Barron(2 - 1e-10, 1)(e2), Barron(2, 1)(e2), 1e-7);
    expect_near(Barron(2 + 1e-10, 1)(e2), Barron(2, 1)(e2), 1e-7);
    expect_near(Barron(-1e10, 1)(e2), Barron(-kInfinity, 1)(e2), 1e-7);
  }
}

TEST(Barron, RefusesAShapeThatIsNotANumber) {
  EXPECT_THROW(Barron(std::nan(""), 1), InvalidArgument);
}

}  // namespace
}  // namespace boxplus
