// SPDX-License-Identifier: BSD-3-Clause
// g2o_viewer [OPTIONS] [FILE]: shows a graph in a browser, and optimizes it there, with the types and
// algorithms of the g2o API and its plug-ins. Exit code 1: a file, a folder or a port cannot be opened.
#include <signal.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <memory>
#include <sstream>
#include <thread>

#include "boxplus/base/error.h"
#include "g2o/stuff/command_args.h"
#include "io/printable.h"
#include "options.h"
#include "plugins.h"
#include "viewer/optimizer_subject.h"
#include "viewer/server/server.h"
#include "viewer/workspace/workspace.h"

namespace g2o_tool {
namespace {

/// Reads a graph, and fixes one of its vertices if nothing else fixes it.
std::unique_ptr<boxplus::viewer::Subject> open_graph(const std::string& name, std::istream& file,
                                                     const std::string& renames) {
  auto optimizer = std::make_unique<g2o::SparseOptimizer>();
  optimizer->setRenamedTypesFromString(renames);
  if (!optimizer->load(file)) throw boxplus::InvalidArgument(name + " has lines that cannot be read");
  if (optimizer->vertices().empty()) throw boxplus::InvalidArgument(name + " has no vertices");
  if (optimizer->gaugeFreedom()) {
    if (g2o::OptimizableGraph::Vertex* gauge = optimizer->findGauge()) gauge->setFixed(true);
  }
  return std::make_unique<g2o::internal::OptimizerSubject>(std::move(optimizer), name);
}

int view(const std::string& path, int port, const std::string& renames) {
  // Blocked before any thread begins, so that only this one waits for them.
  sigset_t ends;
  sigemptyset(&ends);
  for (const int each : {SIGINT, SIGTERM, SIGHUP}) sigaddset(&ends, each);
  pthread_sigmask(SIG_BLOCK, &ends, nullptr);
  boxplus::viewer::Workspace workspace(
      [&](const std::string& name, const std::string& text, boxplus::viewer::Listener&) {
        std::istringstream file(text);
        return open_graph(name, file, renames);
      });
  if (!path.empty()) {
    std::ifstream file(path);
    if (!file || (file.peek(), file.bad())) throw boxplus::InvalidArgument(path + " cannot be opened");
    workspace.show(open_graph(path.substr(path.find_last_of('/') + 1), file, renames));
  }
  const boxplus::viewer::Server server(workspace, {"127.0.0.1", port});
  std::cout << server.url() << std::endl;
  std::cerr << "Ctrl-C ends the viewer; the file stays as it is\n";
  int signal = 0;
  while (sigwait(&ends, &signal) != 0) {
  }
  // A parser may take long, and there is nothing to save.
  std::thread([] {
    std::this_thread::sleep_for(std::chrono::milliseconds(700));
    std::_Exit(0);
  }).detach();
  return 0;
}

}  // namespace
}  // namespace g2o_tool

int main(int argc, char** argv) {
  std::string library, renames, path;
  int port = 0;
  g2o::CommandArgs args;
  args.setBanner("g2o_viewer: shows a graph in a browser, and optimizes it there.");
  args.param("solverlib", library, "", "load this library of algorithms; may be given several times");
  args.param("typeslib", library, "", "load this library of types; may be given several times");
  args.param("renameTypes", renames, "",
             "rename types: A=B,C=D reads lines of type A as B, and lines of type C as D");
  args.param("port", port, 0, "the port of the server; 0: 8743, or any free port if it is taken");
  args.paramLeftOver("graph-input", path, "", "the file", true);
  std::vector<std::string> arguments(argv, argv + argc);
  const std::vector<std::string> solvers = g2o_tool::take_repeated(arguments, "solverlib");
  const std::vector<std::string> types = g2o_tool::take_repeated(arguments, "typeslib");
  std::vector<char*> rest;
  for (std::string& argument : arguments) rest.push_back(argument.data());
  args.parseArgs(static_cast<int>(rest.size()), rest.data());
  g2o_tool::load_type_libraries(types, argv[0]);
  g2o_tool::load_solver_libraries(solvers, argv[0]);
  try {
    return g2o_tool::view(path, port, renames);
  } catch (const std::exception& error) {
    std::cerr << "g2o_viewer: " << boxplus::escaped(error.what()) << '\n';
    return 1;
  }
}
