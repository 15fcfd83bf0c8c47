// SPDX-License-Identifier: BSD-3-Clause
#include "bundle/bundle_problem.h"

#include <fstream>
#include <stdexcept>

namespace boxplus::bench {

BundleProblem read_bundle_problem(const std::string& path) {
  std::ifstream file(path);
  std::size_t cameras = 0, points = 0, observations = 0;
  file >> cameras >> points >> observations;
  if (!file) throw std::runtime_error(path + ": expected the three counts of a BAL file");
  BundleProblem problem;
  for (std::size_t k = 0; k < observations && file; ++k) {
    BundleProblem::Observation seen{};
    file >> seen.camera >> seen.point >> seen.x >> seen.y;
    problem.observations.push_back(seen);
  }
  const auto read_all = [&file](std::size_t count, auto& to) {
    for (std::size_t k = 0; k < count && file; ++k) {
      for (double& value : to.emplace_back()) file >> value;
    }
  };
  read_all(cameras, problem.cameras);
  read_all(points, problem.points);
  if (!file) throw std::runtime_error(path + ": the file ends before its last point");
  return problem;
}

}  // namespace boxplus::bench
