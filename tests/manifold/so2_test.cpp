// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/manifold/so2.h"

#include <gtest/gtest.h>

#include "boxplus/testing/check_manifold.h"
#include "manifold/samples.h"

namespace boxplus {
namespace {

TEST(SO2, ObeysTheManifoldLaws) {
  Samples s;
  auto rotations = Samples::many(10, [&] { return SO2(s.uniform(-kPi, kPi)); });
  rotations.push_back(SO2(kPi));
  const ManifoldCheck check = check_manifold(rotations);
  EXPECT_TRUE(check) << check.message;
}

TEST(SO2, RotatesPoints) {
  const SO2 quarter(kPi / 2);
  EXPECT_LT((quarter * Vector<double, 2>(1, 0) - Vector<double, 2>(0, 1)).norm(), 1e-15);
  EXPECT_EQ((quarter * quarter).angle(), kPi);
  EXPECT_EQ((quarter.inverse() * quarter).angle(), 0);
  EXPECT_LT((quarter.rotation() * Vector<double, 2>(1, 0) - Vector<double, 2>(0, 1)).norm(), 1e-15);
}

}  // namespace
}  // namespace boxplus
