// SPDX-License-Identifier: BSD-3-Clause
#include "outputs.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <set>
#include <string>

#include "g2o/core/factory.h"
#include "g2o/core/hyper_graph_action.h"
#include "g2o/core/optimization_algorithm_with_hessian.h"
#include "io/printable.h"

namespace g2o_tool {
namespace {

bool write_statistics(const Run& run, const std::string& path) {
  std::ofstream out(path);
  for (const g2o::G2OBatchStatistics& statistics : run.statistics) out << statistics << '\n';
  return out.flush().good();
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
           "solver, robustKernel, maxIterations, realIterations\n";
  out << options.input << ", " << optimizer.vertices().size() << ", " << optimizer.edges().size() << ", "
      << optimizer.vertices().size() - landmarks << ", " << landmarks << ", " << types << ", "
      << run.chi2_loaded << ", " << run.chi2_initial << ", " << run.chi2_final << ", " << options.solver
      << ", " << options.robust_kernel << ", " << options.iterations << ", " << run.iterations << '\n';
  return out.flush().good();
}

/// Writes the elements for which `wanted` returns true. Uses the action "writeGnuplot" of their types.
template <class Elements, class Wanted>
void write_gnuplot(const Elements& elements, std::ostream& out, Wanted&& wanted) {
  auto* action = g2o::HyperGraphActionLibrary::instance()->actionByName("writeGnuplot");
  g2o::WriteGnuplotAction::Parameters parameters;
  parameters.os = &out;
  for (auto* element : elements)
    if (action != nullptr && wanted(*element)) (*action)(element, &parameters);
}
template <class Elements, class Wanted>
bool write_gnuplot(const Elements& elements, const std::string& path, Wanted&& wanted) {
  std::ofstream out(path);
  write_gnuplot(elements, out, wanted);
  return out.flush().good();
}

bool write_gnuplot(const g2o::SparseOptimizer& optimizer, const std::string& prefix) {
  std::vector<const g2o::OptimizableGraph::Vertex*> vertices;
  std::vector<const g2o::OptimizableGraph::Edge*> edges;
  for (const auto& [id, v] : optimizer.vertices())
    vertices.push_back(static_cast<const g2o::OptimizableGraph::Vertex*>(v));
  for (const g2o::HyperGraph::Edge* e : optimizer.edges())
    if (e->numUndefinedVertices() == 0) edges.push_back(static_cast<const g2o::OptimizableGraph::Edge*>(e));
  std::sort(vertices.begin(), vertices.end(), g2o::OptimizableGraph::VertexIDCompare());
  std::sort(edges.begin(), edges.end(), g2o::OptimizableGraph::EdgeIDCompare());
  const int largest = optimizer.maxDimension();
  const auto is_landmark = [&](const g2o::HyperGraph::Vertex* v) {
    return static_cast<const g2o::OptimizableGraph::Vertex*>(v)->dimension() < largest;
  };
  const auto sees_landmark = [&](const g2o::HyperGraph::Edge& e) {
    return std::any_of(e.vertices().begin(), e.vertices().end(), is_landmark);
  };
  const auto all = [](const auto&) { return true; };
  return write_gnuplot(vertices, prefix + "_vertices", all) && write_gnuplot(edges, prefix + "_edges", all) &&
         write_gnuplot(edges, prefix + "_landmarks_edges", sees_landmark) &&
         write_gnuplot(edges, prefix + "_odom_edges", [&](const g2o::HyperGraph::Edge& e) {
           return !sees_landmark(e) && e.vertices().size() == 2 &&
                  std::abs(e.vertex(0)->id() - e.vertex(1)->id()) == 1;
         });
}

bool save_graph(const g2o::SparseOptimizer& optimizer, const std::string& path) {
  if (path != "-") return optimizer.save(path.c_str());  // prints its own message
  if (optimizer.save(std::cout) && std::cout.flush()) return true;
  std::cerr << "g2o: the graph cannot be written to standard output\n";
  return false;
}

bool said_if_not(bool written, const std::string& path) {
  if (!written) std::cerr << "g2o: " << boxplus::escaped(path) << " cannot be written\n";
  return written;
}

}  // namespace

bool write_outputs(const g2o::SparseOptimizer& optimizer, const Options& options, const Run& run) {
  bool ok = options.output.empty() || save_graph(optimizer, options.output);
  if (!options.statistics.empty())
    ok = said_if_not(write_statistics(run, options.statistics), options.statistics) && ok;
  if (!options.gnuplot.empty())
    ok = said_if_not(write_gnuplot(optimizer, options.gnuplot), options.gnuplot) && ok;
  if (!options.summary.empty())
    ok = said_if_not(append_summary(optimizer, options, run), options.summary) && ok;
  return ok;
}

// Uses a 3-D plot if a vertex has more than three dimensions, because poses in the plane have three
// dimensions and poses in space have six.
void stream_gnuplot(const g2o::SparseOptimizer& optimizer) {
  const bool in_space = optimizer.maxDimension() > 3;
  std::cout << (in_space ? "set view equal xyz\nsplot" : "set size ratio -1\nplot")
            << " \"-\" with lines title \"" << optimizer.activeEdges().size() << " edges\"\n";
  write_gnuplot(optimizer.activeEdges(), std::cout, [](const auto&) { return true; });
  std::cout << "e\n" << std::flush;
}

void print_marginals(g2o::SparseOptimizer& optimizer, g2o::OptimizationAlgorithm& algorithm) {
  auto* newton = dynamic_cast<g2o::OptimizationAlgorithmWithHessian*>(&algorithm);
  bool ready = newton != nullptr && newton->init() && newton->buildLinearStructure();
  if (ready) newton->updateLinearSystem();
  std::vector<std::pair<int, int>> indices;
  const auto count = static_cast<int>(optimizer.indexMapping().size());
  for (int i = 0; i < count; ++i) {
    indices.emplace_back(i, i);
    if (i + 1 < count) indices.emplace_back(i, i + 1);
  }
  g2o::SparseBlockMatrix<g2o::MatrixX> covariance;
  ready = ready && optimizer.computeMarginals(covariance, indices);
  if (!ready) {
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
