// SPDX-License-Identifier: BSD-3-Clause
// Measures the queries of Optimizer::covariance() after a run, in CPU time on one thread, relative to the
// time of an iteration of this run. Prints a table in Markdown.
//
//     covariance_bench FOLDER
//
// FOLDER contains the public graphs.
#include <cstdio>
#include <exception>
#include <random>
#include <string>
#include <vector>

#include "boxplus/boxplus.h"
#include "datasets/cpu_time.h"
#include "datasets/median.h"

namespace boxplus::bench {
namespace {

template <class F>
double seconds_of(F&& f) {
  const double begin = cpu_seconds();
  f();
  return cpu_seconds() - begin;
}

/// The times of each repetition, in seconds.
struct Times {
  std::vector<double> iteration, first, further, marginals, without_optimizer;
};

void measure(Graph& graph, std::mt19937& random, Times& times) {
  std::vector<double> ends;
  Options options;
  options.threads = 1;
  options.callback = [&](const IterationRecord&) {
    ends.push_back(cpu_seconds());
    return true;
  };
  const std::vector<VertexRef> all = graph.all_vertices();
  const auto three = [&] {
    std::vector<VertexRef> vertices;
    for (int k = 0; k < 3; ++k) vertices.push_back(all[random() % all.size()]);
    return vertices;
  };
  for (const bool asks_for_all : {false, true}) {
    graph.push();
    ends.clear();
    Optimizer optimizer(graph, options);
    (void)optimizer.run();
    for (std::size_t k = 1; k < ends.size(); ++k) times.iteration.push_back(ends[k] - ends[k - 1]);
    if (asks_for_all) {
      times.marginals.push_back(seconds_of([&] { (void)optimizer.marginal_covariances(all); }));
    } else {
      times.first.push_back(seconds_of([&] { (void)optimizer.covariance(three()); }));
      for (int k = 0; k < 10; ++k)
        times.further.push_back(seconds_of([&] { (void)optimizer.covariance(three()); }));
      times.without_optimizer.push_back(seconds_of([&] { (void)covariance(graph, three(), options); }));
    }
    graph.pop();
  }
}

void print_row(const std::string& folder, const std::string& path) {
  GraphFile file = read_graph(folder + "/" + path);
  std::mt19937 random(1);
  Times times;
  for (int repetition = 0; repetition < 15; ++repetition) measure(file.graph, random, times);
  const double iteration = median(times.iteration);
  std::printf("| %s | %.1f | %.2f | %.3f | %.2f | %.2f |\n", path.substr(path.find('/') + 1).c_str(),
              1e3 * iteration, median(times.first) / iteration, median(times.further) / iteration,
              median(times.marginals) / iteration, median(times.without_optimizer) / iteration);
}

}  // namespace
}  // namespace boxplus::bench

int main(int count, char** words) try {
  if (count != 2) {
    std::fprintf(stderr, "usage: covariance_bench FOLDER\n");
    return 2;
  }
  std::printf(
      "\n## Covariances after a run\n\n"
      "CPU time on one thread. The columns after \"iteration\" are multiples of the time of an iteration:\n"
      "the joint covariance of three vertices, for the first time after a run and for further sets; all\n"
      "marginal covariances, for the first time after a run; and the joint covariance of three vertices\n"
      "without the optimizer.\n\n"
      "| graph | iteration [ms] | three vertices | three others | all marginals | without optimizer |\n"
      "|---|--:|--:|--:|--:|--:|\n");
  for (const char* path : {"posegraph2d/w10000.graph", "posegraph2d/city10000.g2o"})
    boxplus::bench::print_row(words[1], path);
} catch (const std::exception& error) {
  std::fprintf(stderr, "covariance_bench: %s\n", error.what());
  return 1;
}
