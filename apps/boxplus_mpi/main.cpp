// SPDX-License-Identifier: BSD-3-Clause
// The `boxplus-mpi` command: `boxplus optimize` in several processes, which mpirun starts.
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <memory>
#include <new>

#include "boxplus/base/error.h"
#include "command.h"
#include "command_line/help_format.h"
#include "command_line/message.h"
#include "command_line/usage_error.h"
#include "communicator.h"
#include "files/clean_end.h"
#include "optimize.h"
#include "platform/standard_streams.h"

namespace boxplus::app {
namespace {

int parse_and_run(int argc, char** argv, mpi::Communicator& communicator) {
  CLI::App app{"Nonlinear least squares on graphs, in several processes", "boxplus-mpi"};
  app.formatter(std::make_shared<HelpFormat>());
  app.set_help_flag("-h,--help", "Show this help");
  app.set_version_flag("--version", "boxplus " BOXPLUS_VERSION, "Show the version");
  app.require_subcommand(1);
  Action action;
  add_distributed_optimize(app, action, communicator);
  bool is_help = false;
  communicator.together([&] {
    try {
      app.parse(argc, argv);
    } catch (const CLI::Success& success) {  // --help, --version
      app.exit(success);
      is_help = true;
    } catch (const CLI::ParseError& error) {
      throw InvalidArgument(usage_message(app, error));
    }
  });
  return communicator.any(is_help) ? static_cast<int>(kSuccess) : action();
}

int stderr_of_process = STDERR_FILENO;

/// Ends all processes after an error of MPI, or one that only this process has. It may have no memory.
void end_all(MPI_Comm*, int* error, ...) {
  char reason[MPI_MAX_ERROR_STRING] = "", text[MPI_MAX_ERROR_STRING + 100] = "";
  int length = 0, rank = 0;
  (void)MPI_Error_string(*error, reason, &length);
  (void)MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  length = std::snprintf(text, sizeof text, "boxplus: process %d cannot go on: %s\n", rank, reason);
  if (length > 0) (void)!write(stderr_of_process, text, static_cast<std::size_t>(length));
  (void)MPI_Abort(MPI_COMM_WORLD, kNumericalFailure);
  std::_Exit(kNumericalFailure);  // mpirun then ends the others
}

/// Only the first process prints what all processes agree on.
int run(int argc, char** argv) {
  MPI_Errhandler ends_all = MPI_ERRHANDLER_NULL;
  MPI_Comm_create_errhandler(end_all, &ends_all);
  MPI_Comm_set_errhandler(MPI_COMM_WORLD, ends_all);
  stderr_of_process = dup(STDERR_FILENO);
  mpi::Communicator communicator(MPI_COMM_WORLD);
  if (!communicator.is_first()) {
    for (std::FILE* stream : {stdout, stderr}) {
      if (std::freopen("/dev/null", "w", stream) == nullptr) return kBadInput;
    }
  }
  try {
    const int code = parse_and_run(argc, argv, communicator);
    if (std::fflush(stdout) == 0) return code;
    print_message("cannot write to standard output");
    return kBadInput;
  } catch (const std::bad_alloc&) {
    print_message("not enough memory in one of the processes");
    return kNumericalFailure;
  } catch (const std::exception& error) {
    print_message(error.what());
    return kBadInput;
  }
}

}  // namespace
}  // namespace boxplus::app

int main(int argc, char** argv) {
  boxplus::reserve_standard_streams();
  MPI_Init(&argc, &argv);
  boxplus::app::end_cleanly_on_signals();
  std::signal(SIGXFSZ, SIG_IGN);  // so that exceeding `ulimit -f` is a write error, like a full disk
  const int code = boxplus::app::run(argc, argv);
  MPI_Finalize();
  return code;
}
