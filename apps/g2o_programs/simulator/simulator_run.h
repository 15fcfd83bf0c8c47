// SPDX-License-Identifier: BSD-3-Clause
// What the simulators share: switches, and the files that they write.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>

#include "boxplus/base/error.h"
#include "boxplus/testing/simulate.h"
#include "common/arguments.h"
#include "common/program.h"

namespace boxplus::programs {

/// The files that a simulator writes, and its seed.
struct SimulatorOutputs {
  std::string graph = {}, truth = {};
  int seed = 1;
};

/// Declares -seed and -truth.
void declare(Arguments& arguments, SimulatorOutputs& outputs);
/// Throws the FileError that write() would throw, as far as this can be checked without writing.
void require_outputs(const SimulatorOutputs& outputs);
/// Writes the graph, and the truth if it is wanted, and prints the sizes and chi2.
void write(Simulation simulation, const SimulatorOutputs& outputs);

template <class Sensor>
struct SensorSwitch {
  const char* name;
  Sensor sensor;
  const char* text;
};

/// Declares the switches of all robots, reads the command line, simulates and writes. `options` has its own
/// switches already.
template <class Options, class Sensor, std::size_t N>
int run_simulator(Arguments& arguments, Options& options, const std::array<SensorSwitch<Sensor>, N>& switches,
                  int argc, char** argv) {
  constexpr int kMost = 10'000'000;
  SimulatorOutputs outputs{.graph = "simulator_out.g2o"};
  std::array<bool, N> chosen{};
  arguments.count("simSteps", options.poses, 2, kMost, "the number of poses");
  arguments.number("worldSize", options.world_size, 4, 1e6, "the side of the square world in meters");
  arguments.flag("hasOdom", options.has_odometry, "odometry between successive poses");
  for (std::size_t k = 0; k < N; ++k) arguments.flag(switches[k].name, chosen[k], switches[k].text);
  declare(arguments, outputs);
  arguments.positional("graph-output", outputs.graph,
                       "the file to write (default: simulator_out.g2o); - is standard output");
  arguments.parse(argc, argv);
  for (std::size_t k = 0; k < N; ++k) {
    if (chosen[k]) options.sensors.push_back(switches[k].sensor);
  }
  if (!options.has_odometry && options.sensors.empty())
    throw InvalidArgument("expected at least one sensor (-hasOdom, …), got none; see -help");
  options.seed = static_cast<std::uint64_t>(outputs.seed);
  require_outputs(outputs);
  write(simulate_robot(options), outputs);
  return kSuccess;
}

}  // namespace boxplus::programs
