// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <limits>

#include "boxplus/autodiff/dual.h"
#include "boxplus/autodiff/numeric.h"

namespace boxplus {
namespace {

using D1 = detail::Dual<double, 1>;
using D2 = detail::Dual<double, 2>;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Expects that the first derivative from a dual number, and the second derivative from a nested dual number,
/// agree with numeric derivatives of f at each point.
template <class F>
void expect_derivatives(const char* name, const F& f, std::initializer_list<double> points) {
  detail::NumericOptions options;
  options.initial_step = 0.01;
  detail::NumericDerivative differentiate(options);
  for (const double x : points) {
    SCOPED_TRACE(testing::Message() << name << " at " << x);
    const D1 dual = f(D1::variable(x, 0));
    const detail::Dual<D1, 1> nested = f(detail::Dual<D1, 1>(D1::variable(x, 0), {D1(1)}));
    double first = 0, second = 0;
    differentiate([&](double h, double* out) { *out = f(x + h); }, 1, &first);
    differentiate([&](double h, double* out) { *out = f(D1::variable(x + h, 0)).derivative[0]; }, 1, &second);
    EXPECT_EQ(dual.value, f(x));
    EXPECT_NEAR(dual.derivative[0], first, 1e-9 * (1 + std::abs(first)));
    EXPECT_EQ(nested.value.value, dual.value);
    EXPECT_EQ(nested.derivative[0].value, dual.derivative[0]);
    EXPECT_NEAR(nested.derivative[0].derivative[0], second, 1e-9 * (1 + std::abs(second)));
  }
}

TEST(DualFunctions, OfOneArgumentMatchNumericDerivatives) {
  expect_derivatives("sqrt", [](auto x) { return sqrt(x); }, {0.1, 1, 30});
  expect_derivatives("cbrt", [](auto x) { return cbrt(x); }, {-8, 0.1, 1, 30});
  expect_derivatives("exp", [](auto x) { return exp(x); }, {-3, 0, 2});
  expect_derivatives("exp2", [](auto x) { return exp2(x); }, {-3, 0, 2});
  expect_derivatives("expm1", [](auto x) { return expm1(x); }, {-3, 0, 2});
  expect_derivatives("log", [](auto x) { return log(x); }, {0.1, 1, 30});
  expect_derivatives("log2", [](auto x) { return log2(x); }, {0.1, 1, 30});
  expect_derivatives("log10", [](auto x) { return log10(x); }, {0.1, 1, 30});
  expect_derivatives("log1p", [](auto x) { return log1p(x); }, {-0.5, 0, 3});
  expect_derivatives("abs", [](auto x) { return abs(x); }, {-2, 3});
  expect_derivatives("fabs", [](auto x) { return fabs(x); }, {-2, 3});
  expect_derivatives("floor", [](auto x) { return floor(x); }, {-2.5, 3.5});
  expect_derivatives("ceil", [](auto x) { return ceil(x); }, {-2.5, 3.5});
  expect_derivatives("trunc", [](auto x) { return trunc(x); }, {-2.5, 3.5});
  expect_derivatives("round", [](auto x) { return round(x); }, {-2.2, 3.2});
}

TEST(DualFunctions, TrigonometricAndHyperbolicFunctionsMatchNumericDerivatives) {
  expect_derivatives("sin", [](auto x) { return sin(x); }, {-3, 0, 1.5707963267948966, 2});
  expect_derivatives("cos", [](auto x) { return cos(x); }, {-3, 0, 1.5707963267948966, 2});
  expect_derivatives("tan", [](auto x) { return tan(x); }, {-1, 0, 1});
  expect_derivatives("asin", [](auto x) { return asin(x); }, {-0.9, 0, 0.5});
  expect_derivatives("acos", [](auto x) { return acos(x); }, {-0.9, 0, 0.5});
  expect_derivatives("atan", [](auto x) { return atan(x); }, {-5, 0, 0.5});
  expect_derivatives("sinh", [](auto x) { return sinh(x); }, {-2, 0, 0.5});
  expect_derivatives("cosh", [](auto x) { return cosh(x); }, {-2, 0, 0.5});
  expect_derivatives("tanh", [](auto x) { return tanh(x); }, {-2, 0, 0.5});
  expect_derivatives("asinh", [](auto x) { return asinh(x); }, {-2, 0, 0.5});
  expect_derivatives("acosh", [](auto x) { return acosh(x); }, {1.2, 5});
  expect_derivatives("atanh", [](auto x) { return atanh(x); }, {-0.9, 0, 0.5});
}

TEST(DualFunctions, OfTwoArgumentsMatchNumericDerivatives) {
  expect_derivatives("atan2(sin(x), cos(x))", [](auto x) { return atan2(sin(x), cos(x)); },
                     {-3, -1, 0, 1, 2, 3});
  expect_derivatives("atan2(x, c)", [](auto x) { return atan2(x, 2.0); }, {-1, 0, 1});
  expect_derivatives("atan2(c, x)", [](auto x) { return atan2(2.0, x); }, {-1, 0, 1});
  expect_derivatives("hypot", [](auto x) { return hypot(x, 2 * x + 1); }, {-3, 0, 1});
  expect_derivatives("hypot(x, c)", [](auto x) { return hypot(x, 2.0); }, {-3, 0, 1});
  expect_derivatives("hypot(c, x)", [](auto x) { return hypot(2.0, x); }, {-3, 0, 1});
  expect_derivatives("pow(x, c)", [](auto x) { return pow(x, 2.5); }, {0.1, 1, 3});
  expect_derivatives("pow(x, 3)", [](auto x) { return pow(x, 3); }, {-2, 0.5, 3});
  expect_derivatives("pow(c, x)", [](auto x) { return pow(2.5, x); }, {-1, 0, 3});
  expect_derivatives("pow(x, x)", [](auto x) { return pow(x, x); }, {0.1, 1, 3});
  expect_derivatives("fmin", [](auto x) { return fmin(x * x, x); }, {0.5, 3});
  expect_derivatives("fmax", [](auto x) { return fmax(x * x, x); }, {0.5, 3});
  expect_derivatives("fmin(x, c)", [](auto x) { return fmin(x, 1.0); }, {0.5, 3});
  expect_derivatives("fmax(c, x)", [](auto x) { return fmax(1.0, x); }, {0.5, 3});
  expect_derivatives("copysign", [](auto x) { return copysign(x, -1.0); }, {-2, 3});
}

TEST(DualFunctions, HaveDerivativeZeroInConstantDirectionsEvenIfTheSlopeIsInfinite) {
  const D2 zero = D2::variable(0, 0);
  EXPECT_EQ(sqrt(zero).derivative[0], kInfinity);
  EXPECT_EQ(sqrt(zero).derivative[1], 0);
  EXPECT_EQ(sqrt(D2(0)).derivative[0], 0);
  EXPECT_EQ(asin(D2(1)).derivative[0], 0);
  EXPECT_EQ(acos(D2(-1)).derivative[0], 0);
  EXPECT_EQ(hypot(D2(0), zero).derivative[0], 0);
}

TEST(DualFunctions, PowersAtZeroHaveFiniteDerivatives) {
  const D2 zero = D2::variable(0, 0);
  EXPECT_EQ(pow(zero, 0).derivative[0], 0);
  EXPECT_EQ(pow(zero, 1).derivative[0], 1);
  EXPECT_EQ(pow(zero, 2).derivative[0], 0);
  EXPECT_EQ(pow(0.0, D2::variable(2, 1)).derivative[1], 0);
  EXPECT_EQ(pow(zero, D2::variable(2, 1)).derivative[1], 0);
  EXPECT_EQ(pow(D2::variable(-2, 0), D2(3)).derivative[0], 12);
}

TEST(DualFunctions, AbsoluteValueHasDerivativeOneAtZero) {
  EXPECT_EQ(abs(D1::variable(0, 0)).derivative[0], 1);
  EXPECT_EQ(abs(D1::variable(-0.0, 0)).derivative[0], 1);
}

TEST(DualFunctions, ClassifyNumbers) {
  D1 x = D1::variable(1, 0);
  EXPECT_TRUE(isfinite(x));
  EXPECT_FALSE(isnan(x));
  EXPECT_TRUE(signbit(-x));
  x.derivative[0] = kInfinity;
  EXPECT_FALSE(isfinite(x));
  EXPECT_TRUE(isinf(D1(kInfinity)));
  EXPECT_TRUE(isnan(sqrt(D1(-1))));
}

}  // namespace
}  // namespace boxplus
