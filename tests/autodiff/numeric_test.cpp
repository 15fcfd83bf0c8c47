// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/autodiff/numeric.h"

#include <gtest/gtest.h>

#include <cmath>

namespace boxplus {
namespace {

template <class F>
double derivative_of(const F& f, const detail::NumericOptions& options = {}) {
  double derivative = 0;
  detail::NumericDerivative differentiate(options);
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

TEST(NumericDerivative, RecoversIfLargeStepsLeaveTheDomain) {
  EXPECT_NEAR(derivative_of([](double h) { return std::log(0.01 + h); }), 100, 100 * 1e-9);
}

TEST(NumericDerivative, EstimatesItsError) {
  double derivative = 0;
  detail::NumericDerivative differentiate;
  const double smooth = differentiate([](double h, double* out) { *out = std::exp(h); }, 1, &derivative);
  const double kinked = differentiate([](double h, double* out) { *out = std::cbrt(h); }, 1, &derivative);
  EXPECT_LT(smooth, 1e-10);
  EXPECT_GT(kinked, 1e-6);
}

TEST(NumericDerivative, ReportsAFunctionThatIsNowhereFinite) {
  double derivative = 0;
  detail::NumericDerivative differentiate;
  const double error = differentiate([](double, double* out) { *out = std::nan(""); }, 1, &derivative);
  EXPECT_TRUE(std::isinf(error));
  EXPECT_TRUE(std::isnan(derivative));
}

}  // namespace
}  // namespace boxplus
