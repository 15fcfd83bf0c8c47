// SPDX-License-Identifier: BSD-3-Clause
// Every process of mpirun runs all of these tests, with its part of the same graph.
#include "boxplus/mpi/distributed_optimizer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <map>
#include <span>
#include <sstream>
#include <string>
#include <vector>

#include "boxplus/optimize/optimizer.h"
#include "boxplus/robust/huber.h"
#include "boxplus/testing/simulate.h"
#include "boxplus/testing/simulate_bundle.h"
#include "communicator.h"
#include "divide_graph.h"
#include "plugins/mpi_leaks.h"

namespace boxplus {
namespace {

using ::testing::HasSubstr;

int rank() {
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  return rank;
}

int processes() {
  int size = 1;
  MPI_Comm_size(MPI_COMM_WORLD, &size);
  return size;
}

/// A copy with the edges of this process, and with their vertices.
Graph own_part(const Graph& whole) {
  const std::vector<EdgeRef> own = mpi::edges_of_part(whole, rank(), processes());
  Graph part = whole;
  for (const EdgeRef& edge : whole.all_edges()) {
    if (std::ranges::find(own, edge) == own.end()) part.remove(edge);
  }
  for (const VertexRef& vertex : whole.all_vertices()) {
    if (part.edges(vertex).empty()) part.remove(vertex);
  }
  return part;
}

Graph street() {
  return simulate_bundle(BundleShape::kStreet, {.cameras = 30, .points = 400}).graph;
}

Graph sphere() {
  return simulate(World::kSphere, {.poses = 200}).graph;
}

void add_huber(Graph& graph) {
  for (const EdgeRef& edge : graph.all_edges()) graph.set_kernel(edge, Huber(1));
}

/// Requires the optimum of one process, and that runs have the same bits.
void expect_same_optimum(const Graph& graph, const Options& options = {}) {
  constexpr double kRelative = 1e-9;
  Graph whole = graph, part = own_part(graph), again = part;
  const Report expected = optimize(whole, options);
  const DistributedReport report = DistributedOptimizer(MPI_COMM_WORLD, part, options).run();
  EXPECT_TRUE(expected.converged() && report.converged()) << report.message;
  EXPECT_NEAR(report.chi2_initial, expected.chi2_initial, kRelative * expected.chi2_initial);
  EXPECT_NEAR(report.chi2_final, expected.chi2_final, kRelative * expected.chi2_final);
  EXPECT_EQ(report.edges, expected.edges);
  EXPECT_EQ(report.rows, expected.rows);
  EXPECT_EQ(report.eliminated, expected.eliminated);
  EXPECT_EQ(DistributedOptimizer(MPI_COMM_WORLD, again, options).run().chi2_final, report.chi2_final);
}

/// Requires that the run throws InvalidArgument with this text, in every process.
void expect_refused(Graph& graph, const Options& options, const std::string& text) {
  try {
    const DistributedReport report = DistributedOptimizer(MPI_COMM_WORLD, graph, options).run();
    ADD_FAILURE() << report.message;
  } catch (const InvalidArgument& error) {
    EXPECT_THAT(error.what(), HasSubstr(text));
  }
}

TEST(DistributedOptimizer, ReachesTheOptimumOfOneProcessInBundleAdjustment) {
  expect_same_optimum(street());
}

TEST(DistributedOptimizer, ReportsTheWholeProblem) {
  Graph part = own_part(street());
  const DistributedReport report = DistributedOptimizer(MPI_COMM_WORLD, part).run();
  EXPECT_EQ(report.processes, processes());
  EXPECT_EQ(report.kept, 30u);
  EXPECT_EQ(report.sent_bytes > 0, processes() > 1);
}

TEST(DistributedOptimizer, ReachesTheOptimumOfOneProcessIfPosesAndCamerasAreVertices) {
  for (const BundleIntrinsics intrinsics : {BundleIntrinsics::kSeparate, BundleIntrinsics::kShared}) {
    expect_same_optimum(
        simulate_bundle(BundleShape::kRing, {.cameras = 12, .points = 200, .intrinsics = intrinsics}).graph);
  }
}

TEST(DistributedOptimizer, ReachesTheOptimumOfOneProcessInPoseGraphs) {
  for (const AlgorithmKind algorithm :
       {AlgorithmKind::kDogleg, AlgorithmKind::kLevenbergMarquardt, AlgorithmKind::kGaussNewton})
    expect_same_optimum(sphere(), {.algorithm = algorithm});
}

TEST(DistributedOptimizer, ReachesTheOptimumOfOneProcessWithRobustKernels) {
  for (Graph graph : {street(), sphere()}) {
    add_huber(graph);
    expect_same_optimum(graph, {.noise_tolerance = 0});
  }
}

TEST(DistributedOptimizer, LeavesTheSameEstimatesInAllProcesses) {
  Graph part = own_part(sphere());
  (void)DistributedOptimizer(MPI_COMM_WORLD, part).run();
  mpi::Communicator communicator(MPI_COMM_WORLD);
  std::ostringstream values;
  values << std::hexfloat;
  for (const VertexRef& vertex : part.all_vertices())
    values << part.id(vertex) << ' ' << part.estimate(part.typed<SE3>(vertex)).translation().x() << '\n';
  std::map<std::string, std::string> shared;
  for (const std::string& text : communicator.gather(values.str())) {
    std::istringstream lines(text);
    for (std::string id, value; lines >> id >> value;)
      EXPECT_EQ(shared.try_emplace(id, value).first->second, value) << "vertex " << id;
  }
}

TEST(DistributedOptimizer, DampsGaugeFreedomIfNothingIsFixed) {
  Graph graph = sphere();
  for (const VertexRef& vertex : graph.all_vertices()) graph.unfix(vertex);
  Graph whole = graph, part = own_part(graph);
  const double expected = optimize(whole).chi2_final;
  const DistributedReport report = DistributedOptimizer(MPI_COMM_WORLD, part).run();
  EXPECT_TRUE(report.converged()) << report.message;
  EXPECT_NEAR(report.chi2_final, expected, 1e-9 * expected);
}

TEST(DistributedOptimizer, WorksIfOnlyOneProcessHasEdges) {
  Graph whole = sphere(), part = rank() == processes() - 1 ? whole : Graph();
  const double expected = optimize(whole).chi2_final;
  const DistributedReport report = DistributedOptimizer(MPI_COMM_WORLD, part).run();
  EXPECT_NEAR(report.chi2_final, expected, 1e-9 * expected);
}

TEST(DistributedOptimizer, HasNothingToDoWithoutEdges) {
  Graph empty;
  const DistributedReport report = DistributedOptimizer(MPI_COMM_WORLD, empty).run();
  EXPECT_EQ(report.reason, Report::Reason::kNothingToOptimize);
}

TEST(DistributedOptimizer, ThrowsInAllProcessesIfAnErrorFunctionOfOneThrows) {
  Graph part = own_part(street());
  int calls = 0;
  if (rank() == processes() - 1) {
    const auto vertex = part.add_vertex(Vector<double, 1>(0.5));
    part.add_edge(
        [&calls](const Vector<double, 1>& x) -> Vector<double, 1> {
          if (++calls > 8) throw InvalidArgument("the sensor is broken");
          return x;
        },
        vertex);
  }
  expect_refused(part, {}, "the sensor is broken");
}

TEST(DistributedOptimizer, FailsInAllProcessesIfAnErrorOfOneIsNotFinite) {
  Graph part = own_part(street());
  if (rank() == processes() - 1) {
    const auto vertex = part.add_vertex(Vector<double, 1>(0.5), 987654);
    part.add_edge([](const Vector<double, 1>& x) { return Vector<double, 1>(x / 0.0 - x / 0.0); }, vertex);
  }
  const DistributedReport report = DistributedOptimizer(MPI_COMM_WORLD, part).run();
  EXPECT_EQ(report.status, Report::Status::kFailed);
  EXPECT_EQ(report.reason, Report::Reason::kNotFinite);
  EXPECT_THAT(report.message, HasSubstr("987654"));
}

TEST(DistributedOptimizer, EndsAlikeInAllProcessesIfAPointOfOneIsNotDetermined) {
  for (const AlgorithmKind algorithm : {AlgorithmKind::kGaussNewton, AlgorithmKind::kLevenbergMarquardt}) {
    Graph part = own_part(street());
    if (rank() == processes() - 1) {
      const auto vertex = part.add_vertex(Vector<double, 2>(0.5, 0.5));
      part.set_eliminated(vertex, true);
      part.add_edge([](const Vector<double, 2>& x) { return Vector<double, 1>(x[0]); }, vertex);
    }
    const DistributedReport report =
        DistributedOptimizer(MPI_COMM_WORLD, part, {.algorithm = algorithm}).run();
    mpi::Communicator communicator(MPI_COMM_WORLD);
    for (const std::string& message : communicator.gather(report.message)) EXPECT_EQ(message, report.message);
    EXPECT_EQ(communicator.max(report.chi2_final), report.chi2_final);
    EXPECT_EQ(communicator.max(report.iterations), report.iterations);
  }
}

TEST(DistributedOptimizer, RefusesOptionsThatDifferBetweenProcesses) {
  if (processes() == 1) GTEST_SKIP() << "one process";
  Graph part = own_part(sphere());
  expect_refused(part, {.max_iterations = rank() == 1 ? 7 : 100}, "max_iterations 7 in process 1");
}

TEST(DistributedOptimizer, RefusesVerticesThatDifferBetweenProcesses) {
  if (processes() == 1) GTEST_SKIP() << "one process";
  Graph graph = sphere();
  if (rank() == 1) graph.fix(*graph.find_vertex(3));
  Options options;
  options.edges = mpi::edges_of_part(graph, rank(), processes());
  expect_refused(graph, options, "vertex 3 is not the same in the processes 0 and 1");
}

TEST(DistributedOptimizer, RefusesMoreKeptVerticesThanItsLimit) {
  Graph part;
  for (int i = 0; i <= static_cast<int>(DistributedOptimizer::kMostKept); ++i) {
    const auto vertex = part.add_vertex(Vector<double, 1>(1.0), i);
    part.add_edge([](const Vector<double, 1>& x) { return x; }, vertex);
  }
  expect_refused(part, {}, "expected at most 20000 vertices that are not eliminated");
}

TEST(DistributedOptimizer, RefusesWhatNeedsTheWholeGraph) {
  Graph part = own_part(sphere());
  expect_refused(part, {.start = Start::kChordal}, "the start 'chordal'");
  expect_refused(part, {.gauge = GaugePolicy::kError}, "GaugePolicy::kError");
  expect_refused(part, {.schur = SchurMode::kImplicit}, "SchurMode::kImplicit");
}

TEST(DistributedOptimizer, EndsInAllProcessesIfOneIsStopped) {
  Graph part = own_part(street());
  const std::atomic<bool> stop = rank() == processes() - 1;
  Options options;
  options.stop = &stop;
  const DistributedReport report = DistributedOptimizer(MPI_COMM_WORLD, part, options).run();
  EXPECT_EQ(report.status, Report::Status::kNotConverged);
  EXPECT_EQ(report.iterations, 0);
}

TEST(Communicator, ShowsTheFirstProcessTheItemsOfAllInTheOrderOfRanks) {
  constexpr std::size_t kCount = 2'500'000;  // several messages
  mpi::Communicator communicator(MPI_COMM_WORLD);
  const std::vector<std::uint64_t> here(kCount * static_cast<std::size_t>(rank() % 2), 7);
  std::vector<std::size_t> sizes;
  communicator.visit_at_first(here, [&](std::span<const std::uint64_t> items) {
    sizes.push_back(items.size());
    EXPECT_TRUE(std::ranges::all_of(items, [](std::uint64_t item) { return item == 7; }));
  });
  ASSERT_EQ(sizes.size(), rank() == 0 ? static_cast<std::size_t>(processes()) : 0);
  for (std::size_t k = 0; k < sizes.size(); ++k) EXPECT_EQ(sizes[k], kCount * (k % 2));
}

TEST(Communicator, FailsInAllProcessesIfTheFirstRefusesAnItem) {
  mpi::Communicator communicator(MPI_COMM_WORLD);
  const std::vector<std::uint64_t> here(100'000, 7);  // too many for a message that nobody waits for
  const auto visit = [&] {
    communicator.visit_at_first(here, [](std::span<const std::uint64_t>) { throw InvalidArgument("no"); });
    (void)communicator.sum(1);
  };
  EXPECT_THROW(communicator.together(visit), InvalidArgument);
}

TEST(EdgesOfPart, AreAllEdgesInEqualNumbersAndThoseOfAPointTogether) {
  constexpr int kParts = 3;
  const Graph graph = street();
  std::size_t count = 0;
  std::map<Id, int> part_of_point;
  for (int part = 0; part < kParts; ++part) {
    const std::vector<EdgeRef> edges = mpi::edges_of_part(graph, part, kParts);
    EXPECT_NEAR(static_cast<double>(edges.size()), static_cast<double>(graph.edge_count()) / kParts,
                0.05 * static_cast<double>(graph.edge_count()));
    count += edges.size();
    for (const EdgeRef& edge : edges) {
      for (const VertexRef& vertex : graph.vertices(edge)) {
        if (graph.is_eliminated(vertex)) {
          EXPECT_EQ(part_of_point.try_emplace(graph.id(vertex), part).first->second, part);
        }
      }
    }
  }
  EXPECT_EQ(count, graph.edge_count());
}

TEST(PartsOfEliminated, AreThoseOfTheEdgesOfTheGraph) {
  constexpr int kParts = 3;
  constexpr std::uint32_t kCameras = 30, kPoints = 400;
  const Graph graph = street();
  std::vector<std::uint64_t> pairs;
  for (const EdgeRef& edge : graph.all_edges()) {
    const std::vector<VertexRef> ends = graph.vertices(edge);
    pairs.push_back(((static_cast<std::uint64_t>(graph.id(ends[1])) - kCameras) << 32) +
                    static_cast<std::uint64_t>(graph.id(ends[0])));
  }
  const std::vector<std::uint32_t> parts = mpi::parts_of_eliminated(pairs, kPoints, kCameras, kParts);
  for (int part = 0; part < kParts; ++part) {
    for (const EdgeRef& edge : mpi::edges_of_part(graph, part, kParts)) {
      const Id point = graph.id(graph.vertices(edge)[1]) - Id{kCameras};
      EXPECT_EQ(parts[static_cast<std::size_t>(point)], static_cast<std::uint32_t>(part));
    }
  }
}

}  // namespace
}  // namespace boxplus

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  ::testing::InitGoogleMock(&argc, argv);
  const int failed = RUN_ALL_TESTS();
  MPI_Finalize();
  return failed;
}
