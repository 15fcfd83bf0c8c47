// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "boxplus/types/ba.h"
#include "boxplus/types/slam3d.h"
#include "testing/grid_walk.h"
#include "testing/robot_options.h"
#include "testing/simulator.h"
#include "testing/turned.h"

namespace boxplus {
namespace {

/// The pose of the robot on its walk at step k. It sways.
SE3 swaying(const SE2& pose, int k) {
  const SE3 level(Vector3(pose.x(), pose.y(), 0.5 * std::sin(0.3 * k)),
                  turned(0, 0, pose.theta()).quaternion());
  return level * turned(0.15 * std::sin(0.7 * k), 0.15 * std::cos(0.5 * k), 0);
}

/// A camera of 640 × 480 pixels.
struct MountedCamera {
  static constexpr double kFocalLength = 500, kWidth = 640, kHeight = 480, kNearest = 1, kFarthest = 8;
  using Camera = Product<SE3, PinholeCamera>;

  /// It looks ahead: its z-axis is the x-axis of the robot, and its y-axis points down.
  static Camera camera() {
    Matrix<double, 3, 3> R;
    R << 0, 0, 1, -1, 0, 0, 0, -1, 0;
    return Camera(SE3(Vector3(0.2, 0.05, 0.3), R),
                  PinholeCamera(kFocalLength, kFocalLength, kWidth / 2, kHeight / 2));
  }

  /// u, v and the depth of a point in the frame of the robot.
  static Vector3 image(const Vector3& in_body) {
    const Camera mounted = camera();
    const Vector3 p = mounted.get<0>().inverse_times(in_body);
    const Vector2 pixel = mounted.get<1>().project(p);
    return {pixel[0], pixel[1], p[2]};
  }
  static bool sees(const Vector3& image) {
    return image[2] >= kNearest && image[2] <= kFarthest && image[0] >= 0 && image[0] <= kWidth &&
           image[1] >= 0 && image[1] <= kHeight;
  }
  /// The point, in the frame of the robot, with this pixel and depth.
  static Vector3 point(const Vector3& image) {
    const double x = (image[0] - kWidth / 2) / kFocalLength, y = (image[1] - kHeight / 2) / kFocalLength;
    return camera().get<0>() * Vector3(x * image[2], y * image[2], image[2]);
  }
};

class SpaceRobot {
 public:
  explicit SpaceRobot(const SpaceRobotOptions& options)
      : options_(options),
        world_(world_seed(options.seed)),
        simulator_(simulation_options(options), {0.02, 0.003}),
        walk_(options.world_size) {
    const double half = options.world_size / 2;
    for (int k = 0; k < options.landmarks; ++k) {
      const double x = world_.uniform(-half, half), y = world_.uniform(-half, half),
                   z = world_.uniform(-4, 4);
      cells_.add({x, y}, points_.add({x, y, z}));
    }
  }

  Simulation run() {
    add_parameters();
    for (int k = 0; k < options_.poses; ++k) {
      simulator_.drive_to(swaying(walk_.pose(), k), options_.has_odometry);
      look();
      walk_.step(world_);
    }
    return simulator_.take();
  }

 private:
  bool has_sensor(SpaceSensor sensor) const { return has(options_, sensor); }

  void add_parameters() {
    using enum SpaceSensor;
    if (has_sensor(kPoints)) point_sensor_ = simulator_.add_parameter(mounting());
    if (has_sensor(kDepthImages) || has_sensor(kDisparityImages))
      camera_ = simulator_.add_parameter(MountedCamera::camera());
    if (has_sensor(kCompass) || has_sensor(kGps)) center_ = simulator_.add_parameter(SE3());
  }

