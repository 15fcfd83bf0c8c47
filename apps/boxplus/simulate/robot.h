// SPDX-License-Identifier: BSD-3-Clause
// boxplus simulate robot2d|robot3d -o FILE: simulates a robot with sensors of choice.
#pragma once

#include <string>
#include <vector>

#include "boxplus/testing/simulate.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace boxplus::app {

struct RobotArguments {
  std::vector<std::string> sensors = {"points"};
  double world_size = 25;
  int landmarks = 100;
};

/// Adds the options that only the worlds of robots have, and returns them.
std::vector<CLI::Option*> add_robot_options(CLI::App& command, RobotArguments& arguments);

/// Throws InvalidArgument for a sensor that the robot does not have; the message lists its sensors.
Simulation simulate_robot_world(bool in_space, const RobotArguments& arguments,
                                const SimulationOptions& options);

}  // namespace boxplus::app
