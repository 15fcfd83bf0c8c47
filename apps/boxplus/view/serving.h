// SPDX-License-Identifier: BSD-3-Clause
// What the sub-commands that serve a page have in common.
#pragma once

#include <string>

#include "platform/signals.h"
#include "viewer/server/server.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace boxplus::app {

struct ServingArguments {
  viewer::ServerOptions server;
  bool opens_browser = false;
};

/// Adds --port, --host and --open. If `needed` is not null, they need this option.
void add_serving_options(CLI::App& command, ServingArguments& arguments, CLI::Option* needed = nullptr);

/// The name that the page shows for a file or folder.
std::string shown_name(const std::string& path);

/// Opens the URL with the user's browser. The browser's output is dropped, and it blocks only `signals`.
void open_browser(const std::string& url, const SignalSet& signals);

/// Ends the process with this code if its threads have not ended after a while: a parser or a slow client may
/// take long, and there is nothing to save.
void end_soon(int code);

}  // namespace boxplus::app
