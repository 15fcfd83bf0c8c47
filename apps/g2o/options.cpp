// SPDX-License-Identifier: BSD-3-Clause
#include "options.h"

#include <cstdlib>
#include <iostream>
#include <limits>

namespace g2o_tool {

void require(bool in_range, const char* name, const char* expected) {
  if (in_range) return;
  std::cerr << "parameter -" << name << ": expected " << expected << '\n';
  std::exit(EXIT_FAILURE);
}

std::vector<std::string> take_repeated(std::vector<std::string>& arguments, const std::string& name) {
  std::vector<std::string> values;
  for (size_t i = 1; i + 1 < arguments.size();) {
    if (arguments[i] != "-" + name && arguments[i] != "--" + name) {
      ++i;
      continue;
    }
    values.push_back(arguments[i + 1]);
    arguments.erase(arguments.begin() + static_cast<std::ptrdiff_t>(i),
                    arguments.begin() + static_cast<std::ptrdiff_t>(i) + 2);
  }
  return values;
}

void declare_shared(g2o::CommandArgs& args, Options& o) {
  args.param("v", o.verbose, false, "print a line per iteration");
  args.param("gnudump", o.gnuplot, "", "write files for gnuplot whose names begin with this text");
  args.param("robustKernel", o.robust_kernel, "", "use this robust kernel for all edges");
  args.param("robustKernelWidth", o.robust_kernel_width, -1., "the width of the robust kernel");
  args.param("computeMarginals", o.compute_marginals, false, "print the covariances of the vertices");
  args.param("o", o.output, "", "write the optimized graph to this file; - is standard output");
  args.param("solverlib", o.library, "", "load this library of algorithms; may be given several times");
  args.param("typeslib", o.library, "", "load this library of types; may be given several times");
  args.param("summary", o.summary, "", "append one line with the results of this run to this file");
  args.param("listTypes", o.list_types, false, "list the types that files can contain");
  args.param("listSolvers", o.list_solvers, false, "list the algorithms");
  args.param("listRobustKernels", o.list_kernels, false, "list the robust kernels");
  args.param("renameTypes", o.rename_types, "",
             "rename types: A=B,C=D reads lines of type A as B, and lines of type C as D");
  args.paramLeftOver("graph-input", o.input, "", "the file; - is standard input", true);
}

void parse(g2o::CommandArgs& args, Options& o, int argc, char** argv) {
  std::vector<std::string> arguments(argv, argv + argc);
  o.solver_libraries = take_repeated(arguments, "solverlib");
  o.type_libraries = take_repeated(arguments, "typeslib");
  std::vector<char*> rest;
  for (std::string& argument : arguments) rest.push_back(argument.data());
  args.parseArgs(static_cast<int>(rest.size()), rest.data());
  require(o.update_every > 0, "update", "1 or more");
}

Options read_options(int argc, char** argv) {
  Options o;
  g2o::CommandArgs args;
  args.setBanner("g2o: optimizes a graph of a .g2o file.");
  declare_shared(args, o);
  args.param("i", o.iterations, 5, "perform n iterations; if negative, iterate until the gain is small");
  args.param("gain", o.gain, 1e-6, "if -i is negative: stop when the gain is below this value");
  args.param("ig", o.gain_iterations, std::numeric_limits<int>::max(),
             "if -i is negative: perform at most n iterations");
  args.param("guess", o.guess, false, "start from an initial guess along a spanning tree");
  args.param("guessOdometry", o.guess_odometry, false, "start from an initial guess along the odometry");
  args.param("inc", o.incremental, false, "add the vertices one by one");
  args.param("update", o.update_every, 10,
             "with -inc: optimize after every n vertices; performs one iteration if there is no -i");
  args.param("guiout", o.gui_output, false, "with -inc: write commands for gnuplot to standard output");
  args.param("marginalize", o.marginalize, false,
             "eliminate all vertices except those with the largest dimension");
  args.param("printSolverProperties", o.print_solver_properties, false,
             "print the properties of the algorithm");
  args.param("solverProperties", o.solver_properties, "",
             "set properties of the algorithm: initialLambda=0.0001,maxTrialsAfterFailure=2");
  args.param("nonSequential", o.non_sequential, false,
             "use the robust kernel only for edges that do not connect consecutive vertices");
  args.param("gaugeId", o.gauge_id, -1, "fix this vertex");
  args.param("gaugeList", o.gauge_list, std::vector<int>(), "fix these vertices: 1,2,3");
  args.param("solver", o.solver, "gn_var", "the algorithm; see -listSolvers");
  args.param("stats", o.statistics, "", "write statistics of every iteration to this file");
  parse(args, o, argc, argv);
  o.iterations_given = args.parsedParam("i");
  require(o.gain >= 0, "gain", "0 or more");
  require(o.gain_iterations >= 0, "ig", "0 or more");
  return o;
}

}  // namespace g2o_tool
