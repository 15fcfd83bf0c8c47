// SPDX-License-Identifier: BSD-3-Clause
// boxplus view [FILE]: shows a graph in a browser.
#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <spawn.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <optional>
#include <thread>
#include <utility>

#include "boxplus/base/error.h"
#include "command.h"
#include "command_line/message.h"
#include "command_line/option_kinds.h"
#include "files/format_names.h"
#include "files/graph_input.h"
#include "viewer/server/server.h"
#include "viewer/workspace/workspace.h"

namespace boxplus::app {
namespace {

struct ViewArguments {
  std::string input;
  viewer::ServerOptions server;
  bool opens_browser = false;
  ReadOptions reading;
};

/// While it exists, the signals that end the command wait for next() instead. Threads that are created in the
/// meantime do not receive them either.
class EndSignals {
 public:
  EndSignals() {
    sigemptyset(&signals_);
    for (const int each : {SIGINT, SIGTERM, SIGHUP}) sigaddset(&signals_, each);
    pthread_sigmask(SIG_BLOCK, &signals_, &before_);
  }
  ~EndSignals() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  EndSignals(const EndSignals&) = delete;
  EndSignals& operator=(const EndSignals&) = delete;

  void next() const {
    int signal = 0;
    while (sigwait(&signals_, &signal) != 0) {
    }
  }
  const sigset_t& before() const { return before_; }

 private:
  sigset_t signals_, before_;
};

/// Opens the URL with the user's browser. The browser's output is dropped, and it gets the usual signals.
void open_browser(const std::string& url, const sigset_t& signals) {
  std::string program = "xdg-open", address = url;
  std::array<char*, 3> arguments{program.data(), address.data(), nullptr};
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    posix_spawn_file_actions_addopen(&files, stream, "/dev/null", O_RDWR, 0);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setsigmask(&attributes, &signals);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK);
  pid_t process = 0;
  if (posix_spawnp(&process, program.c_str(), &files, &attributes, arguments.data(), environ) != 0)
    print_message("--open: xdg-open was not found, so open the URL yourself");
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&files);
}

/// Ends the process if its threads have not ended after a while: a parser or a slow client may take long, and
/// there is nothing to save.
void end_soon() {
  std::thread([] {
    std::this_thread::sleep_for(std::chrono::milliseconds(700));
    std::_Exit(kSuccess);
  }).detach();
}

std::string name_of(const std::string& path) {
  if (path == kStandardStream) return input_name(path);
  const std::filesystem::path file(path);
  return (file.has_filename() ? file : file.parent_path()).filename().string();
}

int view_file(const ViewArguments& arguments) {
  std::optional<GraphFile> file;
  if (!arguments.input.empty()) file = load_graph(arguments.input, arguments.reading);
  const EndSignals signals;  // before the threads of the workspace and of the server
  viewer::Workspace workspace;
  if (file) workspace.show(std::move(*file), name_of(arguments.input));
  const viewer::Server server(workspace, arguments.server);
  fmt::print("{}\n", server.url());
  std::fflush(stdout);
  print_message("Ctrl-C ends the viewer; the file stays as it is");
  if (arguments.opens_browser) open_browser(server.url(), signals.before());
  signals.next();
  end_soon();
  return kSuccess;
}

}  // namespace

void add_view(CLI::App& app, Action& action) {
  auto arguments = std::make_shared<ViewArguments>();
  CLI::App* command = app.add_subcommand("view", "Shows a graph in a browser, and optimizes it there");
  command->add_option("FILE", arguments->input, graph_to_read())->check(file_name());
  command
      ->add_option("--port", arguments->server.port,
                   fmt::format("The port of the server; 0: {}, or any free port if it is taken",
                               viewer::ServerOptions::kUsualPort))
      ->check(whole_number_within(0, 65535))
      ->type_name("N")
      ->capture_default_str();
  command
      ->add_option("--host", arguments->server.host,
                   "The address at which the server listens. At any other address than 127.0.0.1, other "
                   "machines can reach it, and the URL contains a token that they need")
      ->check(file_name())
      ->type_name("ADDRESS")
      ->capture_default_str();
  command->add_flag("--open", arguments->opens_browser, "Open the URL in the browser");
  add_reading_options(*command, arguments->reading);
  command->footer(
      "Prints the URL of the viewer, and serves it until Ctrl-C. The viewer never writes to FILE. Without\n"
      "FILE, open or drop a file on the page.\n"
      "\n"
      "On another machine: ssh -t -L 8743:127.0.0.1:8743 machine boxplus view graph.g2o --port 8743\n"
      "\n"
      "Example:\n"
      "  boxplus view graph.g2o --open");
  command->callback([&action, arguments] { action = [arguments] { return view_file(*arguments); }; });
}

}  // namespace boxplus::app
