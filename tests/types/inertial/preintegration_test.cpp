// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/types/inertial/preintegration.h"

#include <gmock/gmock.h>

#include <Eigen/Cholesky>
#include <cmath>
#include <limits>
#include <vector>

#include "boxplus/base/error.h"
#include "boxplus/testing/simulate_inertial.h"
#include "boxplus/types/inertial/inertial_between.h"
#include "testing/random_numbers.h"
#include "types/expect_jacobians.h"

namespace boxplus {
namespace {

using Matrix15 = Preintegration::Covariance;
using Vector15 = Vector<double, 15>;

/// The error of the motion that was measured between two states with known biases.
Vector15 error_of(const InertialMotion& motion, const InertialState& i, const ImuBias& bias_i,
                  const InertialState& j, const ImuBias& bias_j) {
  return InertialBetween(motion).error(i.pose, i.velocity, bias_i, j.pose, j.velocity, bias_j);
}

/// The measurements of an IMU without errors on the simulated flight, each at the middle of its interval.
InertialMotion exact_motion(double begin, double end, int measurements) {
  const Vector3 gravity(0, 0, -kStandardGravity);
  const double dt = (end - begin) / measurements;
  Preintegration sum{ImuNoise{}};
  for (int k = 0; k < measurements; ++k) {
    const BodyMotion motion = simulated_flight(begin + (k + 0.5) * dt);
    sum.integrate(motion.angular_velocity, motion.specific_force(gravity), dt);
  }
  return sum.motion();
}

TEST(Preintegration, OfACircleEndsAfterHalfTheCircleOnItsOtherSide) {
  constexpr double kRadius = 2, kSpeed = 3, kRate = kSpeed / kRadius;
  constexpr int kSteps = 1000;
  Preintegration sum{ImuNoise{}};
  // The body turns to its left. The force at rest points up, and the centripetal force to the left.
  for (int k = 0; k < kSteps; ++k)
    sum.integrate({0, 0, kRate}, {0, kSpeed * kRate, kStandardGravity}, kPi / kRate / kSteps);
  const InertialState end =
      sum.motion().predict(SE3(), Vector3(kSpeed, 0, 0), ImuBias::Zero(), Vector3(0, 0, -kStandardGravity));
  EXPECT_LT((end.pose.translation() - Vector3(0, 2 * kRadius, 0)).norm(), 1e-5);
  EXPECT_LT((end.velocity - Vector3(-kSpeed, 0, 0)).norm(), 1e-5);
  EXPECT_LT((end.pose.so3().rotation_vector().cwiseAbs() - Vector3(0, 0, kPi)).norm(), 1e-9);
}

TEST(Preintegration, OfABodyAtRestIsNoMotion) {
  Preintegration sum{ImuNoise{}};
  const SE3 tilted = pose(1, 2, 3, 0.3, -0.2, 2);
  const Vector3 gravity(0, 0, -kStandardGravity);
  for (int k = 0; k < 20; ++k) sum.integrate(Vector3::Zero(), tilted.rotation().transpose() * -gravity, 0.1);
  const InertialState end = sum.motion().predict(tilted, Vector3::Zero(), ImuBias::Zero(), gravity);
  EXPECT_LT((end.pose.vector() - tilted.vector()).norm(), 1e-13);
  EXPECT_LT(end.velocity.norm(), 1e-13);
}

// The intermediate measurements are wrong by second order, too, so this also tests the simulated flight: its
// velocity, acceleration and angular velocity are the derivatives of its pose.
TEST(Preintegration, HasAnErrorOfSecondOrderInTheTimeBetweenMeasurements) {
  const InertialState begin = simulated_flight(1).state, end = simulated_flight(3).state;
  const auto error = [&](int measurements) {
    return error_of(exact_motion(1, 3, measurements), begin, ImuBias::Zero(), end, ImuBias::Zero()).norm();
  };
  EXPECT_LT(error(400), 1e-4);
  EXPECT_NEAR(error(100) / error(200), 4, 0.1);
  EXPECT_NEAR(error(200) / error(400), 4, 0.1);
}

/// A second of random measurements around a turn, with a bias.
std::vector<InertialSimulation::ImuSample> random_samples(std::uint64_t seed) {
  RandomNumbers random(seed);
  const auto vector = [&](double size) {
    const double x = random.uniform(-size, size), y = random.uniform(-size, size),
                 z = random.uniform(-size, size);
    return Vector3(x, y, z);
  };
  std::vector<InertialSimulation::ImuSample> samples;
  const Vector3 turn = vector(1), push = vector(3) + Vector3(0, 0, 9.8);
  for (int k = 0; k < 100; ++k) samples.push_back({turn + vector(0.5), push + vector(2)});
  return samples;
}

InertialMotion motion_of(const std::vector<InertialSimulation::ImuSample>& samples, const ImuBias& bias) {
  Preintegration sum(ImuNoise{}, bias);
  for (const auto& [omega, force] : samples) sum.integrate(omega, force, 0.01);
  return sum.motion();
}

/// (ΔR, Δv, Δp) of b relative to a.
Vector<double, 9> difference(const InertialMotion::Corrected<double>& b,
                             const InertialMotion::Corrected<double>& a) {
  Vector<double, 9> result;
  result << detail::RotationVectorChart::log(a.rotation.conjugate() * b.rotation), b.velocity - a.velocity,
      b.position - a.position;
  return result;
}

TEST(Preintegration, HasTheJacobiansOfANewIntegrationWithOtherBiases) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const auto samples = random_samples(seed);
    ImuBias bias;
    bias << 0.02, -0.01, 0.03, 0.1, 0.2, -0.1;
    const InertialMotion motion = motion_of(samples, bias);
    for (int k = 0; k < 6; ++k) {
      const ImuBias step = 1e-4 * ImuBias::Unit(k);
      const InertialMotion ahead = motion_of(samples, bias + step), behind = motion_of(samples, bias - step);
      const Vector<double, 9> numeric =
          difference(ahead.corrected<double>(ahead.bias), behind.corrected<double>(behind.bias)) / 2e-4;
      EXPECT_LT((numeric - motion.bias_jacobian.col(k)).norm(), 1e-6) << "seed " << seed << ", bias " << k;
    }
  }
}

