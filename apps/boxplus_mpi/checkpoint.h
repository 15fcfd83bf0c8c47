// SPDX-License-Identifier: BSD-3-Clause
// Files with the estimates of all processes, from which a later run goes on.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "communicator.h"
#include "results.h"

namespace boxplus::app {

/// Writes the changes of all processes (Results) since a problem with this number of edges was read. The
/// first process replaces the file completely or not at all, and holds the changes of one other process at a
/// time. Collective. Throws FileError.
void write_checkpoint(const std::string& path, std::uint64_t edges, std::span<const std::uint64_t> changes,
                      mpi::Communicator& communicator);

/// Applies a checkpoint, of any number of processes. Throws FileError, or InvalidArgument if the file is not
/// a checkpoint of a problem with this number of edges.
void apply_checkpoint(const std::string& path, std::uint64_t edges, ChangedGraph& graph);

}  // namespace boxplus::app
