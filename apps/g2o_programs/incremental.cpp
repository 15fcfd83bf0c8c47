// SPDX-License-Identifier: BSD-3-Clause
// g2o_incremental: optimizes a graph while it grows. The graph comes from a file, step by step, or from
// standard input, in the protocol of protocol/protocol.h.
//
// Exit codes: 0 success, 1 an argument or a file, 2 malformed input.
#include <limits>

#include "common/program.h"
#include "files/interrupt.h"
#include "growing/graph_feed.h"
#include "growing/growing_run.h"

namespace boxplus::programs {
namespace {

struct IncrementalArguments {
  GrowingOptions growing{.solver = {.batch_every = 100}};
  std::string input, output;
};

IncrementalArguments read_arguments(int argc, char** argv) {
  IncrementalArguments a;
  Arguments arguments("g2o_incremental: optimizes a graph while it grows.");
  declare(arguments, a.growing);
  arguments.count("batch", a.growing.solver.batch_every, 0, std::numeric_limits<int>::max(),
                  "iterate until it converges after every n new vertices; 0: only at the end");
  arguments.text("i", a.input, "take the graph from this file, not in the protocol from standard input");
  arguments.text("o", a.output, "write the optimized graph to this file; - is standard output");
  arguments.parse(argc, argv);
  return a;
}

/// Feeds the graph step by step, and puts the result into it.
void grow(GraphFile& file, GrowingOptions options) {
  const app::Interrupt interrupt;  // ends an optimization, but the graph still grows and is written
  options.solver.stop = app::Interrupt::flag();
  Graph graph;
  GraphFeed feed(file.graph, file.edges.empty() ? file.graph.all_edges() : file.edges, graph);
  GrowingRun run(graph, options);
  while (feed.step()) run.solve();
  run.finish();
  feed.copy_estimates_to(file.graph);
}

int run(int argc, char** argv) {
  const IncrementalArguments arguments = read_arguments(argc, argv);
  require_output(arguments.output);
  GraphFile file;
  if (!arguments.input.empty()) {
    file = load_graph(arguments.input);
    grow(file, arguments.growing);
  } else {
    GrowingRun run(file.graph, arguments.growing);
    serve_protocol(file.graph, run);
    run.finish();
  }
  if (!arguments.output.empty()) save_graph(arguments.output, file);
  return kSuccess;
}

}  // namespace
}  // namespace boxplus::programs

int main(int argc, char** argv) {
  return boxplus::programs::run_program("g2o_incremental",
                                        [&] { return boxplus::programs::run(argc, argv); });
}
