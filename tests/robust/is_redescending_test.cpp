// SPDX-License-Identifier: BSD-3-Clause
#include "robust/is_redescending.h"

#include <gtest/gtest.h>

#include <limits>

#include "boxplus/robust/barron.h"
#include "boxplus/robust/huber.h"
#include "boxplus/robust/redescending.h"

namespace boxplus {
namespace {

TEST(IsRedescending, IsTrueForTheKernelsWhoseInfluenceFallsToZero) {
  for (const double width : {1e-3, 1.0, 2.8, 1e4}) {
    EXPECT_TRUE(is_redescending(Cauchy(width)));
    EXPECT_TRUE(is_redescending(GemanMcClure(width)));
    EXPECT_TRUE(is_redescending(Welsch(width)));
    EXPECT_TRUE(is_redescending(Tukey(width)));
    EXPECT_TRUE(is_redescending(Saturated(width)));
    EXPECT_TRUE(is_redescending(DCS(width)));
    EXPECT_FALSE(is_redescending(Huber(width)));
    EXPECT_FALSE(is_redescending(PseudoHuber(width)));
    EXPECT_FALSE(is_redescending(Fair(width)));
  }
}

TEST(IsRedescending, DependsOnTheShapeOfBarronsKernel) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const double shape : {-kInfinity, -2.0, 0.0, 0.5}) EXPECT_TRUE(is_redescending(Barron(shape, 2)));
  for (const double shape : {1.0, 1.5, 2.0, 3.0}) EXPECT_FALSE(is_redescending(Barron(shape, 2)));
}

}  // namespace
}  // namespace boxplus
