// SPDX-License-Identifier: BSD-3-Clause
// Shows the graph of a program in a browser. Link boxplus::viewer.
#pragma once

#include <memory>
#include <string>

#include "boxplus/graph/graph.h"
#include "boxplus/optimize/report.h"
#include "boxplus/options/options.h"
#include "boxplus/outliers/outliers.h"

namespace boxplus {

struct ViewerOptions {
  std::string name = "graph";      ///< what the page calls the graph
  std::string host = "127.0.0.1";  ///< at any other address, other machines can reach the server
  int port = 0;                    ///< 0: 8743, or any free port if it is taken
};

/// Serves a page that shows a graph, and its optimization while it runs:
///
///     boxplus::Viewer viewer(graph);
///     std::cout << viewer.url() << std::endl;
///     const boxplus::Report report = optimize(graph, viewer.watch(options));
///     viewer.show(report);
///     viewer.hand_over();  // from now on, the page may optimize
///     std::cin.get();
///
/// A slow page, or none, does not delay the program: a frame is made at most 30 times a second, in at most
/// 1/25 of the time, and only if a page is open.
///
/// Call these functions from the thread that uses the graph, which must outlive the viewer. They may throw
/// whatever an error function of the graph throws.
class Viewer {
 public:
  /// Starts the server. Throws Error if the address cannot be bound.
  explicit Viewer(Graph& graph, const ViewerOptions& options = {});
  /// Closes all pages, and stops a run that was started by one. Returns within a second, or when that run has
  /// ended its iteration.
  ~Viewer();
  Viewer(const Viewer&) = delete;
  Viewer& operator=(const Viewer&) = delete;

  /// The address of the page. If other machines can reach the server, it contains the token that they need.
  std::string url() const;

  /// Returns options whose callback shows each iteration, and then calls the callback of `options`, if any.
  /// If somebody presses "Stop" on the page, the run ends after its iteration (Report::Reason::kCallback).
  /// The result must not be used after the viewer is gone. If hand_over() was called, takes the graph back.
  Options watch(Options options = {});
  /// Shows the end of a run, and the current estimates.
  void show(const Report& report);
  /// The same for the final run of find_outliers(); its verdicts color the edges.
  void show(const OutlierReport& found);
  /// Shows the current estimates. Call it if the program has changed estimates or elements outside of a run.
  void update();
  /// The same after each update of a Smoother, or of any graph that grows: at most 30 times a second, in at
  /// most 1/25 of the time, and only if a page is open.
  void follow();

  /// Lets pages optimize and change the graph, in a thread of the viewer. The program must not use the graph,
  /// until take_back().
  void hand_over();
  /// Stops what a page has started, and waits for its end. Now the program may use the graph again. Has no
  /// effect without hand_over().
  void take_back();

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace boxplus
