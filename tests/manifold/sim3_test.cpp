// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/manifold/sim3.h"

#include <gtest/gtest.h>

#include "boxplus/testing/check_manifold.h"
#include "manifold/samples.h"

namespace boxplus {
namespace {

Vector<double, 7> random_tangent(Samples& s, double angle, double log_scale) {
  Vector<double, 7> v;
  v << s.vector<3>(angle), s.vector<3>(5), s.uniform(-log_scale, log_scale);
  return v;
}

TEST(Sim3, ObeysTheManifoldLaws) {
  Samples s;
  auto points = Samples::many(8, [&] { return Sim3::exp(random_tangent(s, 1.7, 1)); });
  points.push_back(Sim3());
  for (const double step : {0.4, 0.1, 0.005}) {
    ManifoldCheckOptions options;
    options.step = step;
    const ManifoldCheck check = check_manifold(points, options);
    EXPECT_TRUE(check) << check.message << ", step " << step;
  }
}

TEST(Sim3, LogarithmInvertsExponentialForEveryMagnitude) {
  Samples s;
  for (const double angle : {0.0, 1e-12, 1e-6, 1e-3, 0.04, 0.06, 0.3, 1.8}) {
    for (const double log_scale : {0.0, 1e-12, 1e-6, 1e-3, 0.1, 1.0, 3.9, 6.0}) {
      for (int i = 0; i < 20; ++i) {
        const Vector<double, 7> v = random_tangent(s, angle, log_scale);
        EXPECT_LT((Sim3::exp(v).log() - v).norm(), 2e-13 * std::exp(std::abs(v[6]))) << v.transpose();
      }
    }
  }
}

TEST(Sim3, ExponentialIsTheSquareOfTheExponentialOfHalfTheTangent) {
  Samples s;
  for (const double log_scale : {0.0, 1e-4, 1.0, 5.0}) {
    const Vector<double, 7> v = random_tangent(s, 1.2, log_scale);
    const Sim3 whole = Sim3::exp(v);
    const Sim3 half = Sim3::exp(0.5 * v);
    EXPECT_LT(((half * half).translation() - whole.translation()).norm(),
              1e-12 * (1 + whole.translation().norm()));
    EXPECT_NEAR((half * half).scale(), whole.scale(), 1e-13 * whole.scale());
    EXPECT_LT(((half * half).rotation() - whole.rotation()).norm(), 1e-14);
  }
}

/// Sim3Coupling contains the coefficients of the matrix that maps υ to the translation in Sim3::exp().
TEST(Sim3, CouplingIsTheSameFromItsSeriesAndFromItsClosedForm) {
  for (const double theta : {0.001, 0.04, 0.06, 1.0, 3.1}) {
    for (const double sigma : {-4.0, -3.5, 3.5, 4.0, 0.2}) {
      if (sigma == 0.2 && theta < 1) continue;  // the closed form is inaccurate if both are small
      const auto series = detail::Sim3Coupling<double>::from_series(sigma, theta * theta);
      const auto closed = detail::Sim3Coupling<double>::from_closed_form(sigma, theta * theta);
      EXPECT_NEAR(series.a, closed.a, 3e-13) << theta << " " << sigma;
      EXPECT_NEAR(series.b, closed.b, 3e-13) << theta << " " << sigma;
      EXPECT_NEAR(series.c, closed.c, 3e-13) << theta << " " << sigma;
    }
  }
}

/// The Sim3Coupling, computed in long double from 59 terms of its series.
detail::Sim3Coupling<long double> long_series(long double sigma, long double theta2) {
  long double p = 1, q = 0, r = 0, power = 1, factor = 1;
  detail::Sim3Coupling<long double> sum{0, 0, 1};
  for (int n = 1; n < 60; ++n) {
    factor /= n + 1;
    r = sigma * r + q;
    const long double next_p = sigma * p - theta2 * q;
    q = p + sigma * q;
    p = next_p;
    power *= sigma;
    sum.a += factor * q;
    sum.b += factor * r;
    sum.c += factor * power;
  }
  return sum;
}

TEST(Sim3, CouplingIsExactForAnyNumberOfTermsOfItsSeries) {
  for (const double size : {1e-9, 1e-3, 0.0624, 0.0626, 0.3, 0.9999, 1.0001, 2.0, 3.9999}) {
    for (const double share : {0.0, 0.1, 0.5, 0.9, 1.0}) {
      for (const double sign : {-1.0, 1.0}) {
        const double sigma = sign * size * share, theta2 = size * size * (1 - share * share);
        const auto coupling = detail::Sim3Coupling<double>::of(sigma, theta2);
        const auto expected = long_series(sigma, theta2);
        const double tolerance = 2e-15 * std::exp(size);
        EXPECT_NEAR(coupling.a, static_cast<double>(expected.a), tolerance) << sigma << " " << theta2;
        EXPECT_NEAR(coupling.b, static_cast<double>(expected.b), tolerance) << sigma << " " << theta2;
        EXPECT_NEAR(coupling.c, static_cast<double>(expected.c), tolerance) << sigma << " " << theta2;
      }
    }
  }
}

TEST(Sim3, ActsAsScaledRotationAndTranslation) {
  Samples s;
  const Sim3 a = Sim3::exp(random_tangent(s, 1.7, 1)), b = Sim3::exp(random_tangent(s, 1.7, 1));
  const Vector<double, 3> p(1, -2, 3);
  EXPECT_LT((a * p - (a.scale() * (a.rotation() * p) + a.translation())).norm(), 1e-13);
  EXPECT_LT(((a * b) * p - a * (b * p)).norm(), 1e-12);
  EXPECT_LT((a.inverse() * (a * p) - p).norm(), 1e-13);
}

TEST(Sim3, TangentIsRotationThenTranslationThenLogScale) {
  Vector<double, 7> v;
  v << 0, 0, 0, 1, 2, 3, 0;
  EXPECT_EQ(Sim3::exp(v).translation(), (Vector<double, 3>(1, 2, 3)));
  v << 0, 0, 0.5, 0, 0, 0, std::log(2);
  EXPECT_DOUBLE_EQ(Sim3::exp(v).scale(), 2);
  EXPECT_NEAR(Sim3::exp(v).rotation()(1, 0), std::sin(0.5), 1e-16);
}

TEST(Sim3, HasExactJacobiansFromDualNumbers) {
  Samples s;
  for (const double size : {0.0, 1e-3, 1.0}) {
    const Sim3 a = Sim3::exp(random_tangent(s, 1, 1));
    const Sim3 b = a * Sim3::exp(Vector<double, 7>(size * random_tangent(s, 1, 1)));
    const auto error = [&](const auto& x) { return (b.inverse() * x).log(); };
    Matrix<double, 7, 7> numeric;
    detail::numeric_jacobian(error, a, numeric);
    EXPECT_LT((dual_jacobian<7>(error, a) - numeric).cwiseAbs().maxCoeff(), 1e-8);
  }
}

}  // namespace
}  // namespace boxplus
