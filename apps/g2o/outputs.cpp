// SPDX-License-Identifier: BSD-3-Clause
#include "outputs.h"

#include <fstream>
#include <iostream>
#include <set>
#include <string>

#include "g2o/core/factory.h"

namespace g2o_tool {
namespace {

bool write_statistics(const g2o::SparseOptimizer& optimizer, const std::string& path) {
  std::ofstream out(path);
  for (const g2o::G2OBatchStatistics& statistics : optimizer.batchStatistics()) out << statistics << '\n';
  return out.good();
}

bool append_summary(const g2o::SparseOptimizer& optimizer, const Options& options, const Run& run) {
  const bool is_new = !std::ifstream(options.summary).good();
  std::ofstream out(options.summary, std::ios::app);
  size_t landmarks = 0;
  std::set<std::string> edge_types;
  const int largest = optimizer.maxDimension();
  for (const auto& [id, v] : optimizer.vertices())
    landmarks += static_cast<const g2o::OptimizableGraph::Vertex*>(v)->dimension() < largest;
  for (const g2o::HyperGraph::Edge* e : optimizer.edges())
    edge_types.insert(g2o::Factory::instance()->tag(e));
  std::string types;
  for (const std::string& type : edge_types) types += (types.empty() ? "" : " ") + type;
  if (is_new)
    out << "filename, n_vertices, n_edges, n_poses, n_landmarks, edge_types, load_chi, init_chi, final_chi, "
           "solver, "
           "robustKernel, maxIterations, realIterations\n";
  out << options.input << ", " << optimizer.vertices().size() << ", " << optimizer.edges().size() << ", "
      << optimizer.vertices().size() - landmarks << ", " << landmarks << ", " << types << ", "
      << run.chi2_loaded << ", " << run.chi2_initial << ", " << run.chi2_final << ", " << options.solver
      << ", " << options.robust_kernel << ", " << options.iterations << ", " << run.iterations << '\n';
  return out.good();
}

}  // namespace

bool write_outputs(g2o::SparseOptimizer& optimizer, const Options& options, const Run& run) {
  if (!options.statistics.empty() && !write_statistics(optimizer, options.statistics)) {
    std::cerr << "g2o: " << options.statistics << " cannot be written\n";
    return false;
  }
  if (!options.summary.empty() && !append_summary(optimizer, options, run)) {
    std::cerr << "g2o: " << options.summary << " cannot be written\n";
    return false;
  }
  if (options.output == "-") return optimizer.save(std::cout);
  return options.output.empty() || optimizer.save(options.output);
}

void print_marginals(g2o::SparseOptimizer& optimizer) {
  std::vector<std::pair<int, int>> indices;
  const auto count = static_cast<int>(optimizer.indexMapping().size());
  for (int i = 0; i < count; ++i) {
    indices.emplace_back(i, i);
    if (i + 1 < count) indices.emplace_back(i, i + 1);
  }
  g2o::SparseBlockMatrix<g2o::MatrixX> covariance;
  if (!optimizer.computeMarginals(covariance, indices)) {
    std::cerr << "g2o: the covariances cannot be computed\n";
    return;
  }
  for (const auto& [i, j] : indices) {
    const auto& mapping = optimizer.indexMapping();
    std::cerr << "Vertices " << mapping[static_cast<size_t>(i)]->id() << " "
              << mapping[static_cast<size_t>(j)]->id() << '\n'
              << *covariance.block(i, j) << '\n';
  }
}

}  // namespace g2o_tool
