// SPDX-License-Identifier: BSD-3-Clause
#include "session.h"

#include <fstream>
#include <iostream>

#include "g2o/core/factory.h"
#include "g2o/core/optimization_algorithm_factory.h"
#include "g2o/core/robust_kernel_factory.h"
#include "io/printable.h"
#include "outputs.h"
#include "prepare.h"

namespace g2o_tool {
namespace {

using boxplus::escaped;

void list(const Options& options) {
  if (options.list_types) g2o::Factory::instance()->printRegisteredTypes(std::cerr, true);
  if (options.list_solvers) {
    std::cerr << "# solvers:\n";
    g2o::OptimizationAlgorithmFactory::instance()->listSolvers(std::cerr);
  }
  if (options.list_kernels) {
    std::vector<std::string> kernels;
    g2o::RobustKernelFactory::instance()->fillKnownKernels(kernels);
    std::cerr << "# robust kernels:\n";
    for (const std::string& kernel : kernels) std::cerr << kernel << '\n';
  }
}

/// Returns 0, or the exit code of the failure.
int load(g2o::SparseOptimizer& optimizer, const Options& options) {
  optimizer.setRenamedTypesFromString(options.rename_types);
  std::ifstream file;
  if (options.input != "-") file.open(options.input);
  const bool unreadable = options.input != "-" && (!file || (file.peek(), file.bad()));  // bad(): a folder
  if (unreadable) {
    std::cerr << "g2o: " << escaped(options.input) << " cannot be opened\n";
    return 1;
  }
  if (!optimizer.load(options.input == "-" ? std::cin : file)) {
    std::cerr << "g2o: " << escaped(options.input) << " has lines that cannot be read\n";
    return 2;
  }
  if (optimizer.vertices().empty()) {
    std::cerr << "g2o: " << escaped(options.input) << " has no vertices\n";
    return 2;
  }
  std::cerr << "# loaded " << optimizer.vertices().size() << " vertices and " << optimizer.edges().size()
            << " edges\n";
  return 0;
}

}  // namespace

double chi2(g2o::SparseOptimizer& optimizer) {
  optimizer.computeActiveErrors();
  return optimizer.activeRobustChi2();
}

double chi2_of_all(g2o::SparseOptimizer& optimizer) {
  double sum = 0;
  for (g2o::HyperGraph::Edge* u : optimizer.edges()) {
    auto* e = static_cast<g2o::OptimizableGraph::Edge*>(u);
    if (e->numUndefinedVertices() > 0) continue;
    e->computeError();
    sum += e->chi2();
  }
  return sum;
}

std::optional<int> prepare(g2o::SparseOptimizer& optimizer, const Options& options,
                           g2o::OptimizationAlgorithm*& algorithm) {
  list(options);
  if (options.input.empty()) {
    std::cerr << "g2o: no input was given; see -help\n";
    return 0;
  }
  g2o::OptimizationAlgorithmProperty property;
  algorithm = g2o::OptimizationAlgorithmFactory::instance()->construct(options.solver, property);
  if (algorithm == nullptr) {
    std::cerr << "g2o: there is no solver " << escaped(options.solver)
              << "; -listSolvers lists the solvers, and -solverlib loads a plug-in with more solvers\n";
    return 0;
  }
  optimizer.setAlgorithm(algorithm);
  if (!options.solver_properties.empty() && !algorithm->updatePropertiesFromString(options.solver_properties))
    std::cerr << "g2o: could not set all of these properties: " << escaped(options.solver_properties) << '\n';
  if (options.print_solver_properties) algorithm->printProperties(std::cerr);
  if (const int code = load(optimizer, options); code != 0) return code;
  if (!optimizer.isSolverSuitable(property)) {
    std::cerr << "g2o: the solver " << options.solver << " does not support vertices of these dimensions:";
    for (const int dimension : optimizer.dimensions()) std::cerr << ' ' << dimension;
    std::cerr << '\n';
    return 3;
  }
  if (property.requiresMarginalize || options.marginalize) marginalize_landmarks(optimizer);
  if (!fix_gauge(optimizer, options)) return 2;
  warn_about_unconnected(optimizer);
  if (!options.robust_kernel.empty() && !add_robust_kernels(optimizer, options))
    std::cerr << "g2o: there is no robust kernel " << escaped(options.robust_kernel)
              << "; -listRobustKernels lists the kernels\n";
  return std::nullopt;
}

Run optimize(g2o::SparseOptimizer& optimizer, g2o::OptimizationAlgorithm& algorithm, const Options& options,
             const std::function<void()>& start, const std::function<void(Run&)>& iterations) {
  Run run;
  if (!optimizer.initializeOptimization()) {
    std::cerr << "# there is nothing to optimize: no edge has a free vertex\n";
    run.chi2_loaded = run.chi2_initial = run.chi2_final = chi2_of_all(optimizer);
    return run;
  }
  run.chi2_loaded = chi2(optimizer);
  stop_at_interrupts(optimizer);
  start();
  run.chi2_initial = chi2(optimizer);
  std::cerr << "# initial chi2 = " << run.chi2_initial << '\n';
  optimizer.setVerbose(options.verbose);
  optimizer.setComputeBatchStatistics(!options.statistics.empty());
  iterations(run);
  if (run.failures > 0) std::cerr << "# the algorithm failed; the result may not be a minimum\n";
  run.chi2_final = chi2(optimizer);
  std::cerr << "# final chi2 = " << run.chi2_final << '\n';
  if (options.compute_marginals) print_marginals(optimizer, algorithm);
  return run;
}

}  // namespace g2o_tool
