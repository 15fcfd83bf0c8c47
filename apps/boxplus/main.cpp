// SPDX-License-Identifier: BSD-3-Clause
// The `boxplus` command.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <memory>
#include <new>
#include <string_view>
#include <vector>

#include "boxplus/base/error.h"
#include "boxplus/linear/instruction_set.h"
#include "command.h"
#include "command_line/help_format.h"
#include "command_line/message.h"
#include "command_line/usage_error.h"
#include "files/clean_end.h"
#include "platform/standard_streams.h"

namespace boxplus::app {
namespace {

constexpr const char* kFooter =
    "Exit codes:\n"
    "  0  success (optimize: converged)\n"
    "  1  optimize stopped before it converged; its result is the best estimate so far\n"
    "  2  bad input or usage; no output file is changed\n"
    "  3  numerical failure, or not enough memory\n"
    "\n"
    "Environment:\n"
    "  BOXPLUS_ISA  the instruction set for dense matrices: baseline, avx2, avx512 or neon. The\n"
    "               default is the best one that the processor has. The last digits of results may depend\n"
    "               on it.\n"
    "\n"
    "The file name - stands for standard input or standard output. Results go to standard output, and\n"
    "messages go to standard error.";

/// Throws Error if the value of BOXPLUS_ISA is not an instruction set of this processor. The library would
/// ignore such a value.
void require_known_instructions() {
  const char* wanted = std::getenv("BOXPLUS_ISA");
  const std::vector<std::string_view> known = instruction_sets();
  if (wanted == nullptr || *wanted == '\0' || std::find(known.begin(), known.end(), wanted) != known.end())
    return;
  throw Error(fmt::format("BOXPLUS_ISA: expected an instruction set of this processor ({}), got '{}'",
                          fmt::join(known, ", "), wanted));
}

int run(int argc, char** argv) {
  require_known_instructions();
  CLI::App app{"Nonlinear least squares on graphs: SLAM, bundle adjustment, calibration", "boxplus"};
  app.formatter(std::make_shared<HelpFormat>());
  app.set_help_flag("-h,--help", "Show this help");
  app.set_version_flag("--version", "boxplus " BOXPLUS_VERSION, "Show the version");
  app.require_subcommand(1);
  Action action;
  add_optimize(app, action);
  add_info(app, action);
  add_convert(app, action);
  add_simulate(app, action);
  add_plot(app, action);
  add_view(app, action);
  add_compare(app, action);
  add_replay(app, action);
  add_completion(app, action);
  add_help(app, action);
  app.footer(kFooter);  // must be last, because sub-commands that are added later would inherit the footer
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& success) {  // --help, --version
    return app.exit(success);
  } catch (const CLI::ParseError& error) {
    print_message(usage_message(app, error));
    return kBadInput;
  }
  return action();
}

}  // namespace
}  // namespace boxplus::app

int main(int argc, char** argv) {
  boxplus::reserve_standard_streams();
  boxplus::app::end_cleanly_on_signals();
  std::signal(SIGXFSZ, SIG_IGN);  // so that exceeding `ulimit -f` is a write error, like a full disk
  try {
    const int code = boxplus::app::run(argc, argv);
    if (std::fflush(stdout) == 0 && std::cout.flush()) return code;
    boxplus::app::print_message("cannot write to standard output");
    return boxplus::app::kBadInput;
  } catch (const std::bad_alloc&) {
    boxplus::app::print_message("not enough memory (for optimize, --solver pcg needs the least memory)");
    return boxplus::app::kNumericalFailure;
  } catch (const std::exception& error) {
    boxplus::app::print_message(error.what());
    return boxplus::app::kBadInput;
  }
}
