// SPDX-License-Identifier: BSD-3-Clause
// Shows an optimizer of a program in a browser. Link g2o::viewer. This is an addition of boxplus to the g2o
// API.
#pragma once
#ifndef G2O_VIEWER_H
#define G2O_VIEWER_H

#include <memory>
#include <string>

#include "g2o/core/sparse_optimizer.h"

namespace g2o {

/// Serves a page that shows the graph of an optimizer, drawn by the actions "draw" of its types, and each
/// optimize() while it runs:
///
///     g2o::Viewer viewer(optimizer);
///     std::cout << viewer.url() << std::endl;
///     optimizer.optimize(10);
///     viewer.handOver();  // from now on, the page may optimize
///     std::cin.get();
///
/// If somebody presses "Stop" on the page, optimize() ends after its iteration, and does nothing until the
/// next update(). A slow page, or none, does not delay the optimizer. Call these functions from the thread
/// that uses the optimizer, which must outlive the viewer.
class G2O_API_EXPORT Viewer {
 public:
  /// Starts the server at 127.0.0.1. Port 0 is 8743, or any free port if it is taken. Throws std::exception
  /// if the port cannot be bound.
  explicit Viewer(SparseOptimizer& optimizer, int port = 0, const std::string& name = "graph");
  ~Viewer();
  Viewer(const Viewer&) = delete;
  Viewer& operator=(const Viewer&) = delete;

  /// The address of the page.
  std::string url() const;

  /// Shows the current estimates, and elements that the program has added. Call it after optimize().
  void update();
  /// Lets pages optimize, in a thread of the viewer. The program must not use the optimizer, until
  /// takeBack().
  void handOver();
  /// Stops what a page has started, and waits for its end.
  void takeBack();

 private:
  class Implementation;
  std::unique_ptr<Implementation> _implementation;
};

}  // namespace g2o

#endif  // G2O_VIEWER_H
