// SPDX-License-Identifier: BSD-3-Clause
// g2o_simulator3d: simulates a robot in space. Exit codes: 0 success, 1 an argument or a file.
#include "boxplus/testing/simulate_robot.h"
#include "simulator/simulator_run.h"

namespace boxplus::programs {
namespace {

constexpr std::array kSwitches{
    SensorSwitch<SpaceSensor>{"hasPointSensor", SpaceSensor::kPoints,
                              "positions of landmarks (EDGE_SE3_TRACKXYZ)"},
    SensorSwitch<SpaceSensor>{"hasPointDepthSensor", SpaceSensor::kDepthImages,
                              "pixels of landmarks with their depths (EDGE_PROJECT_DEPTH)"},
    SensorSwitch<SpaceSensor>{"hasPointDisparitySensor", SpaceSensor::kDisparityImages,
                              "pixels of landmarks with their inverse depths (EDGE_PROJECT_DISPARITY)"},
    SensorSwitch<SpaceSensor>{"hasPoseSensor", SpaceSensor::kPoses,
                              "poses at earlier visits (EDGE_SE3:QUAT)"},
    SensorSwitch<SpaceSensor>{"hasCompass", SpaceSensor::kCompass,
                              "rotations about the vertical axis (EDGE_SE3_PRIOR)"},
    SensorSwitch<SpaceSensor>{"hasGPS", SpaceSensor::kGps, "positions of the robot (EDGE_SE3_XYZ_PRIOR)"}};

int run(int argc, char** argv) {
  SpaceRobotOptions options{.has_odometry = false};
  Arguments arguments("g2o_simulator3d: simulates a robot in space.");
  arguments.count("nLandmarks", options.landmarks, 0, 10'000'000, "the number of landmarks");
  return run_simulator(arguments, options, kSwitches, argc, argv);
}

}  // namespace
}  // namespace boxplus::programs

int main(int argc, char** argv) {
  return boxplus::programs::run_program("g2o_simulator3d",
                                        [&] { return boxplus::programs::run(argc, argv); });
}
