// SPDX-License-Identifier: BSD-3-Clause
// Graphs that are large enough for several threads. All threads together must compute the same sums as a
// single thread, and only the calling thread may call types that are not declared as thread-safe.
#include "g2o/core/thread_safe.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <mutex>
#include <set>
#include <thread>
#include <vector>

#include "g2o/core/robust_kernel_impl.h"
#include "g2o/core/small_graph.h"
#include "g2o/normal_equations.h"

namespace {

using Threads = std::set<std::thread::id>;

/// A client's edge: an EdgeSE2 that records the threads that call it.
struct ClientEdge : g2o::EdgeSE2 {
  explicit ClientEdge(Threads& seen) : threads(seen) {}
  void computeError() override {
    threads.insert(std::this_thread::get_id());
    EdgeSE2::computeError();
  }
  void linearizeOplus() override {
    threads.insert(std::this_thread::get_id());
    EdgeSE2::linearizeOplus();
  }
  Threads& threads;
};

/// A client's edge that also records the threads, but that several threads may call at once.
struct GuardedEdge : g2o::EdgeSE2 {
  explicit GuardedEdge(Threads& seen) : threads(seen) {}
  void computeError() override {
    {
      static std::mutex mutex;
      const std::lock_guard<std::mutex> lock(mutex);
      threads.insert(std::this_thread::get_id());
    }
    EdgeSE2::computeError();
  }
  Threads& threads;
};

/// A client's kernel, ρ(e²) = e², which records the threads that call it.
struct ClientKernel : g2o::RobustKernel {
  explicit ClientKernel(Threads& seen) : threads(seen) {}
  void robustify(double e2, g2o::Vector3& rho) const override {
    threads.insert(std::this_thread::get_id());
    rho << e2, 1, 0;
  }
  Threads& threads;
};

/// A graph of a robot that drives around a block in several rounds. Each pose has an edge from the previous
/// pose, and an edge from the pose one round earlier.
struct Drive {
  static constexpr int kPoses = 900, kRound = 50;

  template <class MakeEdge>
  explicit Drive(MakeEdge make_edge) {
    auto linear = std::make_unique<small_graph::LinearSolver>();
    linear->setExact(true);
    auto made = std::make_unique<g2o::BlockSolverX>(std::move(linear));
    solver = made.get();
    optimizer.setAlgorithm(std::make_unique<g2o::OptimizationAlgorithmGaussNewton>(std::move(made)));
    for (int k = 0; k < kPoses; ++k) {
      auto* v = new g2o::VertexSE2;
      v->setId(k);
      v->setEstimate(g2o::SE2(std::cos(0.13 * k) * k, 0.3 * k, 0.11 * k));
      v->setFixed(k == 0);
      optimizer.addVertex(v);
      if (k > 0) add(make_edge(), k - 1, k);
      if (k >= kRound) add(make_edge(), k - kRound, k);
    }
    optimizer.initializeOptimization();
  }
  void add(g2o::EdgeSE2* e, int from, int to) {
    e->setVertex(0, optimizer.vertex(from));
    e->setVertex(1, optimizer.vertex(to));
    e->setMeasurement(g2o::SE2(0.1 * (to - from), 0.02 * (to % 7), 0.01 * (from % 5)));
    g2o::Matrix3 omega = g2o::Vector3(1 + to % 3, 2, 3 + from % 2).asDiagonal();
    omega(0, 1) = omega(1, 0) = 0.25;
    e->setInformation(omega);
    optimizer.addEdge(e);
  }
  std::vector<double> system() { return normal_equations::of(optimizer, *solver); }

