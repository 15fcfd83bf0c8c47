// SPDX-License-Identifier: BSD-3-Clause
// whole_boxplus FILE OUTPUT: does the same as `boxplus optimize FILE -o OUTPUT --threads 1`.
#include <fmt/core.h>

#include <exception>

#include "base/stopwatch.h"
#include "boxplus/io/graph_file.h"
#include "boxplus/optimize/optimizer.h"
#include "datasets/whole_run.h"

using namespace boxplus;

int main(int count, char** words) try {
  const Stopwatch clock;
  if (count != 3) throw InvalidArgument("expected FILE OUTPUT");
  ReadOptions reading;
  reading.threads = 1;
  GraphFile file = read_graph(words[1], reading);
  const Report report = optimize(file.graph, {.start = Start::kAutomatic, .threads = 1});
  write_graph(words[2], file);
  bench::print_whole_run(clock.seconds(), report.chi2_final);
  return 0;
} catch (const std::exception& error) {
  fmt::print(stderr, "whole_boxplus: {}\n", error.what());
  return 1;
}
