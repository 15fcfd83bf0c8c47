// SPDX-License-Identifier: BSD-3-Clause
// The library evaluates its own camera edges in batches. A class of a client that derives from such an edge
// is evaluated by virtual calls, edge by edge. Both must give the same sums.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <thread>
#include <utility>
#include <vector>

#include "g2o/core/optimization_algorithm_dogleg.h"
#include "g2o/types/camera_scene.h"

namespace {

using camera_scene::Scene;
using camera_scene::Solver;
using g2o::OptimizableGraph;

struct ClientEdge : g2o::EdgeSE3ProjectXYZ {
  void computeError() override {
    ++errors;
    EdgeSE3ProjectXYZ::computeError();
  }
  using g2o::EdgeSE3ProjectXYZ::linearizeOplus;
  void linearizeOplus() override {
    ++jacobians;
    EdgeSE3ProjectXYZ::linearizeOplus();
  }
  int errors = 0, jacobians = 0;
};

/// A kernel of a client, which only the calling thread may call.
struct ClientKernel : g2o::RobustKernel {
  void robustify(double e2, g2o::Vector3& rho) const override {
    EXPECT_EQ(std::this_thread::get_id(), caller);
    rho << 0.5 * e2, 0.5, 0;
  }
  std::thread::id caller = std::this_thread::get_id();
};

/// An action that changes a scene at its fourth call, which is during the iterations.
struct AtFourthCall : g2o::HyperGraphAction {
  AtFourthCall(Scene& s, std::function<void(Scene&)> f) : scene(s), change(std::move(f)) {}
  HyperGraphAction* operator()(const g2o::HyperGraph*, Parameters*) override {
    if (++calls == 4) change(scene);
    return this;
  }
  Scene& scene;
  std::function<void(Scene&)> change;
  int calls = 0;
};

g2o::EdgeSE3ProjectXYZ* library_edge() {
  return new g2o::EdgeSE3ProjectXYZ;
}
g2o::EdgeSE3ProjectXYZ* client_edge() {
  return new ClientEdge;
}

void expect_same(const std::vector<double>& a, const std::vector<double>& b) {
  ASSERT_EQ(a.size(), b.size());
  double largest = 0;
  for (const double x : a) largest = std::max(largest, std::abs(x));
  for (std::size_t k = 0; k < a.size(); ++k) ASSERT_NEAR(a[k], b[k], 1e-11 * largest) << k;
}

/// Builds two scenes of `points` points, with library edges and with client edges, changes both, and compares
/// their systems and their results.
void compare(int points, const std::function<void(Scene&)>& change) {
  Scene ours(points, library_edge), plain(points, client_edge);
  change(ours);
  change(plain);
  expect_same(ours.system(), plain.system());
  const double chi2 = plain.chi2_after(5);
  EXPECT_NEAR(ours.chi2_after(5), chi2, 1e-9 * chi2);
}

TEST(SbaBatches, GiveTheSameAsVirtualCallsOnOneThreadAndOnAllThreads) {
  compare(20, [](Scene&) {});
  compare(400, [](Scene&) {});
}

TEST(SbaBatches, GiveTheSameIfSomeOmegasAreNotSymmetric) {
  compare(400, [](Scene& scene) {
    for (std::size_t k = 0; k < scene.edges.size(); k += 7) scene.edges[k]->information()(0, 1) += 1e-6;
  });
}

TEST(SbaBatches, CallKernelsOfClientsOnTheCallingThread) {
  compare(400, [](Scene& scene) {
    for (std::size_t k = 0; k < scene.edges.size(); k += 5) scene.edges[k]->setRobustKernel(new ClientKernel);
  });
}

TEST(SbaBatches, LeaveOutVerticesThatAreFixedAfterTheInitialization) {
  compare(400, [](Scene& scene) {
    static_cast<OptimizableGraph::Vertex*>(scene.optimizer.vertex(5))->setFixed(true);
  });
}

TEST(SbaBatches, DropEdgesThatLoseAVertexDuringAnIteration) {
  Scene ours(400, library_edge), plain(400, client_edge);
  const auto take_vertex = [](Scene& scene) { scene.edges[100]->setVertex(0, nullptr); };
  AtFourthCall from_ours(ours, take_vertex), from_plain(plain, take_vertex);
  ours.optimizer.addComputeErrorAction(&from_ours);
  plain.optimizer.addComputeErrorAction(&from_plain);
  const double chi2 = plain.chi2_after(6);
  EXPECT_NEAR(ours.chi2_after(6), chi2, 1e-9 * chi2);
  EXPECT_EQ(ours.optimizer.activeEdges().size(), ours.edges.size() - 1);
}

TEST(SbaBatches, FollowEdgesThatAreRemovedWithoutANewInitialization) {
  Scene ours(400, library_edge), plain(400, client_edge);
  for (Scene* scene : {&ours, &plain}) {
    scene->optimizer.optimize(1);
    for (std::size_t k = 0; k < 50; ++k) scene->optimizer.removeEdge(scene->edges[10 * k]);
  }
  const double chi2 = plain.chi2_after(5);
  EXPECT_NEAR(ours.chi2_after(5), chi2, 1e-9 * chi2);
}

TEST(SbaBatches, FollowEdgesThatGetAnotherVertexWithoutANewInitialization) {
  compare(400, [](Scene& scene) {
    scene.optimizer.computeActiveErrors();
    for (std::size_t k = 0; k < 50; ++k) scene.edges[k]->setVertex(1, scene.optimizer.vertex(11));
  });
}

TEST(SbaBatches, FollowEdgesThatGetAnotherVertexDuringTheIterations) {
  Scene ours(400, library_edge), plain(400, client_edge);
  const auto move_edges = [](Scene& scene) {
    for (std::size_t k = 0; k < 50; ++k) scene.edges[k]->setVertex(1, scene.optimizer.vertex(11));
  };
  AtFourthCall of_ours(ours, move_edges), of_plain(plain, move_edges);
  ours.optimizer.addComputeErrorAction(&of_ours);
  plain.optimizer.addComputeErrorAction(&of_plain);
  const double chi2 = plain.chi2_after(6);
  EXPECT_NEAR(ours.chi2_after(6), chi2, 1e-9 * chi2);
}

TEST(SbaBatches, LeaveReadableJacobiansInTheEdges) {
  Scene scene(400, library_edge);
  scene.optimizer.optimize(1);
  g2o::EdgeSE3ProjectXYZ& outlier = *scene.edges[0];
  outlier.setLevel(1);
  scene.optimizer.initializeOptimization(0);
  scene.optimizer.computeActiveErrors();
  outlier.computeError();
  static_cast<g2o::BaseBinaryEdge<2, g2o::Vector2, g2o::VertexPointXYZ, g2o::VertexSE3Expmap>&>(outlier)
      .linearizeOplus();
  EXPECT_TRUE(outlier.jacobianOplusXi().allFinite()) << "the memory still exists (AddressSanitizer)";
}

TEST(SbaBatches, MayBeMixedWithEdgesOfClients) {
  int made = 0;
  const auto mixed = [&]() { return made++ % 3 == 0 ? client_edge() : library_edge(); };
  Scene ours(400, mixed), plain(400, client_edge);
  expect_same(ours.system(), plain.system());
  const double chi2 = plain.chi2_after(5);
  EXPECT_NEAR(ours.chi2_after(5), chi2, 1e-9 * chi2);
}

TEST(SbaBatches, GiveTheSameInDogleg) {
  Scene ours(400, library_edge), plain(400, client_edge);
  for (Scene* scene : {&ours, &plain}) {
    auto solver =
        std::make_unique<Solver>(std::make_unique<g2o::LinearSolverEigen<Solver::PoseMatrixType>>());
    scene->optimizer.setAlgorithm(new g2o::OptimizationAlgorithmDogleg(std::move(solver)));
  }
  const double chi2 = plain.chi2_after(5);
  EXPECT_NEAR(ours.chi2_after(5), chi2, 1e-9 * chi2);
}

TEST(SbaBatches, ComputeErrorsAndJacobiansOfAClientsEdgeOncePerTrial) {
  Scene scene(400, client_edge);
  scene.optimizer.optimize(1);
  for (const g2o::EdgeSE3ProjectXYZ* edge : scene.edges) {
    const auto& client = static_cast<const ClientEdge&>(*edge);
    ASSERT_EQ(client.errors, 2);  // before and after the step
    ASSERT_EQ(client.jacobians, 1);
  }
}

TEST(SbaBatches, LeaveUpToDateErrorsInTheEdges) {
  Scene scene(400, library_edge);
  scene.optimizer.optimize(3);
  std::vector<g2o::Vector2> errors;
  for (const g2o::EdgeSE3ProjectXYZ* edge : scene.edges) errors.push_back(edge->error());
  scene.optimizer.computeActiveErrors();
  for (std::size_t k = 0; k < errors.size(); ++k) ASSERT_EQ(scene.edges[k]->error(), errors[k]);
}

}  // namespace
