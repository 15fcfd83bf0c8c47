// SPDX-License-Identifier: BSD-3-Clause
// g2o_simulator2d: simulates a robot in the plane. Exit codes: 0 success, 1 an argument or a file.
#include "boxplus/testing/simulate_robot.h"
#include "simulator/simulator_run.h"

namespace boxplus::programs {
namespace {

constexpr std::array kSwitches{
    SensorSwitch<PlaneSensor>{"hasPointSensor", PlaneSensor::kPoints, "positions of landmarks (EDGE_SE2_XY)"},
    SensorSwitch<PlaneSensor>{"hasPointBearingSensor", PlaneSensor::kBearings,
                              "directions of landmarks (EDGE_BEARING_SE2_XY)"},
    SensorSwitch<PlaneSensor>{"hasPoseSensor", PlaneSensor::kPoses, "poses at earlier visits (EDGE_SE2)"},
    SensorSwitch<PlaneSensor>{"hasCompass", PlaneSensor::kCompass, "headings (EDGE_PRIOR_SE2)"},
    SensorSwitch<PlaneSensor>{"hasGPS", PlaneSensor::kGps, "positions of the robot (EDGE_PRIOR_SE2_XY)"},
    SensorSwitch<PlaneSensor>{"hasSegmentSensor", PlaneSensor::kSegments,
                              "segments, also in part (EDGE_SE2_SEGMENT2D, …_POINTLINE, …_LINE)"}};

int run(int argc, char** argv) {
  constexpr int kMost = 10'000'000;
  PlaneRobotOptions options{.has_odometry = false};
  Arguments arguments("g2o_simulator2d: simulates a robot in the plane.");
  arguments.count("nlandmarks", options.landmarks, 0, kMost, "the number of landmarks");
  arguments.count("nSegments", options.segments, 0, kMost, "the number of segments");
  arguments.count("segmentGridSize", options.segment_grid, 1, kMost,
                  "segments begin at whole meters, at most this far from the center");
  arguments.number("minSegmentLength", options.min_segment_length, 1e-3, 1e3, "in meters");
  arguments.number("maxSegmentLength", options.max_segment_length, 1e-3, 1e3, "in meters");
  return run_simulator(arguments, options, kSwitches, argc, argv);
}

}  // namespace
}  // namespace boxplus::programs

int main(int argc, char** argv) {
  return boxplus::programs::run_program("g2o_simulator2d",
                                        [&] { return boxplus::programs::run(argc, argv); });
}
