// SPDX-License-Identifier: BSD-3-Clause
// g2o_online: optimizes a graph that arrives on standard input, in the protocol of protocol/protocol.h, and
// answers with the current estimates.
//
// Exit codes: 0 success, 1 an argument or standard output, 2 malformed input.
#include "common/program.h"
#include "growing/growing_run.h"

namespace boxplus::programs {
namespace {

int run(int argc, char** argv) {
  GrowingOptions options;
  Arguments arguments("g2o_online: optimizes a graph that arrives on standard input.");
  declare(arguments, options);
  arguments.flag("pcg", options.solver.pcg, "conjugate gradients instead of a factorization");
  arguments.parse(argc, argv);
  Graph graph;
  GrowingRun run(graph, options);
  serve_protocol(graph, run);
  run.finish();
  return kSuccess;
}

}  // namespace
}  // namespace boxplus::programs

int main(int argc, char** argv) {
  return boxplus::programs::run_program("g2o_online", [&] { return boxplus::programs::run(argc, argv); });
}
