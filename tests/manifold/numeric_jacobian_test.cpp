// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/manifold/numeric_jacobian.h"

#include <gtest/gtest.h>

#include <cmath>

#include "boxplus/manifold/rn.h"
#include "boxplus/manifold/se2.h"

namespace boxplus {
namespace {

TEST(NumericJacobian, DifferentiatesWithRespectToTheTangentVector) {
  const SE2 x(1, 2, 0.5);
  Matrix<double, 2, 3> jacobian;
  const double error = detail::numeric_jacobian([](const SE2& p) { return p.translation(); }, x, jacobian);
  EXPECT_LT(error, 1e-10);
  Matrix<double, 2, 3> expected;
  expected << std::cos(0.5), -std::sin(0.5), 0, std::sin(0.5), std::cos(0.5), 0;
  EXPECT_LT((jacobian - expected).norm(), 1e-12);
}

TEST(NumericJacobian, AcceptsFunctionsThatReturnAScalar) {
  Matrix<double, 1, 1> jacobian;
  detail::numeric_jacobian([](double x) { return x * x; }, 3.0, jacobian);
  EXPECT_NEAR(jacobian(0, 0), 6, 1e-12);
}

TEST(NumericJacobian, AcceptsVectorsOfRunTimeSize) {
  const Vector<double, kDynamic> x = Vector<double, kDynamic>::Constant(4, 2.0);
  Matrix<double, kDynamic, kDynamic> jacobian(4, 4);
  detail::numeric_jacobian([](const auto& v) { return v.cwiseProduct(v).eval(); }, x, jacobian);
  EXPECT_LT((jacobian - Eigen::MatrixXd::Identity(4, 4) * 4).norm(), 1e-11);
}

}  // namespace
}  // namespace boxplus
