// SPDX-License-Identifier: BSD-3-Clause
// Draws a graph in a window of gnuplot.
#pragma once

#include <cstdio>
#include <memory>
#include <string>

#include "boxplus/graph/graph.h"

namespace boxplus::programs {

/// The commands with which gnuplot draws the edges of a graph as lines between poses and points: in the
/// plane, or in space if the graph has a pose or point in space.
std::string gnuplot_commands(const Graph& graph);

/// A running gnuplot. If it cannot be started or ends early, prints one message and draws no more.
class Gnuplot {
 public:
  Gnuplot();
  void draw(const Graph& graph);

 private:
  struct Close {
    void operator()(std::FILE* pipe) const;
  };
  std::unique_ptr<std::FILE, Close> pipe_;
};

}  // namespace boxplus::programs
