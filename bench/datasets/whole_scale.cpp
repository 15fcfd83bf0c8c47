// SPDX-License-Identifier: BSD-3-Clause
// whole_scale FILE OUTPUT: loads the file, runs five iterations from its estimates, and writes the result.
// All of this uses one thread. Then prints the numbers of ScaleFigures.
#include <fmt/core.h>

#include <exception>

#include "base/stopwatch.h"
#include "boxplus/io/graph_file.h"
#include "boxplus/optimize/optimizer.h"
#include "datasets/median_iteration.h"
#include "datasets/whole_run.h"

using namespace boxplus;

int main(int count, char** words) try {
  const Stopwatch clock;
  if (count != 3) throw InvalidArgument("expected FILE OUTPUT");
  ReadOptions reading;
  reading.threads = 1;
  GraphFile file = read_graph(words[1], reading);
  const double load_s = clock.seconds();
  const Report report = optimize(file.graph, {.max_iterations = 5, .threads = 1});
  const Stopwatch write_clock;
  write_graph(words[2], file);
  const double write_s = write_clock.seconds();
  fmt::print("{} {} {} {} {} {} {} {} {} {} {} {}\n", report.vertices, report.edges, load_s,
             report.time.plan_s, write_s, clock.seconds(), bench::median_iteration(report), bench::peak_mib(),
             report.linear.factor_seconds, report.linear.pcg_seconds,
             static_cast<double>(report.linear.refused_factor_bytes) * 1e-9, report.linear_solver);
  return 0;
} catch (const std::exception& error) {
  fmt::print(stderr, "whole_scale: {}\n", error.what());
  return 1;
}
