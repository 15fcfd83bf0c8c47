// SPDX-License-Identifier: BSD-3-Clause
// The results of an optimization do not depend on the number of threads.
#include <gtest/gtest.h>

#include "boxplus/base/parallel.h"
#include "g2o/types/camera_scene.h"

namespace {

using camera_scene::Scene;

g2o::EdgeSE3ProjectXYZ* make_edge() {
  return new g2o::EdgeSE3ProjectXYZ;
}

/// The estimates of the points, and chi2, after five iterations.
std::vector<double> optimized() {
  Scene scene(400, make_edge);
  std::vector<double> values{scene.chi2_after(5)};
  for (int k = 0; k < 400; ++k) {
    std::vector<double> estimate;
    static_cast<g2o::OptimizableGraph::Vertex*>(scene.optimizer.vertex(Scene::kCameras + k))
        ->getEstimateData(estimate);
    values.insert(values.end(), estimate.begin(), estimate.end());
  }
  return values;
}

TEST(SameBits, OfAllThreadsAndOneThread) {
  std::vector<double> on_one_thread;
  // Tasks inside of a task run on the same thread.
  boxplus::detail::parallel_tasks(2, [&](int thread) {
    if (thread == 0) on_one_thread = optimized();
  });
  EXPECT_EQ(optimized(), on_one_thread);
}

}  // namespace
