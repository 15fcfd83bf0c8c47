// SPDX-License-Identifier: BSD-3-Clause
// create_sphere: simulates poses on a sphere, in laps from pole to pole. Exit codes: 0 success, 1 an argument
// or a file.
#include <random>

#include "boxplus/testing/simulate_robot.h"
#include "simulator/simulator_run.h"

namespace boxplus::programs {
namespace {

std::vector<double> entries(const Vector3& v) {
  return {v[0], v[1], v[2]};
}

Vector3 vector_of(const std::vector<double>& entries) {
  return {entries[0], entries[1], entries[2]};
}

int run(int argc, char** argv) {
  constexpr int kMost = 10'000;
  SphereOptions options;
  SimulatorOutputs outputs{.graph = "-"};
  std::vector<double> translation = entries(options.translation_noise),
                      rotation = entries(options.rotation_noise);
  bool random_seed = false;
  Arguments arguments("create_sphere: simulates poses on a sphere, in laps from pole to pole.");
  arguments.text("o", outputs.graph, "the file to write; - is standard output");
  arguments.count("nodesPerLevel", options.poses_per_lap, 2, kMost, "the number of poses in a lap");
  arguments.count("laps", options.laps, 1, kMost, "the number of laps");
  arguments.number("radius", options.radius, 1e-6, 1e9, "the radius of the sphere in meters");
  arguments.numbers("noiseTranslation", translation, 1e-12, 1e9,
                    "standard deviations of x, y and z in meters: a;b;c");
  arguments.numbers("noiseRotation", rotation, 1e-12, 1,
                    "standard deviations of the vector part of the quaternion: a;b;c");
  arguments.flag("randomSeed", random_seed, "a new seed in every run");
  declare(arguments, outputs);
  arguments.parse(argc, argv);
  options.translation_noise = vector_of(translation);
  options.rotation_noise = vector_of(rotation);
  options.seed = random_seed ? std::random_device()() : static_cast<std::uint64_t>(outputs.seed);
  require_outputs(outputs);
  write(simulate_laps(options), outputs);
  return kSuccess;
}

}  // namespace
}  // namespace boxplus::programs

int main(int argc, char** argv) {
  return boxplus::programs::run_program("create_sphere", [&] { return boxplus::programs::run(argc, argv); });
}
