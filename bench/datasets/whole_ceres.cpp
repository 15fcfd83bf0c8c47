// SPDX-License-Identifier: BSD-3-Clause
// whole_ceres FILE OUTPUT SETTINGS: optimizes like whole_boxplus, but with Ceres. The files are read and
// written by boxplus. SETTINGS is an index into all_ceres_settings().
#include <fmt/core.h>

#include <exception>

#include "base/stopwatch.h"
#include "boxplus/optimize/optimizer.h"
#include "datasets/ceres/ceres_peer.h"
#include "datasets/datasets.h"
#include "datasets/graph_numbers.h"
#include "datasets/open_blas.h"
#include "datasets/whole_run.h"

using namespace boxplus;
using namespace boxplus::bench;

int main(int count, char** words) try {
  const Stopwatch clock;
  require_open_blas_with_one_thread();
  if (count != 4) throw InvalidArgument("expected FILE OUTPUT SETTINGS");
  GraphFile file = read_anchored(words[1]);
  PlainGraph numbers = numbers_of(file.graph);
  CeresPeer peer(numbers, CeresPeer::Jacobians::kAnalytic);
  const CeresStop stop{.cost_tolerance = Options().cost_tolerance};
  const CeresRun run = peer.solve(all_ceres_settings()[std::stoul(words[3])], stop);
  numbers.poses = peer.poses();
  numbers.points = peer.points();
  set_estimates(file.graph, numbers);
  write_graph(words[2], file);
  print_whole_run(clock.seconds(), run.chi2_final);
  return 0;
} catch (const std::exception& error) {
  fmt::print(stderr, "whole_ceres: {}\n", error.what());
  return 1;
}
