// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "boxplus/graph/graph.h"
#include "optimize/optimize_options.h"

namespace boxplus::app {

/// Carries out --fix, --hold and --free for one run. Afterwards, vertices are as fixed as before, by FIX
/// lines of the file.
class FixForRun {
 public:
  FixForRun(Graph& graph, const OptimizeArguments& arguments);
  ~FixForRun() { restore(); }
  FixForRun(const FixForRun&) = delete;
  FixForRun& operator=(const FixForRun&) = delete;

 private:
  struct Before {
    VertexRef vertex;
    bool is_fixed;
    std::vector<int> directions;
  };

  void restore();

  Graph& graph_;
  std::vector<Before> before_;
};

}  // namespace boxplus::app
