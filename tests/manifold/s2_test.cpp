// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/manifold/s2.h"

#include <gtest/gtest.h>

#include "boxplus/testing/check_manifold.h"
#include "manifold/samples.h"

namespace boxplus {
namespace {

TEST(S2, ObeysTheManifoldLaws) {
  Samples s;
  auto directions = Samples::many(12, [&] { return S2(s.vector<3>(1)); });
  for (int axis = 0; axis < 3; ++axis)
    directions.push_back(S2(Vector<double, 3>(Vector<double, 3>::Unit(axis))));
  for (const double step : {1.0, 0.1, 0.005, 1e-4}) {
    ManifoldCheckOptions options;
    options.step = step;
    const ManifoldCheck check = check_manifold(directions, options);
    EXPECT_TRUE(check) << check.message << ", step " << step;
  }
}

TEST(S2, HasAnOrthonormalTangentBasisEverywhere) {
  Samples s;
  auto directions = Samples::many(100, [&] { return S2(s.vector<3>(1)); });
  directions.push_back(S2(Vector<double, 3>(0, 0, -1)));
  directions.push_back(S2(Vector<double, 3>(1, 0, 0)));
  for (const S2& d : directions) {
    Matrix<double, 3, 3> frame;
    frame << d.tangent_basis(), d.vector();
    EXPECT_LT((frame.transpose() * frame - Matrix<double, 3, 3>::Identity()).norm(), 1e-15);
  }
}

TEST(S2, WalksAlongGreatCircles) {
  const double quarter[2] = {kPi / 2, 0};
  const S2 x = Manifold<S2>::oplus(S2(), quarter);
  EXPECT_NEAR(x.vector()[2], 0, 1e-15);
  double delta[2];
  Manifold<S2>::ominus(x, S2(), delta);
  EXPECT_NEAR(delta[0], kPi / 2, 1e-15);
}

TEST(S2, HasATangentVectorToTheOppositeDirection) {
  const S2 up, down(Vector<double, 3>(0, 0, -1));
  double delta[2];
  Manifold<S2>::ominus(down, up, delta);
  EXPECT_LT((Manifold<S2>::oplus(up, delta).vector() - down.vector()).norm(), 1e-15);
}

TEST(S2, NormalizesItsArgument) {
  EXPECT_LT((S2(Vector<double, 3>(0, 3, 4)).vector() - Vector<double, 3>(0, 0.6, 0.8)).norm(), 1e-15);
}

}  // namespace
}  // namespace boxplus
