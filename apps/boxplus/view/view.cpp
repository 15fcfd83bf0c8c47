// SPDX-License-Identifier: BSD-3-Clause
// boxplus view [FILE]: shows a graph in a browser.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <optional>
#include <utility>

#include "boxplus/base/error.h"
#include "command.h"
#include "command_line/message.h"
#include "command_line/option_kinds.h"
#include "files/format_names.h"
#include "files/graph_input.h"
#include "files/outputs.h"
#include "files/trajectory_input.h"
#include "platform/signals.h"
#include "view/serving.h"
#include "viewer/server/server.h"
#include "viewer/workspace/workspace.h"

namespace boxplus::app {
namespace {

struct ViewArguments : ServingArguments {
  std::string input, truth;
  ReadOptions reading;
};

int view_file(const ViewArguments& arguments) {
  if (arguments.input == kStandardStream && arguments.truth == kStandardStream)
    throw InvalidArgument("view: expected at most one file from standard input, got '-' twice");
  std::optional<GraphFile> file;
  std::optional<viewer::Truth> truth;
  if (!arguments.input.empty()) file = load_graph(arguments.input, arguments.reading);
  if (!arguments.truth.empty())
    truth.emplace(read_truth(arguments.truth, arguments.reading), shown_name(arguments.truth));
  const HeldEndSignals signals;  // before the threads of the workspace and of the server
  viewer::Workspace workspace;
  if (file) workspace.show(std::move(*file), shown_name(arguments.input), std::move(truth));
  const viewer::Server server(workspace, arguments.server);
  fmt::print("{}\n", server.url());
  std::fflush(stdout);
  print_message("Ctrl-C ends the viewer; the file stays as it is");
  if (arguments.opens_browser) open_browser(server.url(), signals.before());
  signals.next();
  end_soon(kSuccess);
  return kSuccess;
}

}  // namespace

void add_view(CLI::App& app, Action& action) {
  auto arguments = std::make_shared<ViewArguments>();
  CLI::App* command = app.add_subcommand("view", "Shows a graph in a browser, and optimizes it there");
  CLI::Option* file = command->add_option("FILE", arguments->input, graph_to_read())->check(file_name());
  command
      ->add_option("--truth", arguments->truth,
                   "Also show the true estimates from this graph file, and the errors ATE and RPE (see "
                   "compare); they are aligned with FILE")
      ->type_name("FILE")
      ->check(file_name())
      ->needs(file);
  add_serving_options(*command, *arguments);
  add_reading_options(*command, arguments->reading);
  command->footer(
      "Prints the URL of the viewer, and serves it until Ctrl-C. The viewer never writes to FILE. Without\n"
      "FILE, open or drop a file on the page.\n"
      "\n"
      "On another machine: ssh -t -L 8743:127.0.0.1:8743 machine boxplus view graph.g2o --port 8743\n"
      "\n"
      "Examples:\n"
      "  boxplus view graph.g2o --open\n"
      "  boxplus view graph.g2o --truth truth.g2o");
  command->callback([&action, arguments] { action = [arguments] { return view_file(*arguments); }; });
}

}  // namespace boxplus::app
