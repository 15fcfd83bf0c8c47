// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/types/dense_prior.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>

#include "boxplus/manifold/se3.h"
#include "boxplus/optimize/optimizer.h"
#include "boxplus/testing/check_jacobians.h"
#include "boxplus/types/between.h"
#include "boxplus/types/prior.h"

namespace boxplus {
namespace {

using Eigen::MatrixXd, Eigen::VectorXd;

MatrixXd random_matrix(int rows, int cols, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  return MatrixXd::NullaryExpr(rows, cols, [&] { return uniform(random); });
}

SE3 random_pose(unsigned seed) {
  const MatrixXd v = random_matrix(7, 1, seed);
  return SE3(Vector3(v.topRows(3)), detail::Quaternion<double>{v(3), v(4), v(5), 1 + v(6) * v(6)});
}

template <class T>
T moved(const T& x, double size, unsigned seed) {
  const VectorXd delta = size * random_matrix(boxplus::detail::tangent_dim(x), 1, seed);
  return Manifold<T>::oplus(x, delta.data());
}

TEST(DensePrior, HasJacobiansThatAgreeWithNumericDerivatives) {
  const std::vector<SE3> poses{random_pose(1), random_pose(2)};
  const std::vector<Vector3> points{Vector3(1, 2, 3)};
  const DensePrior<SE3, Vector3> prior({poses, points}, random_matrix(4, 15, 3), random_matrix(4, 1, 4));
  const std::vector<SE3> x{moved(poses[0], 0.2, 5), moved(poses[1], 0.2, 6)};
  const JacobianCheck check = check_jacobians(prior, x, std::vector<Vector3>{Vector3(2, 2, 1)});
  EXPECT_TRUE(check.ok) << check.message;
}

TEST(DensePrior, FromInformationHasTheChi2OfTheQuadraticForm) {
  const MatrixXd root = random_matrix(3, 5, 1), H = root.transpose() * root;  // of rank 3
  const VectorXd b = H * random_matrix(5, 1, 2);
  const auto prior =
      DensePrior<Vector3, Vector2>::from_information({{Vector3(1, 2, 3)}, {Vector2(4, 5)}}, H, b);
  const std::vector<Vector3> mean{Vector3(1, 2, 3)}, x{Vector3(2, 1, 0)};
  const std::vector<Vector2> second_mean{Vector2(4, 5)}, y{Vector2(4, 7)};
  const VectorXd delta = (VectorXd(5) << 1, -1, -3, 0, 2).finished();
  const double at_mean = prior.error(mean, second_mean).squaredNorm();
  EXPECT_EQ(prior.error(x, y).size(), 3);
  EXPECT_NEAR(prior.error(x, y).squaredNorm() - at_mean, delta.dot(H * delta) + 2 * b.dot(delta), 1e-12);
}

TEST(DensePrior, RefusesSizesThatDoNotMatchAndInvalidInformationMatrices) {
  const std::vector<Vector2> means{Vector2(1, 2)};
  EXPECT_THROW(DensePrior<Vector2>({means}, MatrixXd::Identity(2, 3)), InvalidArgument);
  EXPECT_THROW(DensePrior<Vector2>({means}, MatrixXd::Identity(2, 2), VectorXd::Zero(3)), InvalidArgument);
  EXPECT_THROW(DensePrior<Vector2>::from_information({means}, -MatrixXd::Identity(2, 2)), InvalidArgument);
  EXPECT_THROW(DensePrior<Vector2>::from_information({means}, random_matrix(2, 2, 1)), InvalidArgument);
  Graph graph;
  const std::vector vertices{graph.add_vertex(Vector2(0, 0)), graph.add_vertex(Vector2(0, 0))};
  EXPECT_THROW(graph.add_edge(DensePrior<Vector2>({means}, MatrixXd::Identity(2, 2)), vertices),
               InvalidArgument);
  EXPECT_EQ(graph.edge_count(), 0u);
}

/// A DensePrior on x1 and x2 replaces x0 and its edges.
TEST(DensePrior, ReplacesTheVerticesThatWereMarginalized) {
  // x0 has a prior, and the steps x0 → x1, x1 → x2 and x0 → x2 are measured.
  const auto add_rest = [](Graph& graph, auto x1, auto x2) {
    graph.add_edge(Between<Vector2>(Vector2(1, 0.5)), 3.0, x1, x2);
  };
  Graph whole;
  const auto a0 = whole.add_vertex(Vector2(0, 0)), a1 = whole.add_vertex(Vector2(0, 0)),
             a2 = whole.add_vertex(Vector2(0, 0));
  whole.add_edge(Prior<Vector2>(Vector2(0.1, 0.2)), 2.0, a0);
  whole.add_edge(Between<Vector2>(Vector2(1, 0)), 4.0, a0, a1);
  whole.add_edge(Between<Vector2>(Vector2(2.2, 0.3)), 0.5, a0, a2);
  add_rest(whole, a1, a2);
  ASSERT_EQ(optimize(whole).status, Report::Status::kConverged);

  // H and b of (x0; x1, x2), linearized at zero, without the step x1 → x2.
  MatrixXd H = MatrixXd::Zero(6, 6);
  VectorXd b = VectorXd::Zero(6);
  const auto add = [&](const MatrixXd& J, const Vector2& e, double omega) {
    H += omega * J.transpose() * J;
    b += omega * J.transpose() * e;
  };
  MatrixXd J = MatrixXd::Zero(2, 6);
  J.leftCols(2).setIdentity();
  add(J, Vector2(-0.1, -0.2), 2);
  J.leftCols(2) *= -1;
  J.middleCols(2, 2).setIdentity();
  add(J, Vector2(-1, 0), 4);
  J.middleCols(2, 2).setZero();
  J.rightCols(2).setIdentity();
  add(J, Vector2(-2.2, -0.3), 0.5);
  const MatrixXd gain = H.bottomLeftCorner(4, 2) * H.topLeftCorner(2, 2).inverse();
  const MatrixXd reduced_H = H.bottomRightCorner(4, 4) - gain * H.topRightCorner(2, 4);
  const VectorXd reduced_b = b.tail(4) - gain * b.head(2);

  Graph reduced;
  const auto x1 = reduced.add_vertex(Vector2(5, 5)), x2 = reduced.add_vertex(Vector2(-5, 5));
  reduced.add_edge(
      DensePrior<Vector2>::from_information({{Vector2(0, 0), Vector2(0, 0)}}, reduced_H, reduced_b),
      std::vector{x1, x2});
  add_rest(reduced, x1, x2);
  ASSERT_EQ(optimize(reduced).status, Report::Status::kConverged);
  EXPECT_LE((reduced.estimate(x1) - whole.estimate(a1)).norm(), 1e-9);
  EXPECT_LE((reduced.estimate(x2) - whole.estimate(a2)).norm(), 1e-9);
}

TEST(DensePrior, OverHundredsOfUnknownsIsOptimizedWithinSeconds) {
  Graph graph;
  std::vector<VertexHandle<SE3>> poses;
  std::vector<VertexHandle<Vector3>> points;
  std::tuple<std::vector<SE3>, std::vector<Vector3>> means;
  for (unsigned k = 0; k < 24; ++k) {
    std::get<0>(means).push_back(random_pose(k));
    poses.push_back(graph.add_vertex(moved(std::get<0>(means).back(), 0.1, 100 + k)));
  }
  for (unsigned k = 0; k < 48; ++k) {
    std::get<1>(means).emplace_back(random_matrix(3, 1, 200 + k));
    points.push_back(graph.add_vertex(moved(std::get<1>(means).back(), 0.1, 300 + k)));
  }
  const int size = 24 * 6 + 48 * 3;
  const MatrixXd root = MatrixXd::Identity(size, size) + 0.02 * random_matrix(size, size, 400);
  const auto edge = graph.add_edge(DensePrior<SE3, Vector3>(means, root), poses, points);
  EXPECT_EQ(graph.edge_pools()[edge.pool]->jacobian_source(), detail::JacobianSource::kAnalytic);
  const Report report = optimize(graph);
  EXPECT_EQ(report.status, Report::Status::kConverged);
  EXPECT_EQ(report.scalars, static_cast<unsigned>(size));
  EXPECT_LE(report.chi2_final, 1e-12);
  EXPECT_LE(report.time.total_s, 10);
  for (std::size_t k = 0; k < points.size(); ++k)
    EXPECT_LE((graph.estimate(points[k]) - std::get<1>(means)[k]).norm(), 1e-6);
}

}  // namespace
}  // namespace boxplus
