// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "boxplus/manifold/numeric_jacobian.h"
#include "boxplus/manifold/rn.h"
#include "boxplus/manifold/se2.h"

namespace boxplus {
namespace {

template <class F>
double derivative_of(const F& f, const NumericOptions& options = {}) {
  double derivative = 0;
  NumericDerivative differentiate(options);
  differentiate([&](double h, double* out) { *out = f(h); }, 1, &derivative);
  return derivative;
}

TEST(NumericDerivative, IsAccurateOnSmoothFunctions) {
  EXPECT_NEAR(derivative_of([](double h) { return std::exp(h); }), 1, 1e-11);
  EXPECT_NEAR(derivative_of([](double h) { return std::sin(1 + h); }), std::cos(1), 1e-11);
  EXPECT_NEAR(derivative_of([](double h) { return 1 / (2 + h); }), -0.25, 1e-11);
  EXPECT_NEAR(derivative_of([](double h) { return std::cos(20 * h + 1); }), -20 * std::sin(1), 1e-8);
}

TEST(NumericDerivative, AdaptsItsStepToTheScaleOfTheFunction) {
  EXPECT_NEAR(derivative_of([](double h) { return std::tanh(300 * h); }), 300, 300 * 1e-9);
  EXPECT_NEAR(derivative_of([](double h) { return 1e6 + 1e-3 * h; }), 1e-3, 1e-8);
}

TEST(NumericDerivative, RecoversWhereLargeStepsLeaveTheDomain) {
  EXPECT_NEAR(derivative_of([](double h) { return std::log(0.01 + h); }), 100, 100 * 1e-9);
}

TEST(NumericDerivative, EstimatesItsError) {
  double derivative = 0;
  NumericDerivative differentiate;
  const double smooth = differentiate([](double h, double* out) { *out = std::exp(h); }, 1, &derivative);
  const double kinked = differentiate([](double h, double* out) { *out = std::cbrt(h); }, 1, &derivative);
  EXPECT_LT(smooth, 1e-10);
  EXPECT_GT(kinked, 1e-6);
}

TEST(NumericDerivative, ReportsAFunctionThatIsNowhereFinite) {
  double derivative = 0;
  NumericDerivative differentiate;
  const double error = differentiate([](double, double* out) { *out = std::nan(""); }, 1, &derivative);
  EXPECT_TRUE(std::isinf(error));
  EXPECT_TRUE(std::isnan(derivative));
}

TEST(NumericJacobian, DifferentiatesThroughBoxplus) {
  const SE2 x(1, 2, 0.5);
  Matrix<double, 2, 3> jacobian;
  const double error = numeric_jacobian([](const SE2& p) { return p.translation(); }, x, jacobian);
  EXPECT_LT(error, 1e-10);
  Matrix<double, 2, 3> expected;
  expected << std::cos(0.5), -std::sin(0.5), 0, std::sin(0.5), std::cos(0.5), 0;
  EXPECT_LT((jacobian - expected).norm(), 1e-12);
}

TEST(NumericJacobian, TakesFunctionsThatReturnANumber) {
  Matrix<double, 1, 1> jacobian;
  numeric_jacobian([](double x) { return x * x; }, 3.0, jacobian);
  EXPECT_NEAR(jacobian(0, 0), 6, 1e-12);
}

TEST(NumericJacobian, TakesRunTimeSizes) {
  const Vector<double, kDynamic> x = Vector<double, kDynamic>::Constant(4, 2.0);
  Matrix<double, kDynamic, kDynamic> jacobian(4, 4);
  numeric_jacobian([](const auto& v) { return v.cwiseProduct(v).eval(); }, x, jacobian);
  EXPECT_LT((jacobian - Eigen::MatrixXd::Identity(4, 4) * 4).norm(), 1e-11);
}

}  // namespace
}  // namespace boxplus