TEST(Preintegration, CorrectsItsMotionForOtherBiasesUpToSecondOrder) {
  const auto samples = random_samples(3);
  ImuBias direction;
  direction << 0.02, -0.03, 0.01, 0.1, -0.2, 0.15;
  const InertialMotion motion = motion_of(samples, ImuBias::Zero());
  const auto error = [&](double size) {
    const InertialMotion again = motion_of(samples, size * direction);
    return difference(motion.corrected<double>(again.bias), again.corrected<double>(again.bias)).norm();
  };
  EXPECT_LT(error(1), 0.01);
  EXPECT_NEAR(error(1) / error(0.5), 4, 0.2);
  EXPECT_NEAR(error(0.5) / error(0.25), 4, 0.1);
}

// The sample covariance of N whitened errors differs from I by about 1/√N per entry, and √2 times that on the
// diagonal.
TEST(Preintegration, PropagatesTheCovarianceThatAMonteCarloSimulationHas) {
  constexpr int kRuns = 4000, kSteps = 60;
  constexpr double kSeconds = 0.02;
  // Large walks, so that their share of the covariance shows.
  const ImuNoise noise{2e-3, 1e-2, 4e-3, 2e-2};
  RandomNumbers random(1);
  const auto normal = [&](double sigma) {
    const double x = random.normal(), y = random.normal(), z = random.normal();
    return Vector3(sigma * x, sigma * y, sigma * z);
  };
  const auto omega_at = [](int k) { return Vector3(0.5 * std::sin(0.1 * k), -0.7, 1 * std::cos(0.07 * k)); };
  const auto force_at = [](int k) { return Vector3(1, 3 * std::sin(0.2 * k), 9.8); };

  Preintegration truth(noise);
  for (int k = 0; k < kSteps; ++k) truth.integrate(omega_at(k), force_at(k), kSeconds);
  const InertialState begin{pose(1, 2, 3, 0.1, 0.2, 0.3), Vector3(1, -1, 0.5)};
  const InertialState end =
      truth.motion().predict(begin.pose, begin.velocity, ImuBias::Zero(), Vector3(0, 0, -kStandardGravity));
  const Eigen::LLT<Eigen::Matrix<double, 15, 15>> factor(truth.covariance());
  ASSERT_EQ(factor.info(), Eigen::Success);

  Matrix15 sum = Matrix15::Zero();
  for (int run = 0; run < kRuns; ++run) {
    Preintegration measured(noise);
    ImuBias bias = ImuBias::Zero();
    for (int k = 0; k < kSteps; ++k) {
      const double root = std::sqrt(kSeconds);
      measured.integrate(omega_at(k) + bias.head<3>() + normal(noise.gyroscope / root),
                         force_at(k) + bias.tail<3>() + normal(noise.accelerometer / root), kSeconds);
      bias.head<3>() += normal(noise.gyroscope_walk * root);
      bias.tail<3>() += normal(noise.accelerometer_walk * root);
    }
    const Vector15 white =
        factor.matrixL().solve(error_of(measured.motion(), begin, ImuBias::Zero(), end, bias));
    sum += white * white.transpose() / kRuns;
  }
  for (int i = 0; i < 15; ++i) {
    for (int j = 0; j <= i; ++j) {
      const double sigma = std::sqrt((i == j ? 2.0 : 1.0) / kRuns);
      EXPECT_NEAR(sum(i, j), i == j ? 1 : 0, 5 * sigma) << i << ", " << j;
    }
  }
}

