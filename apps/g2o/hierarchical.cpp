// SPDX-License-Identifier: BSD-3-Clause
// g2o_hierarchical: optimizes a graph whose estimates are bad. The start that the engine finds takes the
// place of a hierarchy of condensed stars. The exit codes are those of main.cpp.
#include <iostream>

#include "engine_start.h"
#include "g2o/core/hyper_graph_action.h"
#include "g2o/stuff/logger.h"
#include "io/printable.h"
#include "iterate.h"
#include "outputs.h"
#include "plugins.h"
#include "session.h"

namespace g2o_tool {
namespace {

struct HierarchicalOptions {
  Options shared;
  EngineStartOptions start;
  int iterations = 100;
};

HierarchicalOptions read_hierarchical_options(int argc, char** argv) {
  HierarchicalOptions h;
  Options& o = h.shared;
  int star_iterations = 30;
  double threshold = -1, diameter = -1, huber_width = -1;
  std::string high_solver;
  g2o::CommandArgs args;
  args.setBanner("g2o_hierarchical: optimizes a graph of a .g2o file whose estimates are bad.");
  declare_shared(args, o);
  args.param("hi", h.start.iterations, 100, "the engine finds a start with at most n iterations");
  args.param("li", h.iterations, 100,
             "perform n iterations from the start; if negative, until the gain is small");
  args.param("guess", o.guess, false, "before the start: an initial guess along a spanning tree");
  args.param("debug", h.start.print_report, false, "print the report of the engine");
  args.param("update", o.update_every, 10, "with -guiout: draw after every n iterations");
  args.param("guiout", o.gui_output, false, "write commands for gnuplot to standard output");
  args.param("huberWidth", huber_width, -1., "use the robust kernel Huber with this width for all edges");
  args.param("solver", o.solver, "lm_var_cholmod", "the algorithm of -li; see -listSolvers");
  const char* const unused = "no effect: there are no stars";
  args.param("si", star_iterations, 30, unused);
  args.param("uThreshold", threshold, -1., unused);
  args.param("hierarchicalDiameter", diameter, -1., unused);
  args.param("hsolver", high_solver, "gn_var_cholmod", unused);
  parse(args, o, argc, argv);
  require(h.start.iterations >= 0, "hi", "0 or more");
  o.iterations = h.iterations;
  if (o.robust_kernel.empty() && huber_width > 0) {
    o.robust_kernel = "Huber";
    o.robust_kernel_width = huber_width;
  }
  h.start.robust_kernel = o.robust_kernel;
  h.start.robust_kernel_width = o.robust_kernel_width;
  for (const char* name : {"si", "uThreshold", "hierarchicalDiameter", "hsolver"}) {
    if (args.parsedParam(name)) std::cerr << "# -" << name << " has no effect: there are no stars\n";
  }
  return h;
}

/// Draws the graph after every Options::update_every iterations.
class Draw : public g2o::HyperGraphAction {
 public:
  explicit Draw(const Options& options) : options_(options) {}
  g2o::HyperGraphAction* operator()(const g2o::HyperGraph* graph, Parameters* parameters) override {
    const auto* step = dynamic_cast<const ParametersIteration*>(parameters);
    if (step != nullptr && step->iteration >= 0 && step->iteration % options_.update_every == 0)
      stream_gnuplot(*static_cast<const g2o::SparseOptimizer*>(graph));
    return this;
  }

 private:
  const Options& options_;
};

int run(const HierarchicalOptions& h) {
  g2o::SparseOptimizer optimizer;
  g2o::OptimizationAlgorithm* algorithm = nullptr;
  if (const std::optional<int> code = prepare(optimizer, h.shared, algorithm)) return *code;
  const auto start = [&] {
    if (h.shared.guess) optimizer.computeInitialGuess();
    start_with_engine(optimizer, h.start);
  };
  const Run run = optimize(optimizer, *algorithm, h.shared, start, [&](Run& sum) {
    Draw draw(h.shared);
    if (h.shared.gui_output) optimizer.addPostIterationAction(&draw);
    iterate(optimizer, h.shared, h.iterations, sum);
    optimizer.removePostIterationAction(&draw);
  });
  return write_outputs(optimizer, h.shared, run) ? 0 : 1;
}

}  // namespace
}  // namespace g2o_tool

int main(int argc, char** argv) {
  g2o::logging::setSink([](g2o::logging::Level, const std::string& text) {
    std::cerr << "g2o_hierarchical: " << boxplus::escaped(text) << '\n';
  });
  const g2o_tool::HierarchicalOptions options = g2o_tool::read_hierarchical_options(argc, argv);
  g2o_tool::load_type_libraries(options.shared.type_libraries, argv[0]);
  g2o_tool::load_solver_libraries(options.shared.solver_libraries, argv[0]);
  return g2o_tool::run(options);
}
