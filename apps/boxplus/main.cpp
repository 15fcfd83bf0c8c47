// SPDX-License-Identifier: BSD-3-Clause
// The `boxplus` command.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <iostream>

#include "command.h"

namespace boxplus::app {
namespace {

constexpr const char* kExitCodes =
    "Exit codes: 0 success (optimize: converged), 1 optimize stopped before it converged,\n"
    "2 bad input or usage, 3 the numerics failed.";

int run(int argc, char** argv) {
  CLI::App app{"boxplus: nonlinear least squares on graphs", "boxplus"};
  app.set_version_flag("--version", "boxplus " BOXPLUS_VERSION);
  app.require_subcommand(1);
  app.footer(kExitCodes);
  Action action;
  add_optimize(app, action);
  add_simulate(app, action);
  add_plot(app, action);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? kSuccess : kBadInput;  // prints --help to stdout, complaints to stderr
  }
  return action();
}

}  // namespace
}  // namespace boxplus::app

int main(int argc, char** argv) {
  try {
    const int code = boxplus::app::run(argc, argv);
    if (std::fflush(stdout) == 0 && std::cout.flush()) return code;
    fmt::print(stderr, "boxplus: cannot write to the standard output\n");
    return boxplus::app::kBadInput;
  } catch (const std::exception& error) {
    fmt::print(stderr, "boxplus: {}\n", error.what());
    return boxplus::app::kBadInput;
  }
}
