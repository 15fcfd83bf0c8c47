// SPDX-License-Identifier: BSD-3-Clause
// check_manifold() finds each violation of a law, and its message names the law.
#include "boxplus/testing/check_manifold.h"

#include <gmock/gmock.h>

#include <cmath>

namespace boxplus {
namespace {

using testing::HasSubstr;

enum class Defect { kNone, kDrift, kWrongMinus, kWrongScale, kNotSmooth, kLiftedValue, kLiftedDerivative };

/// The real line with one defect.
template <Defect kDefect, class S = double>
struct Line {
  S value;
};

}  // namespace

template <Defect kDefect, class S>
struct Manifold<Line<kDefect, S>> {
  using Point = Line<kDefect, S>;
  static constexpr int kDim = 1;
  template <class T>
  using Rebind = Line<kDefect, T>;
  template <class T>
  static Rebind<T> cast(const Point& x) {
    return {T(x.value)};
  }
  static Point oplus(const Point& x, const S* delta) {
    if (kDefect == Defect::kDrift) return {x.value + delta[0] + 1e-3};
    if (kDefect == Defect::kWrongScale) return {x.value + 2.0 * delta[0]};
    if (kDefect == Defect::kNotSmooth) return {x.value + delta[0] * abs(delta[0])};
    if constexpr (detail::kIsDual<S>) {
      if (kDefect == Defect::kLiftedValue) return {x.value + delta[0] + 1e-3};
      if (kDefect == Defect::kLiftedDerivative) return {S(x.value.value + delta[0].value)};
    }
    return {x.value + delta[0]};
  }
  static void ominus(const Point& y, const Point& x, S* delta) {
    const S d = y.value - x.value;
    delta[0] = d;
    if (kDefect == Defect::kWrongMinus) delta[0] = 0.5 * d;
    if (kDefect == Defect::kNotSmooth) delta[0] = d / sqrt(abs(d) + 1e-300);
  }
};

namespace {

template <Defect kDefect>
std::string complaint() {
  return check_manifold(std::vector<Line<kDefect>>{{1.0}, {2.5}}).message;
}

TEST(CheckManifold, AcceptsATypeThatObeysAllLaws) {
  EXPECT_EQ(complaint<Defect::kNone>(), "");
}

TEST(CheckManifold, NamesTheLawThatFailsAndByHowMuch) {
  EXPECT_EQ(complaint<Defect::kDrift>(), "sample 0: law 1, x ⊞ 0 = x: component 0 is off by 0.001");
  EXPECT_THAT(complaint<Defect::kWrongMinus>(),
              HasSubstr("law 2, x ⊞ (y ⊟ x) = y: component 0 is off by 0.375"));
  EXPECT_THAT(complaint<Defect::kWrongScale>(), HasSubstr("law 2"));
  EXPECT_THAT(complaint<Defect::kNotSmooth>(), HasSubstr("law 4"));
}

TEST(CheckManifold, ComparesTheTypeOfDualNumbersWithTheTypeOfDoubles) {
  EXPECT_THAT(complaint<Defect::kLiftedValue>(), HasSubstr("has the value of"));
  EXPECT_THAT(complaint<Defect::kLiftedDerivative>(), HasSubstr("has the derivative of"));
}

}  // namespace
}  // namespace boxplus
