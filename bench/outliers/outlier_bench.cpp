// SPDX-License-Identifier: BSD-3-Clause
// Measures find_outliers() on public pose graphs with false loop closures, in CPU time on one thread. Prints
// a table in Markdown.
//
//     outlier_bench FOLDER [GRAPH]
//
// FOLDER contains the public graphs. With GRAPH, measures only the graphs whose path contains it.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "base/align_points.h"
#include "boxplus/boxplus.h"
#include "boxplus/outliers/outliers.h"
#include "boxplus/testing/false_closures.h"
#include "datasets/cpu_time.h"
#include "datasets/median.h"

namespace boxplus::bench {
namespace {

constexpr int kSeeds = 5;

template <class F>
double seconds_of(F&& f) {
  const double begin = cpu_seconds();
  f();
  return cpu_seconds() - begin;
}

OutlierOptions on_one_thread() {
  OutlierOptions options;
  options.options.threads = 1;
  return options;
}

/// The positions of all poses, one per column.
Eigen::MatrixXd positions(const Graph& graph) {
  std::vector<detail::Frame> frames;
  for (const VertexRef& vertex : graph.all_vertices()) {
    detail::Frame frame;
    if (graph.vertex_pools()[vertex.pool]->get_frame(vertex.slot, frame)) frames.push_back(frame);
  }
  const int rows = frames.empty() ? 2 : frames[0].dimension;
  Eigen::MatrixXd points(rows, static_cast<Eigen::Index>(frames.size()));
  for (Eigen::Index k = 0; k < points.cols(); ++k) {
    for (int i = 0; i < rows; ++i)
      points(i, k) = frames[static_cast<std::size_t>(k)].translation[static_cast<std::size_t>(i)];
  }
  return points;
}

/// The root mean square distance after the best rigid motion, as a fraction of the longest side of the map.
double displacement(const Eigen::MatrixXd& map, const Eigen::MatrixXd& truth) {
  const PointAlignment motion = align_points(map, truth, false);
  const Eigen::MatrixXd moved = (motion.rotation * map).colwise() + motion.translation;
  const double extent = (truth.rowwise().maxCoeff() - truth.rowwise().minCoeff()).maxCoeff();
  return std::sqrt((moved - truth).squaredNorm() / static_cast<double>(map.cols())) / extent;
}

/// What is known about the runs of one row.
struct Row {
  std::vector<double> displacements, ratios;
  double precision = 1, recall = 1;  // the lowest
  int deceptions = 0;                // "converged", and a false closure takes part
};

void judge(const OutlierReport& report, const std::vector<EdgeRef>& false_edges, Row& row) {
  const auto is_false = [&](EdgeRef edge) {
    return std::find(false_edges.begin(), false_edges.end(), edge) != false_edges.end();
  };
  double accused = 0, caught = 0, believed = 0;
  for (const EdgeVerdict& each : report.verdicts) {
    const bool lies = is_false(each.edge);
    accused += each.verdict == Verdict::kOutlier;
    caught += lies && each.verdict == Verdict::kOutlier;
    believed += lies && each.verdict == Verdict::kInlier;
  }
  if (accused > 0) row.precision = std::min(row.precision, caught / accused);
  if (!false_edges.empty())
    row.recall = std::min(row.recall, caught / static_cast<double>(false_edges.size()));
  row.deceptions += report.report.converged() && believed > 0.01 * static_cast<double>(false_edges.size());
}

void print_row(const std::string& name, const char* closures, const Row& row) {
  std::vector<double> sorted = row.displacements;
  std::sort(sorted.begin(), sorted.end());
  const auto good = std::count_if(sorted.begin(), sorted.end(), [](double d) { return d <= 0.002; });
  std::printf("| %s | %s | %.4f | %d of %zu | %.4f | %.4f | %.1f | %.1f | %d |\n", name.c_str(), closures,
              100 * sorted.back(), static_cast<int>(good), sorted.size(), row.precision, row.recall,
              median(row.ratios), *std::max_element(row.ratios.begin(), row.ratios.end()), row.deceptions);
  std::fflush(stdout);
}

void print_rows(const std::string& folder, const std::string& path) {
  const Graph graph = read_graph(folder + "/" + path).graph;
  Graph clean = graph;
  std::vector<double> clean_times;
  for (int k = 0; k < kSeeds; ++k) {
    clean = graph;
    clean.push();
    clean_times.push_back(
        seconds_of([&] { (void)optimize(clean, {.start = Start::kAutomatic, .threads = 1}); }));
  }
  const double clean_seconds = median(clean_times);
  const Eigen::MatrixXd truth = positions(clean);
  const std::string name = path.substr(path.find('/') + 1);

  const auto run = [&](Graph& dirty, const std::vector<EdgeRef>& false_edges, Row& row) {
    OutlierReport report;
    row.ratios.push_back(seconds_of([&] { report = find_outliers(dirty, on_one_thread()); }) / clean_seconds);
    row.displacements.push_back(displacement(positions(dirty), truth));
    judge(report, false_edges, row);
  };
  Row none;
  for (int k = 0; k < kSeeds; ++k) {
    Graph copy = graph;
    run(copy, {}, none);
  }
  print_row(name, "none", none);
  for (const int group : {1, 10}) {
    for (const double fraction : {0.1, 0.3, 0.5}) {
      Row row;
      for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
        Graph dirty = clean;  // at good estimates, which determine what is false
        const std::vector<EdgeRef> added =
            add_false_closures(dirty, {.fraction = fraction, .group = group, .seed = seed});
        dirty.pop();  // the estimates of the file
        run(dirty, added, row);
      }
      char closures[64];
      std::snprintf(closures, sizeof closures, "%.0f %%%s", 100 * fraction,
                    group > 1 ? ", groups of 10" : "");
      print_row(name, closures, row);
    }
  }
}

}  // namespace
}  // namespace boxplus::bench

int main(int count, char** words) try {
  if (count < 2 || count > 3) {
    std::fprintf(stderr, "usage: outlier_bench FOLDER [GRAPH]\n");
    return 2;
  }
  std::printf(
      "\n## False loop closures\n\n"
      "find_outliers() on public pose graphs with false closures between random poses, which are 10, 30 or\n"
      "50 %% of all closures, alone or in groups of up to ten that agree with each other; 5 seeds each. CPU\n"
      "time on one thread, as a multiple of a run without false closures. The displacement from the optimum\n"
      "without false closures is the root mean square over all poses, in percent of the longest side of the\n"
      "map. Precision and recall are the lowest of the seeds; an undecided false closure counts as missed.\n"
      "\"Deceived\" counts runs that converged although more than 1 %% of the false closures take part.\n\n"
      "| graph | false closures | displacement [%%] | at most 0.2 %% | precision | recall | time | largest | "
      "deceived |\n"
      "|---|---|--:|--:|--:|--:|--:|--:|--:|\n");
  for (const char* path : {"posegraph2d/intel_1728.g2o", "posegraph2d/M3500.g2o", "posegraph2d/csail.g2o",
                           "posegraph2d/city10000.g2o", "posegraph3d/sphere2500.g2o",
                           "posegraph3d/parking-garage.g2o", "posegraph3d/torus3D.g2o"}) {
    if (count == 2 || std::string(path).find(words[2]) != std::string::npos)
      boxplus::bench::print_rows(words[1], path);
  }
} catch (const std::exception& error) {
  std::fprintf(stderr, "outlier_bench: %s\n", error.what());
  return 1;
}
