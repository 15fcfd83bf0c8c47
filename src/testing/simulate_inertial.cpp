// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/testing/simulate_inertial.h"

#include <cmath>
#include <string>
#include <utility>

#include "boxplus/autodiff/dual.h"
#include "boxplus/base/error.h"
#include "boxplus/types/inertial/inertial_between.h"
#include "testing/random_numbers.h"

namespace boxplus {
namespace {

using Time = detail::Dual<double, 1>;

/// A sin(ωt + φ) along one axis.
struct Oscillation {
  int axis;
  double amplitude, frequency, phase;
};
constexpr Oscillation kPath[] = {{0, 21, 0.085, 0},   {1, 10, 0.17, 0},  {2, 1.5, 0.31, 0.4},
                                 {0, 0.04, 4.1, 0.2}, {1, 0.05, 3.3, 1}, {2, 0.04, 4.7, 2}};

/// The derivative of the position of this order with respect to time. Order 0 is the position.
template <class S>
Vector<S, 3> path(int order, const S& time) {
  using std::sin;
  Vector<S, 3> sum(S(0), S(0), S(0));
  for (const Oscillation& part : kPath) {
    sum[part.axis] += part.amplitude * std::pow(part.frequency, order) *
                      sin(S(part.frequency * time + (part.phase + order * kPi / 2)));
  }
  return sum;
}

/// The heading of the path, and a sway.
template <class S>
BasicSO3<S> attitude(const S& time) {
  using std::atan2;
  using std::sin;
  const Vector<S, 3> velocity = path(1, time);
  const S zero(0);
  const Vector<S, 3> yaw(zero, zero, S(atan2(velocity[1], velocity[0])));
  const Vector<S, 3> pitch(zero, S(0.15 * sin(S(0.9 * time))), zero);
  const Vector<S, 3> roll(S(0.2 * sin(S(0.7 * time + 0.5))), zero, zero);
  return BasicSO3<S>::from_rotation_vector(yaw) * BasicSO3<S>::from_rotation_vector(pitch) *
         BasicSO3<S>::from_rotation_vector(roll);
}

void require(bool is_right, const char* expected) {
  if (!is_right) throw InvalidArgument(std::string("simulate_inertial: expected ") + expected);
}

void check(const InertialOptions& options) {
  require(options.seconds > 0 && std::isfinite(options.seconds), "a positive duration");
  require(options.imu_rate > 0 && options.keyframe_rate > 0, "positive rates");
  require(options.imu_rate % options.keyframe_rate == 0,
          "a rate of keyframes that divides the rate of the IMU");
  require(options.seconds * options.imu_rate < 1e9, "fewer than a billion measurements");
  require(std::isfinite(options.camera_delay), "a finite delay of the camera");
  require(options.landmarks > 0, "a positive number of landmarks");
}

class InertialSimulator {
 public:
  explicit InertialSimulator(const InertialOptions& options) : options_(options), random_(options.seed) {
    result_.sample_seconds = 1.0 / options.imu_rate;
    result_.gravity = {0, 0, -kStandardGravity};
    // The camera looks to the left, and its y axis points down.
    Matrix<double, 3, 3> R;
    R << 1, 0, 0, 0, 0, 1, 0, -1, 0;
    result_.camera_pose = SE3(Vector3(0.1, 0.05, -0.02), R);
    result_.camera = PinholeCamera(320.0, 320.0, 320.0, 240.0);
  }

  InertialSimulation run() {
    add_landmarks();
    ImuBias bias;
    bias << options_.gyroscope_bias * normal(), options_.accelerometer_bias * normal();
    const int samples = static_cast<int>(std::lround(options_.seconds * options_.imu_rate));
    for (int k = 0; k <= samples; ++k) {
      if (k % (options_.imu_rate / options_.keyframe_rate) == 0) add_keyframe(k, bias);
      if (k < samples) add_sample(k, bias);
    }
    return std::move(result_);
  }

 private:
  Vector3 normal() {
    const double x = random_.normal(), y = random_.normal(), z = random_.normal();
    return {x, y, z};
  }

  void add_landmarks() {
    for (int k = 0; k < options_.landmarks; ++k) {
      const SE3 pose = simulated_flight(random_.uniform(0, options_.seconds)).state.pose;
      const double ahead = random_.uniform(-3, 3), left = random_.uniform(3, 12), up = random_.uniform(-4, 4);
      result_.true_landmarks.push_back(pose * Vector3(ahead, left, up));
    }
  }

  void add_keyframe(int sample, const ImuBias& bias) {
    const double time = sample * result_.sample_seconds;
    const InertialState state = simulated_flight(time).state;
    InertialSimulation::Keyframe keyframe{time, sample, state, bias, {}};
    const SE3 camera = simulated_flight(time + options_.camera_delay).state.pose * result_.camera_pose;
    for (int k = 0; k < options_.landmarks; ++k) {
      const Vector3 point = camera.inverse_times(result_.true_landmarks[k]);
      if (point[2] < 1 || point[2] > 15) continue;
      const Vector2 pixel = result_.camera.project(point);
      if (pixel[0] < 0 || pixel[0] > 640 || pixel[1] < 0 || pixel[1] > 480) continue;
      const double x = random_.normal(), y = random_.normal();
      keyframe.sightings.push_back({k, pixel + options_.pixel_noise * Vector2(x, y)});
    }
    result_.keyframes.push_back(std::move(keyframe));
  }

  /// Adds the measurement at the middle of its interval, which is its mean up to terms of second order.
  void add_sample(int sample, ImuBias& bias) {
    const double dt = result_.sample_seconds, root = std::sqrt(dt);
    const BodyMotion motion = simulated_flight((sample + 0.5) * dt);
    const ImuNoise& noise = options_.noise;
    const Vector3 omega = motion.angular_velocity + bias.head<3>() + noise.gyroscope / root * normal();
    const Vector3 force =
        motion.specific_force(result_.gravity) + bias.tail<3>() + noise.accelerometer / root * normal();
    result_.samples.push_back({omega, force});
    bias.head<3>() += noise.gyroscope_walk * root * normal();
    bias.tail<3>() += noise.accelerometer_walk * root * normal();
  }

  InertialOptions options_;
  RandomNumbers random_;
  InertialSimulation result_;
};

}  // namespace

BodyMotion simulated_flight(double seconds) {
  Time time(seconds);
  time.derivative[0] = 1;
  const detail::Quaternion<Time> moving = attitude(time).quaternion();
  const detail::Quaternion<double> q{moving.x.value, moving.y.value, moving.z.value, moving.w.value},
      rate{moving.x.derivative[0], moving.y.derivative[0], moving.z.derivative[0], moving.w.derivative[0]};
  const detail::Quaternion<double> half = q.conjugate() * rate;  // (ω/2, 0)
  return {
      {SE3(path(0, seconds), q), path(1, seconds)}, path(2, seconds), 2 * Vector3(half.x, half.y, half.z)};
}

InertialSimulation simulate_inertial(const InertialOptions& options) {
  check(options);
  return InertialSimulator(options).run();
}

}  // namespace boxplus
