// SPDX-License-Identifier: BSD-3-Clause
// Simulates a body that flies around with an IMU and a camera, for tests, benchmarks and demonstrations.
//
// The same options give the same measurements with every compiler, because the random number generator is
// part of the library. On another computer, values may differ by rounding errors.
#pragma once

#include <cstdint>
#include <vector>

#include "boxplus/types/ba/camera_models.h"
#include "boxplus/types/inertial/preintegration.h"

namespace boxplus {

/// The true motion of a body at one time. The z axis of the world points up.
struct BodyMotion {
  InertialState state;
  Vector3 acceleration;      ///< m/s², in the world
  Vector3 angular_velocity;  ///< rad/s, in the frame of the body

  /// What an accelerometer without errors measures (m/s², in the frame of the body).
  Vector3 specific_force(const Vector3& gravity) const {
    return state.pose.rotation().transpose() * (acceleration - gravity);
  }
};

/// A smooth flight along a figure of eight of 42 m × 20 m at about 2 m/s, with the x axis of the body ahead.
/// The body sways by up to 0.25 rad.
BodyMotion simulated_flight(double seconds);

struct InertialOptions {
  double seconds = 100;
  int imu_rate = 200;     ///< measurements per second
  int keyframe_rate = 2;  ///< images per second; divides imu_rate
  ImuNoise noise = {};
  double gyroscope_bias = 0.01;     ///< standard deviation of the biases at the beginning (rad/s)
  double accelerometer_bias = 0.1;  ///< the same, in m/s²
  double pixel_noise = 1;           ///< standard deviation of each coordinate of a pixel
  double camera_delay = 0;          ///< an image is taken so many seconds after the time of its keyframe
  int landmarks = 600;
  std::uint64_t seed = 1;
};

struct InertialSimulation {
  struct ImuSample {
    Vector3 angular_velocity, specific_force;  ///< the means over 1/imu_rate seconds
  };
  struct Sighting {
    int landmark;
    Vector2 pixel;
  };
  struct Keyframe {
    double time;      ///< seconds
    int next_sample;  ///< the index of the measurement that begins at this time
    InertialState true_state;
    ImuBias true_bias;
    std::vector<Sighting> sightings;  ///< in the order of the landmarks
  };

  std::vector<ImuSample> samples;
  std::vector<Keyframe> keyframes;
  std::vector<Vector3> true_landmarks;
  double sample_seconds;  ///< 1/imu_rate
  Vector3 gravity;        ///< the acceleration of a falling body (m/s², in the world)
  SE3 camera_pose;        ///< T_body_camera
  PinholeCamera camera;
};

/// Each keyframe sees the landmarks that are in its image of 640 × 480 pixels, at a depth of 1 m to 15 m.
/// Throws InvalidArgument if the duration, a rate or the number of landmarks is not positive, if the rate of
/// keyframes does not divide the rate of the IMU, or for at least a billion measurements.
InertialSimulation simulate_inertial(const InertialOptions& options = {});

}  // namespace boxplus
