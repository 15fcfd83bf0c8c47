// SPDX-License-Identifier: BSD-3-Clause
#include "view/serving.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <thread>

#include "command_line/message.h"
#include "command_line/option_kinds.h"
#include "files/graph_input.h"
#include "files/outputs.h"
#include "platform/process.h"

namespace boxplus::app {

void add_serving_options(CLI::App& command, ServingArguments& arguments, CLI::Option* needed) {
  CLI::Option* port =
      command.add_option("--port", arguments.server.port,
                         fmt::format("The port of the server; 0: {}, or any free port if it is taken",
                                     viewer::ServerOptions::kUsualPort));
  port->check(whole_number_within(0, 65535))->type_name("N")->capture_default_str();
  CLI::Option* host = command.add_option("--host", arguments.server.host,
                                         "The address at which the server listens. At any other address than "
                                         "127.0.0.1, other machines can reach "
                                         "it, and the URL contains a token that they need");
  host->check(file_name())->type_name("ADDRESS")->capture_default_str();
  CLI::Option* open = command.add_flag("--open", arguments.opens_browser, "Open the URL in the browser");
  if (needed == nullptr) return;
  for (CLI::Option* option : {port, host, open}) option->needs(needed)->group(needed->get_group());
}

std::string shown_name(const std::string& path) {
  if (path == kStandardStream) return input_name(path);
  const std::filesystem::path file(path);
  return (file.has_filename() ? file : file.parent_path()).filename().string();
}

void open_browser(const std::string& url, const SignalSet& signals) {
  if (!start_browser(url, signals)) print_message("--open: xdg-open was not found, so open the URL yourself");
}

void end_soon(int code) {
  std::thread([code] {
    std::this_thread::sleep_for(std::chrono::milliseconds(700));
    std::_Exit(code);
  }).detach();
}

}  // namespace boxplus::app