TEST(Preintegration, HasTheInverseOfItsCovarianceAsInformation) {
  Preintegration sum{ImuNoise{}};
  for (int k = 0; k < 2; ++k) sum.integrate({0.1, 0.2, 0.3}, {1, 2, 9}, 0.005);
  EXPECT_LT((sum.information() * sum.covariance() - Matrix15::Identity()).cwiseAbs().maxCoeff(), 1e-6);
  EXPECT_EQ(sum.measurements(), 2);
}

TEST(Preintegration, HasNoInformationIfTheCovarianceIsSingular) {
  Preintegration one{ImuNoise{}};
  one.integrate({0.1, 0.2, 0.3}, {1, 2, 9}, 0.005);
  EXPECT_THROW(one.information(), InvalidArgument);
  Preintegration constant_bias{ImuNoise{.gyroscope_walk = 0}};
  for (int k = 0; k < 10; ++k) constant_bias.integrate({0.1, 0.2, 0.3}, {1, 2, 9}, 0.005);
  EXPECT_THROW(constant_bias.information(), InvalidArgument);
}

TEST(Preintegration, RejectsMeasurementsThatAreNotFiniteOrHaveNoDuration) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  Preintegration sum{ImuNoise{}};
  EXPECT_THROW(sum.integrate({kNan, 0, 0}, {0, 0, 9}, 0.1), InvalidArgument);
  EXPECT_THROW(sum.integrate({0, 0, 0}, {0, kNan, 9}, 0.1), InvalidArgument);
  EXPECT_THROW(sum.integrate({0, 0, 0}, {0, 0, 9}, kNan), InvalidArgument);
  EXPECT_THROW(sum.integrate({0, 0, 0}, {0, 0, 9}, 0), InvalidArgument);
  EXPECT_THROW(sum.integrate({0, 0, 0}, {0, 0, 9}, -0.1), InvalidArgument);
  EXPECT_THROW(Preintegration(ImuNoise{.accelerometer = -1}), InvalidArgument);
  EXPECT_THROW(Preintegration(ImuNoise{}, ImuBias::Constant(kNan)), InvalidArgument);
  EXPECT_EQ(sum.measurements(), 0);
}

}  // namespace
}  // namespace boxplus
