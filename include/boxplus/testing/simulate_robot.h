// SPDX-License-Identifier: BSD-3-Clause
// Simulates a robot that moves through a square world, with the sensors of your choice.
//
// As in testing/simulate.h, the same options give the same graph on every computer, the covariances of the
// noise are the inverses of the information matrices, and the first pose is fixed at its true place. The
// world does not depend on the sensors, and the initial estimates come from the odometry.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "boxplus/testing/simulate.h"

namespace boxplus {

/// The sensors of a robot in the plane, besides its odometry. They reach 5 m far and 135° to each side.
/// Standard deviations are given per row of the error.
enum class PlaneSensor : std::uint8_t {
  kPoints,    ///< PointObservation2 (0.05 m) of landmarks
  kBearings,  ///< BearingObservation2 (0.01 rad) of landmarks; those that are seen from several directions
  kPoses,     ///< Between<SE2> (0.05 m, 0.01 rad) to poses at earlier visits
  kCompass,   ///< Prior<SE2> that weights only the heading (0.02 rad)
  kGps,       ///< PositionPrior<Vector2> (0.3 m)
  kSegments   ///< SegmentObservation2 (0.05 m) of segments; if they are only partly in reach,
              ///< SegmentEndObservation2 (0.05 m, 0.02 rad) or SegmentLineObservation2 (0.02 rad, 0.05 m)
};
inline constexpr std::array kPlaneSensors{PlaneSensor::kPoints, PlaneSensor::kBearings,
                                          PlaneSensor::kPoses,  PlaneSensor::kCompass,
                                          PlaneSensor::kGps,    PlaneSensor::kSegments};
std::string_view to_string(PlaneSensor sensor);

/// The sensors of a robot in space, besides its odometry. They are mounted on the robot; each has a
/// parameter.
enum class SpaceSensor : std::uint8_t {
  kPoints,           ///< OffsetPointObservation3 (0.05 m) of landmarks within 5 m, up to 135° to each side
  kDepthImages,      ///< DepthImage (1 pixel, 0.05 m) of landmarks at 1 to 8 m in front of a camera
  kDisparityImages,  ///< DisparityImage (1 pixel, 0.005 / m) of the same landmarks
  kPoses,            ///< Between<SE3> (0.02 m, 0.003 rad) to poses at earlier visits
  kCompass,          ///< OffsetPrior<SE3> that weights only the rotation about the vertical axis of the robot
                     ///< (0.02 rad)
  kGps               ///< PositionPrior<Vector3> (0.3 m)
};
inline constexpr std::array kSpaceSensors{SpaceSensor::kPoints,          SpaceSensor::kDepthImages,
                                          SpaceSensor::kDisparityImages, SpaceSensor::kPoses,
                                          SpaceSensor::kCompass,         SpaceSensor::kGps};
std::string_view to_string(SpaceSensor sensor);

struct PlaneRobotOptions {
  int poses = 100;         ///< from one to the next, the robot goes 1 m straight on, or turns by 90°
  double world_size = 25;  ///< the side of the square in which the robot and the landmarks are
  bool has_odometry =
      true;  ///< whether the graph has its edges (0.05 m, 0.01 rad); the estimates come from it
  std::vector<PlaneSensor> sensors = {};
  int landmarks = 100;
  /// Segments are parallel to an axis, and begin at whole meters, at most `segment_grid` from the center.
  int segments = 1000;
  int segment_grid = 50;
  double min_segment_length = 0.5, max_segment_length = 3;
  std::uint64_t seed = 1;
  double noise = 1;  ///< a factor on all standard deviations; 0: exact measurements, weighted as for factor 1
  /// The fraction of observed landmarks, segments and earlier poses that are mistaken for others.
  double outliers = 0;
};

struct SpaceRobotOptions {
  int poses = 100;           ///< as in the plane, but the robot also sways
  double world_size = 25;    ///< the side of the square; landmarks are up to 4 m above or below the robot
  bool has_odometry = true;  ///< whether the graph has its edges (0.02 m, 0.003 rad)
  std::vector<SpaceSensor> sensors = {};
  int landmarks = 1000;
  std::uint64_t seed = 1;
  double noise = 1, outliers = 0;  ///< as in the plane
};

/// Take time and memory in proportion to the number of measurements. Throw InvalidArgument for fewer than 2
/// poses, a world smaller than 4 m, negative numbers, a segment grid below 1, a minimal length of 0 or above
/// the maximal one, a fraction of outliers outside [0, 1],
/// and values that are not finite.
Simulation simulate_robot(const PlaneRobotOptions& options);
Simulation simulate_robot(const SpaceRobotOptions& options);

/// Poses on a sphere that look outward, in laps from pole to pole.
struct SphereOptions {
  int laps = 50, poses_per_lap = 50;
  double radius = 100;  ///< meters
  /// Standard deviations of the rows of the error of Between<SE3>: per axis in meters, and of the vector part
  /// of the quaternion, which is half an angle.
  Vector3 translation_noise = Vector3(0.01, 0.01, 0.01), rotation_noise = Vector3(0.005, 0.005, 0.005);
  std::uint64_t seed = 1;
};
/// Each pose has odometry, and loop closures to the nearest pose of the previous lap and to the neighbors of
/// this pose. Throws InvalidArgument for less than one lap, fewer than two poses per lap, and numbers that
/// are not positive.
Simulation simulate_laps(const SphereOptions& options = {});

}  // namespace boxplus
