// SPDX-License-Identifier: BSD-3-Clause
// If the columns of eliminated vertices are recomputed instead of stored, all results are the same.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstring>
#include <numeric>
#include <optional>
#include <random>

#include "boxplus/robust/huber.h"
#include "boxplus/types/ba.h"
#include "kernels/kernel_table.h"
#include "linearize/dense_reference.h"

namespace boxplus {
namespace {

using Camera = Product<SE3, BalCamera>;

/// Measures a point relative to the midpoint of two cameras.
struct Midpoint {
  Vector3 measurement;
  template <class S>
  Vector<S, 3> error(const Product<BasicSE3<S>, BasicCamera<BalCamera::Model, S>>& a,
                     const Vector<S, 3>& point,
                     const Product<BasicSE3<S>, BasicCamera<BalCamera::Model, S>>& b) const {
    return point - S(0.5) * (a.template get<0>().translation() + b.template get<0>().translation()) -
           measurement;
  }
};

struct PointPrior {
  Vector3 measurement;
  template <class S>
  Vector<S, 3> error(const Vector<S, 3>& point) const {
    return point - measurement;
  }
};

struct FocalLengthPrior {
  template <class S>
  Vector<S, 1> error(const Product<BasicSE3<S>, BasicCamera<BalCamera::Model, S>>& camera) const {
    return Vector<S, 1>((camera.template get<1>().parameters[0] - S(500)) / S(10));
  }
};

/// Cameras and eliminated points, with reprojection errors that are linearized in lanes, edges with three
/// vertices, unary edges, Ω of all kinds, robust kernels, disabled edges, a fixed camera and a fixed point.
Graph varied_bundle(int points, bool with_midpoints = true) {
  Graph graph;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const auto noise = [&] { return Vector3(uniform(random), uniform(random), uniform(random)); };
  std::vector<VertexHandle<Camera>> cameras;
  for (int k = 0; k < 7; ++k) {
    const SE3 pose =
        SE3::from_minimal((Vector<double, 6>() << k, noise().head<2>(), 0.05 * noise()).finished());
    cameras.push_back(graph.add_vertex(Camera(pose, BalCamera(500 + k, -0.1, 0.03))));
    graph.add_edge(FocalLengthPrior{}, 1.0, cameras.back());
  }
  graph.fix(cameras[2]);
  const Eigen::Matrix2d full = (Eigen::Matrix2d() << 2, 0.5, 0.5, 1).finished();
  const Eigen::Matrix3d full3 = Eigen::Matrix3d::Identity() + Eigen::Matrix3d::Constant(0.1);
  for (std::size_t p = 0; p < static_cast<std::size_t>(points); ++p) {
    const Vector3 at = Vector3(3, 0, -9) + 2 * noise();
    const auto point = graph.add_vertex(at);
    graph.set_eliminated(point, true);
    if (p % 9 == 4) graph.fix(point);
    for (std::size_t k = 0; k < 5; ++k) {
      const VertexHandle<Camera> camera = cameras[(p + k) % cameras.size()];
      const Vector2 pixel = 100 * noise().head<2>();
      const Information information =
          (p + k) % 3 == 0 ? Information(full) : Information(0.5 + uniform(random) / 4);
      const auto edge = graph.add_edge(Reprojection<BalCamera>(pixel), information, camera, point);
      if ((p + k) % 5 == 0) graph.set_kernel(edge, Huber(40));
      if ((p + k) % 11 == 0) graph.set_enabled(edge, false);
    }
    if (with_midpoints && p % 2 == 0)
      graph.add_edge(Midpoint{noise()}, full3, cameras[p % 5], point, cameras[p % 5 + 2]);
    if (p % 7 == 0) graph.add_edge(PointPrior{at + noise()}, 2.0, point);
  }
  return graph;
}

bool same_bits(std::span<const double> a, std::span<const double> b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size_bytes()) == 0;
}

class RecomputedColumns : public testing::TestWithParam<int> {
 protected:
  RecomputedColumns()
      : graph_(varied_bundle(700)),
        stored_(make_plan(graph_, {.threads = GetParam()})),
        recomputed_(make_plan(graph_, {.threads = GetParam(), .columns = ColumnStorage::kBatch})) {}

