// SPDX-License-Identifier: BSD-3-Clause
// graph_optimum FILE BEST [THREADS...]: checks that optimize() of FILE ends at a chi2 within 1e-6 of BEST. It
// replaces dataset_optimum.py in builds without the boxplus command. With several numbers of threads, each
// must give the same bytes. FILE is in the folder $BOXPLUS_DATA. If there is no such file, the exit code is
// 77.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "boxplus/io/graph_file.h"
#include "boxplus/optimize/optimizer.h"

namespace boxplus {
namespace {

constexpr double kTolerance = 1e-6;  // the largest relative difference from BEST
constexpr int kSkipped = 77;

/// Says whether the optimum of `file` is `best`. Its estimates are then those of the optimum.
bool reaches(double best, int threads, GraphFile& file) {
  Options options;
  options.start = Start::kAutomatic;  // as the command
  options.threads = threads;
  const Report report = optimize(file.graph, options);
  const double difference = (report.chi2_final - best) / best;
  std::printf("%d threads: chi2 %.10g, best known %.10g, relative difference %+.1e%s\n", threads,
              report.chi2_final, best, difference, report.converged() ? "" : ", not converged");
  return report.converged() && std::abs(difference) <= kTolerance;
}

int run(const std::string& path, double best, const std::vector<int>& numbers_of_threads) {
  if (!std::filesystem::is_regular_file(path)) {
    std::printf("SKIPPED: there is no file %s\n", path.c_str());
    return kSkipped;
  }
  std::string first;
  for (const int threads : numbers_of_threads) {
    GraphFile file = read_graph(path);
    if (!reaches(best, threads, file)) return 1;
    const std::string text = format_graph(file);
    if (first.empty()) first = text;
    if (text == first) continue;
    std::printf("FAILED: the bytes differ from those with %d threads\n", numbers_of_threads.front());
    return 1;
  }
  return 0;
}

}  // namespace
}  // namespace boxplus

int main(int argc, char** argv) {
  try {
    if (argc < 3) throw std::invalid_argument("expected FILE BEST [THREADS...]");
    const char* folder = std::getenv("BOXPLUS_DATA");
    std::vector<int> numbers_of_threads;
    for (int i = 3; i < argc; ++i) numbers_of_threads.push_back(std::stoi(argv[i]));
    if (numbers_of_threads.empty()) numbers_of_threads = {0};
    return boxplus::run(std::string(folder ? folder : "") + "/" + argv[1], std::stod(argv[2]),
                        numbers_of_threads);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "graph_optimum: %s\n", error.what());
    return 2;
  }
}
