// SPDX-License-Identifier: BSD-3-Clause
// boxplus-mpi optimize FILE
#pragma once

#include "command.h"
#include "communicator.h"

namespace boxplus::app {

/// Adds the sub-command, as add_optimize() does.
void add_distributed_optimize(CLI::App& app, Action& action, mpi::Communicator& communicator);

}  // namespace boxplus::app
