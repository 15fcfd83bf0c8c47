// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/graph/information.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <limits>

#include "boxplus/graph/graph.h"
#include "boxplus/manifold/rn.h"
#include "boxplus/manifold/se3.h"

namespace boxplus {
namespace {

using testing::HasSubstr;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr auto kPosition = [](const auto& x) { return x.eval(); };

Eigen::Matrix2d matrix2(double a, double b, double c, double d) {
  return (Eigen::Matrix2d() << a, b, c, d).finished();
}

TEST(Information, GivenAsATriangleIsStoredInTheShortestForm) {
  constexpr int kRows = 6;
  std::vector<double> triangle;
  for (int i = 0; i < kRows; ++i) {
    for (int j = i; j < kRows; ++j) triangle.push_back(i != j ? 0 : i < 3 ? 1.5 : 7);
  }
  EXPECT_EQ(Information::upper_triangle(triangle, kRows).kind(), detail::InformationKind::kDiagonal);
  EXPECT_EQ(Information::upper_triangle(triangle, kRows).values().size(), 6u);
  triangle[1] = 0.25;
  EXPECT_EQ(Information::upper_triangle(triangle, kRows).kind(), detail::InformationKind::kFull);
  for (double& value : triangle) value = value == 0 || value == 0.25 ? 0 : 4;
  EXPECT_EQ(Information::upper_triangle(triangle, kRows).kind(), detail::InformationKind::kScalar);
}

TEST(Information, IsStoredAsScalarDiagonalOrFullMatrix) {
  EXPECT_EQ(Information(2.0).kind(), detail::InformationKind::kScalar);
  EXPECT_EQ(Information(Eigen::Matrix3d::Identity()).kind(), detail::InformationKind::kScalar);
  EXPECT_EQ(Information(Eigen::Matrix3d::Identity()).values().size(), 1u);
  EXPECT_EQ(Information(matrix2(1, 0, 0, 2)).kind(), detail::InformationKind::kDiagonal);
  EXPECT_EQ(Information(matrix2(2, 1, 1, 2)).kind(), detail::InformationKind::kFull);
  EXPECT_EQ(Information(matrix2(2, 1, 1, 2)).values().size(), 3u);
}

TEST(Information, OfEachKindActsLikeItsDenseMatrix) {
  const std::array triangle{4.0, 1.0, 0.5, 3.0, -1.0, 2.0};
  const std::array diagonal{4.0, 3.0, 2.0};
  const Eigen::Vector3d e(1, -2, 3);
  for (const Information& information :
       {Information(5.0), Information::diagonal(diagonal), Information::upper_triangle(triangle, 3)}) {
    const detail::InformationView view{information.kind(), 3, information.values().data()};
    const Eigen::Matrix3d dense = view.matrix();
    EXPECT_EQ(dense, dense.transpose());
    EXPECT_NEAR(view.squared_norm(e.data()), e.dot(dense * e), 1e-13);
    Eigen::Vector3d product;
    view.apply(e.data(), 1, product.data());
    EXPECT_LE((product - dense * e).norm(), 1e-13);
  }
  EXPECT_EQ(Information::upper_triangle(triangle, 3).values()[4], -1);
}

TEST(Information, OfStandardDeviationsCountsHalfAngles) {
  const Information omega = Information::se3_sigmas(0.1, 0.2);
  EXPECT_EQ(omega.rows(), 6);
  for (int i = 0; i < 3; ++i) {
    EXPECT_DOUBLE_EQ(omega.values()[static_cast<std::size_t>(i)], 100);
    EXPECT_DOUBLE_EQ(omega.values()[static_cast<std::size_t>(i + 3)], 100);
  }
  // A rotation by one standard deviation has the chi2 1, up to the fourth power of the angle.
  const SE3 x(Vector<double, 3>::Zero(), SO3::from_rotation_vector(Vector<double, 3>(0.02, 0, 0)));
  Graph graph;
  graph.add_edge([](const auto& pose) { return pose.minimal(); }, Information::se3_sigmas(1, 0.02),
                 graph.add_vertex(x));
  EXPECT_NEAR(graph.chi2(), 1, 1e-4);
  for (const double wrong : {0.0, -1.0, std::numeric_limits<double>::infinity(), kNan}) {
    EXPECT_THROW(Information::se3_sigmas(wrong, 1), InvalidArgument) << wrong;
    EXPECT_THROW(Information::se3_sigmas(1, wrong), InvalidArgument) << wrong;
  }
}

TEST(Information, OfTheWrongSizeIsRefused) {
  Graph graph;
  const auto a = graph.add_vertex(Eigen::Vector2d(1, 2));
  EXPECT_THROW(graph.add_edge(kPosition, Eigen::Matrix3d::Identity(), a), InvalidArgument);
  EXPECT_THROW(graph.add_edge(kPosition, Eigen::MatrixXd(2, 3), a), InvalidArgument);
  EXPECT_THROW(Information::upper_triangle(std::array{1.0, 2.0}, 2), InvalidArgument);
  EXPECT_EQ(graph.edge_count(), 0u);
}

TEST(Information, WithMoreRowsThanAnyTriangleHasIsRefused) {
  for (const int rows : {65536, 2'000'000'000, std::numeric_limits<int>::max()})
    EXPECT_THROW(Information::upper_triangle(std::array{1.0, 2.0}, rows), InvalidArgument);
  try {
    (void)Information::upper_triangle(std::array{1.0, 2.0}, 2'000'000'000);
  } catch (const InvalidArgument& error) {
    EXPECT_THAT(error.what(), HasSubstr("the 2000000001000000000 values"));
  }
}

TEST(Information, ThatIsNegativeByLittleIsShownWithItsDigits) {
  EXPECT_THAT(Information(-1e-18).complaint(2), HasSubstr("got the diagonal entry -1e-18"));
  EXPECT_THAT(Information(matrix2(-1e-18, 1e-30, 1e-30, 1)).complaint(2), HasSubstr("diagonal entry -1e-18"));
}

TEST(Information, WithoutRowsIsRefused) {
  Graph graph;
  const auto a = graph.add_vertex(Eigen::Vector2d(1, 2));
  EXPECT_THROW(graph.add_edge(kPosition, Information(Eigen::MatrixXd(0, 0)), a), InvalidArgument);
  EXPECT_THROW(graph.add_edge(kPosition, Information::diagonal({}), a), InvalidArgument);
  EXPECT_THROW(graph.add_edge(kPosition, Information::upper_triangle({}, 0), a), InvalidArgument);
  EXPECT_THROW(Information::upper_triangle({}, -1), InvalidArgument);
}

TEST(Information, IsRefusedUnlessItIsSymmetricSemiDefiniteAndFinite) {
  Graph graph;
  const auto a = graph.add_vertex(Eigen::Vector2d(1, 2));
  const auto edge = graph.add_edge(kPosition, 3.0, a);
  const auto revision = graph.revision();
  const auto refused = [&](const auto& omega) {
    EXPECT_THROW(graph.add_edge(kPosition, omega, a), InvalidArgument);
    EXPECT_THROW(graph.set_information(edge, omega), InvalidArgument);
  };
  refused(-1.0);
  refused(kNan);
  refused(std::numeric_limits<double>::infinity());
  refused(matrix2(1, 0, 0, -2));
  refused(matrix2(1, 2, 2, 1));
  refused(matrix2(1e12, 1, 1, -1));
  refused(matrix2(0, 1, 1, 0));
  refused(matrix2(2, 1, 0, 2));
  refused(matrix2(2, 1, kNan, 2));
  refused(matrix2(2, kNan, kNan, 2));
  EXPECT_EQ(graph.edge_count(), 1u);
  EXPECT_EQ(graph.revision(), revision);
  EXPECT_EQ(graph.information(edge)(1, 1), 3);
  EXPECT_EQ(graph.add_edge(kPosition, a).slot, 1u);
}

TEST(Information, IsRefusedWithAMessageThatNamesTheNegativeEigenvalue) {
  EXPECT_THAT(Information(matrix2(1, 2, 2, 1)).complaint(2), HasSubstr("eigenvalue -1"));
}

TEST(Information, MayBeSingular) {
  Graph graph;
  const auto a = graph.add_vertex(Eigen::Vector2d(1, 2));
  EXPECT_EQ(graph.chi2(graph.add_edge(kPosition, matrix2(1, -1, -1, 1), a)), 1);
  EXPECT_EQ(graph.chi2(graph.add_edge(kPosition, matrix2(0, 0, 0, 1), a)), 4);
  EXPECT_EQ(graph.chi2(graph.add_edge(kPosition, 0.0, a)), 0);
}

TEST(Information, MayBeReplacedByOneOfAnotherKind) {
  Graph graph;
  const auto a = graph.add_vertex(Eigen::Vector2d(1, 2));
  const auto edge = graph.add_edge(kPosition, 1.0, a), other = graph.add_edge(kPosition, 7.0, a);
  graph.set_information(edge, matrix2(2, 1, 1, 2));
  EXPECT_EQ(graph.chi2(edge), 14);
  graph.set_information(edge, matrix2(2, 0, 0, 3));
  EXPECT_EQ(graph.chi2(edge), 14);
  EXPECT_EQ(graph.information(edge).kind, detail::InformationKind::kDiagonal);
  graph.set_information(edge, 2.0);
  EXPECT_EQ(graph.chi2(edge), 10);
  EXPECT_EQ(graph.chi2(other), 35);
}

TEST(Information, OfTheSameSizeIsReplacedInPlace) {
  Graph graph;
  const auto edge = graph.add_edge(kPosition, matrix2(2, 1, 1, 2), graph.add_vertex(Eigen::Vector2d(1, 2)));
  const double* values = graph.information(edge).values;
  for (int i = 0; i < 100; ++i) graph.set_information(edge, matrix2(3, 1, 1, 2 + i));
  EXPECT_EQ(graph.information(edge).values, values);
  EXPECT_EQ(graph.information(edge)(1, 1), 101);
}

TEST(Information, ThatIsIndefiniteIsAcceptedOnlyAsGiven) {
  Graph graph;
  const auto a = graph.add_vertex(Eigen::Vector2d(1, -1));
  const Eigen::Matrix2d omega = matrix2(1, 2, 2, 1);
  EXPECT_THROW(graph.add_edge(kPosition, omega, a), InvalidArgument);
  const auto edge = graph.add_edge(kPosition, Information(omega).as_given(), a);
  EXPECT_EQ(graph.chi2(edge), -2);
  EXPECT_THROW(graph.set_information(edge, omega), InvalidArgument);
  EXPECT_THROW(graph.set_information(edge, Information(std::nan("")).as_given()), InvalidArgument);
}

}  // namespace
}  // namespace boxplus
