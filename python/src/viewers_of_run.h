// SPDX-License-Identifier: BSD-3-Clause
// The viewers that show a run.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "graph_object.h"
#include "viewer_interface.h"

namespace boxplus::python {

/// The open viewers of a graph. A viewer that is closed during the run ends with this object.
class ViewersOfRun {
 public:
  explicit ViewersOfRun(const GraphObject& graph) : viewers_(graph.viewers()) {}

  /// Call these without Python's lock (GIL).
  Options watch(Options options) const {
    for (const auto& viewer : viewers_) options = viewer->watch(std::move(options));
    return options;
  }
  void show(const auto& report) const {
    for (const auto& viewer : viewers_) viewer->show(report);
  }
  void follow() const {
    for (const auto& viewer : viewers_) viewer->follow();
  }
  void update() const {
    for (const auto& viewer : viewers_) viewer->update();
  }

 private:
  std::vector<std::shared_ptr<ViewerInterface>> viewers_;
};

}  // namespace boxplus::python
