// SPDX-License-Identifier: BSD-3-Clause
#include "simulate/robot.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iterator>

#include "boxplus/base/error.h"
#include "boxplus/testing/simulate_robot.h"
#include "command_line/option_kinds.h"

namespace boxplus::app {
namespace {

constexpr const char* kRobotGroup = "Worlds robot2d and robot3d";

template <class Sensors>
typename Sensors::value_type sensor_of(const std::string& name, const Sensors& all) {
  std::vector<std::string_view> names;
  for (const auto sensor : all) {
    if (to_string(sensor) == name) return sensor;
    names.push_back(to_string(sensor));
  }
  throw InvalidArgument(
      fmt::format("--sensors: expected sensors of this robot ({}), got '{}'", fmt::join(names, ", "), name));
}

template <class Options, class Sensors>
Simulation simulated(Options robot, const Sensors& all, const RobotArguments& arguments,
                     const SimulationOptions& options) {
  for (const std::string& name : arguments.sensors) robot.sensors.push_back(sensor_of(name, all));
  robot.poses = options.poses;
  robot.world_size = arguments.world_size;
  robot.landmarks = arguments.landmarks;
  robot.seed = options.seed;
  robot.noise = options.noise;
  robot.outliers = options.outliers;
  return simulate_robot(robot);
}

}  // namespace

std::vector<CLI::Option*> add_robot_options(CLI::App& command, RobotArguments& arguments) {
  return {
      command.add_option("--sensors", arguments.sensors, "What the robot has besides odometry; see below")
          ->type_name("NAME,...")
          ->delimiter(',')
          ->default_str("points")
          ->group(kRobotGroup),
      command.add_option("--world-size", arguments.world_size, "The side of the square world in meters")
          ->type_name("X")
          ->check(number_within(4, 1e6))
          ->capture_default_str()
          ->group(kRobotGroup),
      command.add_option("--landmarks", arguments.landmarks, "The number of landmarks in the world")
          ->type_name("N")
          ->check(whole_number_within(0, 10'000'000))
          ->capture_default_str()
          ->group(kRobotGroup)};
}

Simulation simulate_robot_world(bool in_space, const RobotArguments& arguments,
                                const SimulationOptions& options) {
  if (in_space) return simulated(SpaceRobotOptions{}, kSpaceSensors, arguments, options);
  return simulated(PlaneRobotOptions{}, kPlaneSensors, arguments, options);
}

}  // namespace boxplus::app
