// SPDX-License-Identifier: BSD-3-Clause
// Reads trajectories and true estimates for the sub-commands, from files or standard input.
#pragma once

#include <string>

#include "boxplus/io/graph_file.h"
#include "trajectory/trajectory.h"

namespace boxplus::app {

/// Reads the poses of a graph (without its landmarks), and prints the notes about the file, or reads a TUM
/// file (is_tum()). Throws FileError if the file cannot be read or has no valid trajectory. Throws
/// InputError, with the position of the error, if a line is malformed.
Trajectory read_trajectory(const std::string& path, const ReadOptions& reading);

/// Reads a graph with true estimates, and prints the notes about the file. Throws FileError if the file
/// cannot be read or is a TUM file, and InputError if it is malformed or empty.
GraphFile read_truth(const std::string& path, const ReadOptions& reading);

}  // namespace boxplus::app