  g2o::SparseOptimizer optimizer;
  g2o::BlockSolverX* solver = nullptr;
};

void expect_same_sums(const std::vector<double>& a, const std::vector<double>& b) {
  ASSERT_EQ(a.size(), b.size());
  double largest = 0;
  for (const double x : a) largest = std::max(largest, std::abs(x));
  for (std::size_t k = 0; k < a.size(); ++k) ASSERT_NEAR(a[k], b[k], 1e-11 * largest) << k;
}

TEST(ThreadSafe, LibraryEdgesOnAllThreadsGiveTheSameSystemAsClientEdgesOnOneThread) {
  Threads threads;
  Drive ours([] { return new g2o::EdgeSE2; });
  Drive theirs([&] { return new ClientEdge(threads); });
  ASSERT_GT(ours.optimizer.activeEdges().size(), 1000u);
  expect_same_sums(ours.system(), theirs.system());
  EXPECT_EQ(threads, Threads{std::this_thread::get_id()});
  EXPECT_NEAR(ours.optimizer.activeChi2(), theirs.optimizer.activeChi2(),
              1e-12 * ours.optimizer.activeChi2());
}

TEST(ThreadSafe, RepeatedComputationsOfTheSystemAreBitIdentical) {
  Drive first([] { return new g2o::EdgeSE2; }), second([] { return new g2o::EdgeSE2; });
  const std::vector<double> sums = first.system();
  EXPECT_EQ(sums, first.system());
  EXPECT_EQ(sums, second.system());
}

TEST(ThreadSafe, LibraryKernelsRunOnAllThreadsAndClientKernelsOnTheCallingThread) {
  Threads threads;
  Drive plain([] { return new g2o::EdgeSE2; }), robust([] { return new g2o::EdgeSE2; }),
      theirs([] { return new g2o::EdgeSE2; });
  for (auto* e : robust.optimizer.activeEdges()) {
    auto* wide = new g2o::RobustKernelHuber;
    wide->setDelta(1e9);
    e->setRobustKernel(wide);
  }
  int number = 0;
  for (auto* e : theirs.optimizer.activeEdges()) {
    if (++number % 3 == 0) e->setRobustKernel(new ClientKernel(threads));
  }
  const std::vector<double> sums = plain.system();
  expect_same_sums(sums, robust.system());
  expect_same_sums(sums, theirs.system());
  EXPECT_EQ(threads, Threads{std::this_thread::get_id()});
}

/// A client's edge that a test declares as thread-safe.
struct DeclaredEdge : g2o::EdgeSE2 {};

TEST(ThreadSafe, ClientEdgesThatAreDeclaredThreadSafeGiveTheSameSystem) {
  Drive alone([] { return new DeclaredEdge; });
  const std::vector<double> sums = alone.system();
  const g2o::ThreadSafe<DeclaredEdge> declaration;
  Drive together([] { return new DeclaredEdge; });
  expect_same_sums(sums, together.system());
  EXPECT_EQ(together.system(), Drive([] { return new g2o::EdgeSE2; }).system());
}

TEST(ThreadSafe, AWithdrawnDeclarationTakesEffectWithoutANewInitialization) {
  Threads threads;
  Drive drive([&] { return new GuardedEdge(threads); });
  {
    const g2o::ThreadSafe<GuardedEdge> declaration;
    { const g2o::ThreadSafe<GuardedEdge> another; }
    drive.system();
    if (std::thread::hardware_concurrency() > 1) {
      // While the machine is busy, the calling thread may do all the work.
      for (int attempt = 0; threads.size() == 1 && attempt < 1000; ++attempt) drive.system();
      EXPECT_GT(threads.size(), 1u);
    }
  }
  threads.clear();
  drive.system();
  EXPECT_EQ(threads, Threads{std::this_thread::get_id()});
}

TEST(ThreadSafe, TheSystemIncludesEdgesThatWereAddedLaterAndExcludesRemovedEdges) {
  Drive grown([] { return new g2o::EdgeSE2; }), whole([] { return new g2o::EdgeSE2; });
  grown.system();
  auto* extra = new g2o::EdgeSE2;
  grown.add(extra, 10, 700);
  whole.add(new g2o::EdgeSE2, 10, 700);
  for (Drive* drive : {&grown, &whole}) drive->optimizer.initializeOptimization();
  expect_same_sums(grown.system(), whole.system());
  grown.optimizer.removeEdge(extra);
  grown.optimizer.initializeOptimization();
  expect_same_sums(grown.system(), Drive([] { return new g2o::EdgeSE2; }).system());
}

}  // namespace
