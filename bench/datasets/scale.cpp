// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/scale.h"

#include <fmt/core.h>

#include <filesystem>
#include <sstream>
#include <stdexcept>

#include "boxplus/io/graph_file.h"
#include "datasets/whole_run.h"

namespace boxplus::bench {
namespace {

/// The path of a temporary file. The destructor removes the file.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::string& name)
      : path_(std::filesystem::temp_directory_path() / ("boxplus_bench_" + name)) {}
  ~TemporaryFile() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  std::string path() const { return path_; }

 private:
  std::filesystem::path path_;
};

ScaleFigures parse(const std::string& line) {
  std::istringstream in(line);
  ScaleFigures f;
  in >> f.vertices >> f.edges >> f.load_s >> f.plan_s >> f.write_s >> f.total_s >> f.iteration_s >>
      f.peak_mib >> f.predicted_factor_s >> f.predicted_pcg_s >> f.factor_gb >> f.solver;
  if (!in) throw std::runtime_error("whole_scale: cannot read '" + line + "'");
  return f;
}

}  // namespace

std::vector<ScaleResult> run_scale(const std::string& programs) {
  std::vector<ScaleResult> results;
  const auto run = [&](World world, int poses) {
    const std::string name(to_string(world));
    fmt::print(stderr, "{} of {} poses\n", name, poses);
    const TemporaryFile input(name + ".g2o"), output(name + "_out.g2o");
    write_graph(input.path(), simulate(world, {.poses = poses}).graph);
    const std::string line = output_of({programs + "/whole_scale", input.path(), output.path()});
    results.push_back({name, poses, parse(line)});
  };
  for (const int poses : {10'000, 100'000, 1'000'000}) run(World::kStreets, poses);
  for (const int poses : {10'000, 100'000}) run(World::kGrid, poses);
  return results;
}

}  // namespace boxplus::bench
