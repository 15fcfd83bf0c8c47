// SPDX-License-Identifier: BSD-3-Clause
// `boxplus optimize --view` and `boxplus replay --view`: a page that shows a run.
#pragma once

#include <string>

#include "boxplus/io/graph_file.h"
#include "boxplus/optimize/report.h"
#include "view/serving.h"
#include "viewer/server/server.h"
#include "viewer/workspace/workspace.h"

namespace boxplus::app {

class LiveView {
 public:
  /// Starts the server, and prints its URL to stderr. `file` must outlive this object. `path` is its path.
  LiveView(GraphFile& file, const std::string& path, const ServingArguments& arguments,
           viewer::Drawn drawn = viewer::Drawn::kAll);
  /// Shows an iteration. Returns false if the run must stop.
  bool watch(const IterationRecord& record) { return workspace_.watch(record); }
  /// Waits until a page is open, or until Ctrl-C.
  void wait_for_page() const;
  /// Shows what has changed in the graph, unless it is too early after the last time.
  void follow() { workspace_.follow(); }
  /// Shows the graph as it is now.
  void show() { workspace_.update(); }
  /// Shows the end of the run. Then serves the page, which may go on with the graph, until Ctrl-C
  /// (Interrupt). `code` is the exit code of the process.
  void serve(const Report& report, int code);
  /// The same at the end of a replay.
  void serve(int code);

 private:
  void serve_graph(int code);

  viewer::Workspace workspace_;
  viewer::Server server_;
};

}  // namespace boxplus::app