  Eigen::VectorXd a_vector() const { return Eigen::VectorXd::LinSpaced(stored_.scalars(), -1, 2); }

  /// Compares subtract_coupling() with a product of H.
  void expect_product_of_coupling(const LinearizeOptions& options) const {
    Linearizer all(graph_, stored_), batch(graph_, recomputed_);
    all.linearize(options);
    const Eigen::MatrixXd hessian = dense_matrix(stored_.structure, all.values());
    const Eigen::Index eliminated = stored_.structure.offset[stored_.eliminated_blocks],
                       kept = hessian.rows() - eliminated;
    Eigen::VectorXd expected = a_vector(), actual = expected;
    expected.head(eliminated) -= hessian.bottomLeftCorner(kept, eliminated).transpose() * expected.tail(kept);
    std::atomic<std::uint32_t> columns = 0;
    const int groups = static_cast<int>(recomputed_.chunks.size());
    batch.subtract_coupling(options, groups, actual.data(), [&](const Linearizer::Batch& b) {
      EXPECT_EQ(b.values, nullptr);
      columns += b.last - b.first;
    });
    EXPECT_EQ(columns, recomputed_.eliminated_blocks);
    EXPECT_LE((actual - expected).norm(), 1e-12 * expected.norm());
  }

  Graph graph_;
  Plan stored_, recomputed_;
};

TEST_P(RecomputedColumns, NeedMemoryForOneBatchPerChunk) {
  ASSERT_EQ(stored_.columns, ColumnStorage::kAll);
  ASSERT_EQ(recomputed_.columns, ColumnStorage::kBatch);
  ASSERT_GT(recomputed_.chunks.size(), 1u);
  EXPECT_EQ(recomputed_.structure, stored_.structure);
  const Linearizer linearizer(graph_, recomputed_);
  EXPECT_EQ(linearizer.values().size(), recomputed_.shared_values());
  std::size_t window = 0;
  for (const Chunk& chunk : recomputed_.chunks) window += chunk.window.size;
  EXPECT_LT(window, recomputed_.eliminated_values() * 3 / 4);
}

TEST_P(RecomputedColumns, AreReportedWithTheBitsThatWouldBeStored) {
  Linearizer all(graph_, stored_), batch(graph_, recomputed_);
  all.linearize({});
  std::vector<int> differences(recomputed_.chunks.size(), 0);
  std::vector<std::uint32_t> columns(differences.size(), 0);
  batch.linearize({}, static_cast<int>(differences.size()), [&](const Linearizer::Batch& b) {
    const std::span<const double> expected = all.values().subspan(
        stored_.first_value(b.first), stored_.first_value(b.last) - stored_.first_value(b.first));
    const auto group = static_cast<std::size_t>(b.slice);
    differences[group] += !same_bits({b.values, expected.size()}, expected);
    columns[group] += b.last - b.first;
  });
  EXPECT_EQ(std::count(differences.begin(), differences.end(), 0), std::ssize(differences));
  EXPECT_EQ(std::accumulate(columns.begin(), columns.end(), 0u), stored_.eliminated_blocks);
  EXPECT_TRUE(same_bits(batch.values(), all.values().last(stored_.shared_values())));
  EXPECT_TRUE(same_bits(batch.gradient(), all.gradient()));
}

TEST_P(RecomputedColumns, GiveTheProductOfTheCouplingWithAVectorByEveryKernel) {
  const dense::KernelTable& before = dense::kernels();
  for (const dense::KernelTable* table : dense::usable_kernels()) {
    dense::use_kernels(*table);
    for (const bool triggs : {false, true}) expect_product_of_coupling({.triggs_correction = triggs});
  }
  dense::use_kernels(before);
}

TEST_P(RecomputedColumns, GiveTheCurvatureAlongAVector) {
  Linearizer all(graph_, stored_), batch(graph_, recomputed_);
  const Eigen::VectorXd d = a_vector();
  for (const bool triggs : {false, true}) {
    const LinearizeOptions options{.triggs_correction = triggs};
    all.linearize(options);
    const double expected = d.dot(dense_matrix(stored_.structure, all.values()) * d);
    EXPECT_NEAR(batch.curvature(options, d.data()), expected, 1e-12 * expected);
  }
}

TEST_P(RecomputedColumns, GiveTheSameBitsForAnyNumberOfThreads) {
  const Plan plan = make_plan(graph_, {.threads = 1, .columns = ColumnStorage::kBatch});
  Linearizer one(graph_, plan), several(graph_, recomputed_);
  const int groups = static_cast<int>(plan.chunks.size());
  Eigen::VectorXd x = a_vector(), y = x;
  one.subtract_coupling({}, groups, x.data(), [](const Linearizer::Batch&) {});
  several.subtract_coupling({}, groups, y.data(), [](const Linearizer::Batch&) {});
  EXPECT_EQ(x, y);
  EXPECT_EQ(one.curvature({}, x.data()), several.curvature({}, x.data()));
}

INSTANTIATE_TEST_SUITE_P(Threads, RecomputedColumns, testing::Values(1, 2, 3),
                         ::testing::PrintToStringParamName());

TEST(TriggsCorrection, OfEdgesInLanesEqualsTheDenseReference) {
  const Graph graph = varied_bundle(30);
  expect_equals_reference(graph, make_plan(graph, {}), {.triggs_correction = true});
}

TEST(ColumnStorage, IsAllWithFixedDirectionsOfEliminatedVerticesAndWithoutElimination) {
  Graph graph = varied_bundle(20);
  EXPECT_EQ(make_plan(graph, {.columns = ColumnStorage::kBatch}).columns, ColumnStorage::kBatch);
  std::optional<VertexRef> kept, eliminated;
  for (const VertexRef& vertex : graph.all_vertices())
    (graph.is_eliminated(vertex) ? eliminated : kept) = vertex;
  graph.fix_directions(*kept, {1});
  EXPECT_EQ(make_plan(graph, {.columns = ColumnStorage::kBatch}).columns, ColumnStorage::kBatch);
  graph.fix_directions(*eliminated, {1});
  EXPECT_EQ(make_plan(graph, {.columns = ColumnStorage::kBatch}).columns, ColumnStorage::kAll);
  graph.fix_directions(*eliminated, {});
  EXPECT_EQ(make_plan(graph, {.columns = ColumnStorage::kBatch}).columns, ColumnStorage::kBatch);
  for (const VertexRef& vertex : graph.all_vertices()) graph.fix_directions(vertex, {0});
  EXPECT_EQ(make_plan(graph, {.columns = ColumnStorage::kBatch}).columns, ColumnStorage::kAll);
  graph = varied_bundle(20);
  for (const VertexRef& vertex : graph.all_vertices()) graph.set_eliminated(vertex, false);
  EXPECT_EQ(make_plan(graph, {.columns = ColumnStorage::kBatch}).columns, ColumnStorage::kAll);
}

TEST(ColumnStorage, IsOneBatchIfTheColumnsExceedTheCacheAndTheirJacobiansAreCheap) {
  const auto choice = [](int points, bool with_midpoints) {
    return make_plan(varied_bundle(points, with_midpoints), {.columns = ColumnStorage::kAutomatic}).columns;
  };
  EXPECT_EQ(choice(100, false), ColumnStorage::kAll);
  EXPECT_EQ(choice(5000, false), ColumnStorage::kBatch);
  EXPECT_EQ(choice(5000, true), ColumnStorage::kAll);  // Midpoint is differentiated automatically
}

}  // namespace
}  // namespace boxplus
