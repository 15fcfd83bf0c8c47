// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "g2o/stuff/command_args.h"

namespace g2o_tool {

/// The options of the command line.
struct Options {
  int iterations = 5;
  bool iterations_given = false;
  double gain = 1e-6;
  int gain_iterations = std::numeric_limits<int>::max();
  bool verbose = false, guess = false, guess_odometry = false;
  bool incremental = false;
  int update_every = 10;
  bool gui_output = false;
  bool marginalize = false;
  bool print_solver_properties = false;
  std::string solver_properties;
  std::string robust_kernel;
  double robust_kernel_width = -1;
  bool non_sequential = false;
  bool compute_marginals = false;
  int gauge_id = -1;
  std::vector<int> gauge_list;
  std::string output, gnuplot, solver, statistics, summary;
  std::vector<std::string> solver_libraries, type_libraries;
  bool list_types = false, list_solvers = false, list_kernels = false;
  std::string rename_types;
  std::string input;
  std::string library;  ///< the last value of -solverlib or -typeslib; not used
};

/// Removes every "-name value" from the arguments and returns the values. CommandArgs cannot do this, because
/// it accepts each parameter only once.
std::vector<std::string> take_repeated(std::vector<std::string>& arguments, const std::string& name);

/// Declares the switches that all programs have that optimize a file, and the file.
void declare_shared(g2o::CommandArgs& args, Options& options);
/// Reads the command line. Ends the program with the help if the user asked for it, or if the command line is
/// wrong.
void parse(g2o::CommandArgs& args, Options& options, int argc, char** argv);
/// Prints a message and ends the program if the value of a parameter is not in its range.
void require(bool in_range, const char* name, const char* expected);

/// Reads the command line of `g2o`. Ends the program with the help if the user asked for it, or if the
/// command line is wrong.
Options read_options(int argc, char** argv);

}  // namespace g2o_tool
