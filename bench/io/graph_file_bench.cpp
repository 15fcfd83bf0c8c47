// SPDX-License-Identifier: BSD-3-Clause
// Measures how fast boxplus reads and writes a file of 200 MB with a simulated graph. For comparison, also
// measures a simple reader that uses std::istream.
#include <benchmark/benchmark.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "boxplus/io/graph_file.h"
#include "boxplus/testing/simulate.h"
#include "boxplus/types/slam3d.h"

namespace boxplus {
namespace {

/// A graph and its file. The constructor writes the file, and the destructor removes it.
class LargeFile {
 public:
  LargeFile() {
    Simulation simulation = simulate(World::kGrid, {.poses = 216000});
    file_.graph = std::move(simulation.graph);
    file_.edges = std::move(simulation.edges);
    write_graph(path_, file_);
    size_ = std::filesystem::file_size(path_);
  }
  ~LargeFile() {
    std::filesystem::remove(path_);
    std::filesystem::remove(output());
  }
  const std::string& path() const { return path_; }
  std::string output() const { return path_ + ".out"; }
  const GraphFile& file() const { return file_; }
  std::int64_t size() const { return static_cast<std::int64_t>(size_); }

 private:
  std::string path_ = (std::filesystem::temp_directory_path() / "boxplus_bench.g2o").string();
  GraphFile file_;
  std::uintmax_t size_ = 0;
};

const LargeFile& large_file() {
  static const LargeFile file;
  return file;
}

SE3 read_pose(std::istream& in) {
  Vector3 t;
  detail::Quaternion<double> q{};
  in >> t[0] >> t[1] >> t[2] >> q.x >> q.y >> q.z >> q.w;
  return {t, q};
}

/// A simple reader: std::getline(), a std::istringstream for each line, and >> for each field.
Graph read_with_istream(const std::string& path) {
  Graph graph;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    std::istringstream in(line);
    std::string word;
    in >> word;
    if (word == "VERTEX_SE3:QUAT") {
      Id id = 0;
      in >> id;
      graph.add_vertex(read_pose(in), id);
    } else if (word == "EDGE_SE3:QUAT") {
      Id from = 0, to = 0;
      in >> from >> to;
      const Between<SE3> edge(read_pose(in));
      Eigen::Matrix<double, 6, 6> information;
      for (int i = 0; i < 6; ++i) {
        for (int j = i; j < 6; ++j) {
          in >> information(i, j);
          information(j, i) = information(i, j);
        }
      }
      graph.add_edge(edge, information, graph.vertex<SE3>(from), graph.vertex<SE3>(to));
    }
  }
  return graph;
}

void Read(benchmark::State& state) {
  ReadOptions options;
  options.threads = static_cast<int>(state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(read_graph(large_file().path(), options));
  state.SetBytesProcessed(state.iterations() * large_file().size());
}

void ReadWithIstream(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(read_with_istream(large_file().path()));
  state.SetBytesProcessed(state.iterations() * large_file().size());
}

void Write(benchmark::State& state) {
  for (auto _ : state) write_graph(large_file().output(), large_file().file());
  state.SetBytesProcessed(state.iterations() * large_file().size());
}

const auto settings = [](benchmark::internal::Benchmark* bench) {
  bench->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(1)->Repetitions(5)->ReportAggregatesOnly();
};
BENCHMARK(Read)->Arg(1)->Arg(2)->Apply(settings);
BENCHMARK(ReadWithIstream)->Apply(settings);
BENCHMARK(Write)->Apply(settings);

}  // namespace
}  // namespace boxplus
