// SPDX-License-Identifier: BSD-3-Clause
// The command line tool that the g2o document describes: loads a graph, optimizes it, and saves it.
//
// Exit codes:
//   0  success; also if there is no input, or if the algorithm is unknown
//   1  a file cannot be opened or written
//   2  the file has unreadable lines or no vertices, or it does not contain a vertex that should be fixed
//   3  the algorithm does not support the dimensions of the vertices
#include <iostream>

#include "g2o/core/estimate_propagator.h"
#include "g2o/stuff/logger.h"
#include "incremental.h"
#include "io/printable.h"
#include "iterate.h"
#include "options.h"
#include "outputs.h"
#include "plugins.h"
#include "session.h"

namespace g2o_tool {
namespace {

void make_initial_guess(g2o::SparseOptimizer& optimizer, const Options& options) {
  if (options.guess_odometry) {
    g2o::EstimatePropagatorCostOdometry odometry(&optimizer);
    optimizer.computeInitialGuess(odometry);
  } else if (options.guess) {
    optimizer.computeInitialGuess();
  }
}

int run(const Options& options) {
  g2o::SparseOptimizer optimizer;
  g2o::OptimizationAlgorithm* algorithm = nullptr;
  if (const std::optional<int> code = prepare(optimizer, options, algorithm)) return *code;
  const auto start = [&] { make_initial_guess(optimizer, options); };
  const Run run = optimize(optimizer, *algorithm, options, start, [&](Run& sum) {
    if (options.incremental) {
      grow(optimizer, options, sum);
    } else {
      iterate(optimizer, options, options.iterations, sum);
    }
  });
  return write_outputs(optimizer, options, run) ? 0 : 1;
}

}  // namespace
}  // namespace g2o_tool

int main(int argc, char** argv) {
  g2o::logging::setSink([](g2o::logging::Level, const std::string& text) {
    std::cerr << "g2o: " << boxplus::escaped(text) << '\n';
  });
  const g2o_tool::Options options = g2o_tool::read_options(argc, argv);
  g2o_tool::load_type_libraries(options.type_libraries, argv[0]);
  g2o_tool::load_solver_libraries(options.solver_libraries, argv[0]);
  return g2o_tool::run(options);
}
