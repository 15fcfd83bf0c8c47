// SPDX-License-Identifier: BSD-3-Clause
// Collections of photos, in which almost half of all pairs of cameras share points.
#include <gtest/gtest.h>

#include <tuple>
#include <vector>

#include "boxplus/optimize/optimizer.h"
#include "boxplus/testing/simulate_bundle.h"

namespace boxplus {
namespace {

/// Optimizes a small collection of photos from its initial estimates.
Report optimize_photos(const Options& options, std::vector<double>* cameras = nullptr) {
  constexpr int kPhotos = 30;
  Graph graph =
      simulate_bundle(BundleShape::kCollection, {.cameras = kPhotos, .points = 1500, .track_length = 6})
          .graph;
  Report report = optimize(graph, options);
  for (Id id = 0; cameras != nullptr && id < kPhotos; ++id) {
    const auto& camera = graph.estimate(graph.vertex<Product<SE3, BalCamera>>(id));
    const Vector3 place = camera.get<0>().translation();
    cameras->insert(cameras->end(), place.data(), place.data() + 3);
  }
  return report;
}

TEST(PhotoCollection, LetsPcgTakeRoughStepsUnlessTheToleranceIsSet) {
  const Report rough = optimize_photos({.linear_solver = LinearSolverKind::kPcg});
  const Report same = optimize_photos({.linear_solver = LinearSolverKind::kPcg, .linear_tolerance = 0.01});
  const Report exact = optimize_photos({.linear_solver = LinearSolverKind::kPcg, .linear_tolerance = 1e-10});
  EXPECT_TRUE(rough.converged()) << rough;
  EXPECT_NEAR(rough.chi2_final / exact.chi2_final, 1, 1e-6);
  EXPECT_EQ(rough.records.front().linear_iterations, same.records.front().linear_iterations);
  EXPECT_GE(exact.records.front().linear_iterations, 5 * rough.records.front().linear_iterations);
}

TEST(PhotoCollection, HasTheSameBitsForOneTwoAndThreeThreads) {
  for (const auto solver : {LinearSolverKind::kBlockCholesky, LinearSolverKind::kPcg}) {
    std::vector<double> one;
    std::ignore = optimize_photos({.linear_solver = solver, .max_iterations = 4, .threads = 1}, &one);
    for (const int threads : {2, 3}) {
      std::vector<double> more;
      std::ignore =
          optimize_photos({.linear_solver = solver, .max_iterations = 4, .threads = threads}, &more);
      EXPECT_EQ(one, more) << to_string(solver) << ", " << threads << " threads";
    }
  }
}

}  // namespace
}  // namespace boxplus