  void look() {
    using enum SpaceSensor;
    const SE3 pose = simulator_.truth(simulator_.size() - 1);
    const Vector2 place(pose.translation()[0], pose.translation()[1]);
    if (has_sensor(kPoints)) see_points(pose, place);
    if (has_sensor(kDepthImages)) see_images<DepthImage>(pose, place);
    if (has_sensor(kDisparityImages)) see_images<DisparityImage>(pose, place);
    if (has_sensor(kPoses)) {
      revisits_.arrive(place, random(),
                       [&](int other) { simulator_.recognize(other, simulator_.size() - 1); });
    }
    if (simulator_.size() < 2) return;  // the first pose is fixed, so nothing needs to measure it
    if (has_sensor(kCompass)) {
      constexpr double kDeviation = 0.02 / 2;  // the error is half an angle
      const double delta[] = {0, 0, 0, 0, 0, options_.noise * kDeviation * random().normal()};
      const double weight = 1 / (kDeviation * kDeviation);
      simulator_.measure_pose(OffsetPrior<SE3>(Manifold<SE3>::oplus(pose, delta)),
                              Information::diagonal(std::array{0.0, 0.0, 0.0, 0.0, 0.0, weight}), center_);
    }
    if (has_sensor(kGps)) {
      const Vector3 deviations(0.3, 0.3, 0.3);
      simulator_.measure_pose(
          PositionPrior(noisy<3>(pose.translation(), deviations, options_.noise, random())),
          Information(1 / (deviations[0] * deviations[0])), center_);
    }
  }

  void see_points(const SE3& pose, const Vector2& place) {
    const Vector3 deviations(0.05, 0.05, 0.05);
    cells_.around(place, Reach::kRange, [&](int index) {
      const Vector3 in_body = pose.inverse_times(points_.truth(index));
      if (!Reach::has(in_body) || in_body.norm() > Reach::kRange) return;
      const Vector3 z = noisy<3>(mounting().inverse_times(in_body), deviations, options_.noise, random());
      simulator_.observe(points_, index, OffsetPointObservation3(z), deviations,
                         Vector3(simulator_.last_guess() * (mounting() * z)), point_sensor_);
    });
  }

  template <class E>
  void see_images(const SE3& pose, const Vector2& place) {
    constexpr bool kInverse = std::is_same_v<E, DisparityImage>;
    const Vector3 deviations(1, 1, kInverse ? 0.005 : 0.05);
    cells_.around(place, MountedCamera::kFarthest, [&](int index) {
      Vector3 image = MountedCamera::image(pose.inverse_times(points_.truth(index)));
      if (!MountedCamera::sees(image)) return;
      if (kInverse) image[2] = 1 / image[2];
      const Vector3 z = noisy<3>(image, deviations, options_.noise, random());
      Vector3 with_depth = z;
      if (kInverse) with_depth[2] = 1 / std::max(z[2], 0.5 / MountedCamera::kFarthest);
      simulator_.observe(points_, index, E(z), deviations,
                         Vector3(simulator_.last_guess() * MountedCamera::point(with_depth)), camera_);
    });
  }

  /// The pose of the sensor of points on the robot.
  static const SE3& mounting() {
    static const SE3 pose(Vector3(0.2, 0.1, 0.3), turned(0.1, 0.2, -0.1).quaternion());
    return pose;
  }

  RandomNumbers& random() { return simulator_.random; }

  const SpaceRobotOptions& options_;
  RandomNumbers world_;
  Simulator<SE3> simulator_;
  GridWalk walk_;
  Landmarks<Vector3> points_;
  PlaneCells cells_{Reach::kRange};
  Revisits revisits_;
  Twin<SE3> point_sensor_, center_;
  Twin<MountedCamera::Camera> camera_;
};

}  // namespace

std::string_view to_string(SpaceSensor sensor) {
  constexpr std::array<std::string_view, kSpaceSensors.size()> kNames{"points", "depth",   "disparity",
                                                                      "poses",  "compass", "gps"};
  return kNames[static_cast<std::size_t>(sensor)];
}

Simulation simulate_robot(const SpaceRobotOptions& options) {
  check_robot(options);
  return SpaceRobot(options).run();
}

}  // namespace boxplus
