// SPDX-License-Identifier: BSD-3-Clause
// Compares exact and numeric Jacobians with each other and with formulas that were derived by hand.
#include "boxplus/graph/differentiate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <tuple>
#include <vector>

#include "boxplus/graph/graph.h"
#include "boxplus/manifold/rn.h"
#include "boxplus/manifold/se2.h"
#include "boxplus/manifold/se3.h"

namespace boxplus {

/// A vertex type of tangent dimension 0.
struct Frozen {
  double value;
};

template <>
struct Manifold<Frozen> {
  template <class S>
  using Rebind = Frozen;
  static constexpr int kDim = 0;
  template <class D>
  static Frozen oplus(const Frozen& x, const D*) {
    return x;
  }
  static void ominus(const Frozen&, const Frozen&, double*) {}
  template <class S>
  static Frozen cast(const Frozen& x) {
    return x;
  }
};

/// A scalar that counts its conversions to dual numbers.
template <class S>
struct Counted {
  S value;
  static inline int lifts = 0;
};

template <class T>
struct Manifold<Counted<T>> {
  template <class S>
  using Rebind = Counted<S>;
  static constexpr int kDim = 1;
  template <class D>
  static auto oplus(const Counted<T>& x, const D* delta) {
    return Counted<std::remove_cvref_t<decltype(x.value + delta[0])>>{x.value + delta[0]};
  }
  static void ominus(const Counted<T>& y, const Counted<T>& x, double* delta) {
    delta[0] = y.value - x.value;
  }
  template <class S>
  static Counted<S> cast(const Counted<T>& x) {
    ++Counted<T>::lifts;
    return {S(x.value)};
  }
};

namespace {

/// The exact Jacobian of `e` at x. Checks that the numeric Jacobian agrees with the exact one, and that both
/// ways of differentiation also return the right error.
template <class... V, class E>
Eigen::MatrixXd jacobian(const E& e, int rows, detail::Argument<V>... x) {
  const int cols = (detail::argument_dim<V>(x) + ...);
  Eigen::VectorXd error(rows), numeric_error(rows), value(rows);
  Eigen::MatrixXd exact(rows, cols), numeric(rows, cols);
  detail::automatic_jacobian<V...>(e, error.data(), exact.data(), rows, cols, x...);
  detail::numeric_jacobian<V...>(e, numeric_error.data(), numeric.data(), rows, cols, x...);
  detail::copy_rows(detail::evaluate(e, x...), rows, value.data());
  EXPECT_LE((exact - numeric).norm(), 1e-8 * (1 + exact.norm()));
  EXPECT_LE((error - value).norm(), 1e-14 * (1 + value.norm()));
  EXPECT_EQ(numeric_error, value);
  return exact;
}

/// The errors and Jacobians of edges whose errors have one row. Each call linearizes `at_once` edges.
std::vector<double> linearize(const detail::EdgePool& pool, std::span<const std::uint32_t> edges,
                              std::size_t at_once) {
  std::vector<double> numbers;
  for (std::size_t k = 0; k < edges.size(); k += at_once) {
    double error[detail::EdgeTile::kCapacity], jacobian[detail::EdgeTile::kCapacity * 16];
    detail::EdgeTile tile;
    tile.error = error;
    tile.jacobian = jacobian;
    pool.linearize(edges.subspan(k, at_once), tile, false);
    numbers.insert(numbers.end(), error, error + tile.count);
    numbers.insert(numbers.end(), jacobian, jacobian + tile.count * tile.cols);
  }
  return numbers;
}

TEST(Jacobian, AnEstimateThatConsecutiveEdgesShareIsConvertedToDualNumbersOnce) {
  Graph graph;
  const auto a = graph.add_vertex(Counted<double>{2}), b = graph.add_vertex(Counted<double>{3}),
             c = graph.add_vertex(Counted<double>{5});
  const auto product = [](const auto& x, const auto& y) { return x.value * x.value * y.value; };
  for (const auto& other : {b, b, c, b}) graph.add_edge(product, a, other);
  for (int k = 0; k < 12; ++k) graph.add_edge(product, c, b);
  std::vector<std::uint32_t> edges(16);
  std::iota(edges.begin(), edges.end(), 0u);
  const detail::EdgePool& pool = *graph.edge_pools()[0];
  const std::vector<double> alone = linearize(pool, edges, 1);
  EXPECT_EQ(Counted<double>::lifts, 32);
  Counted<double>::lifts = 0;
  const std::vector<double> together = linearize(pool, edges, 16);
  EXPECT_EQ(Counted<double>::lifts, 2 + 3);  // first vertices: a, c; second vertices: b, c, b
  for (std::size_t k = 0; k < 16; ++k) {
    EXPECT_EQ(together[k], alone[3 * k]);
    EXPECT_EQ(together[16 + 2 * k], alone[3 * k + 1]);
    EXPECT_EQ(together[16 + 2 * k + 1], alone[3 * k + 2]);
  }
  graph.set_estimate(c, Counted<double>{7});  // the next call must not use old values
  EXPECT_EQ(linearize(pool, std::span(edges).last(1), 1)[0], 7 * 7 * 3);
}

TEST(Jacobian, OfEachOfSeveralEdgesInOneCallEqualsTheJacobianOfThisEdgeAlone) {
  // A Jacobian with thirty columns takes four passes with dual numbers.
  Graph graph;
  const auto a = graph.add_vertex(Vector<double, 24>(Vector<double, 24>::LinSpaced(1, 2))),
             b = graph.add_vertex(Vector<double, 24>(Vector<double, 24>::LinSpaced(3, 4)));
  const auto c = graph.add_vertex(Vector<double, 6>(Vector<double, 6>::LinSpaced(5, 6)));
  const auto e = [](const auto& x, const auto& y) { return x.squaredNorm() * y.sum(); };
  for (const auto& x : {a, a, b}) graph.add_edge(e, x, c);
  const detail::EdgePool& pool = *graph.edge_pools()[0];
  const std::uint32_t edges[] = {0, 1, 2};
  std::vector<double> error(3), jacobian(90), one(30);
  detail::EdgeTile tile;
  tile.error = error.data();
  tile.jacobian = jacobian.data();
  pool.linearize(edges, tile, false);
  for (std::size_t k = 0; k < 3; ++k) {
    const auto& x = graph.estimate(k < 2 ? a : b);
    detail::automatic_jacobian<Vector<double, 24>, Vector<double, 6>>(e, &error[0], one.data(), 1, 30, x,
                                                                      graph.estimate(c));
    EXPECT_EQ(std::vector<double>(jacobian.begin() + 30 * static_cast<long>(k),
                                  jacobian.begin() + 30 * static_cast<long>(k + 1)),
              one);
    EXPECT_NEAR(one[0], 2 * x[0] * graph.estimate(c).sum(), 1e-12);
  }
}

/// The plain way to differentiate: one pass with as many dual variables as columns, through ⊞.
template <int kCols, class E, class... X>
Eigen::MatrixXd by_dual_numbers(const E& e, const X&... x) {
  using D = detail::Dual<double, kCols>;
  int column = 0;
  const auto moved = [&]<class T>(const T& estimate) {
    std::vector<D> delta;
    for (int k = 0; k < detail::tangent_dim(estimate); ++k) delta.push_back(D::variable(0, column++));
    return Manifold<detail::Rebind<T, D>>::oplus(Manifold<T>::template cast<D>(estimate), delta.data());
  };
  const std::tuple<detail::Rebind<X, D>...> arguments{moved(x)...};
  const auto result = std::apply(e, arguments);
  Eigen::MatrixXd J(detail::row_count(result), kCols);
  for (int i = 0; i < J.rows(); ++i)
    for (int k = 0; k < kCols; ++k)
      J(i, k) = D(detail::row(result, i)).derivative[static_cast<std::size_t>(k)];
  return J;
}

TEST(Jacobian, EqualsTheDerivativeOfOplusOverDualNumbers) {
  using X = Vector<double, kDynamic>;
  const SE3 pose = SE3::from_minimal((Vector<double, 6>() << 1, 2, 3, 0.1, -0.2, 0.3).finished());
  const Vector3 intrinsics(500, -0.1, 0.02), point(0.5, -1, 9);
  const auto length = [](const auto& a) { return (a * Vector3(1, 2, 3)).norm(); };
  EXPECT_LE((jacobian<SE3>(length, 1, pose) - by_dual_numbers<6>(length, pose)).norm(), 1e-14);
  const auto seen = [](const auto& a, const auto& p) { return a.inverse_times(p); };
  EXPECT_LE((jacobian<SE3, Vector3>(seen, 3, pose, point) - by_dual_numbers<9>(seen, pose, point)).norm(),
            1e-13);
  const auto pixel = [](const auto& a, const auto& k, const auto& p) {
    const auto y = a * p;
    return Vector<std::remove_cvref_t<decltype(k[0])>, 2>((k[0] + k[1] * y[0]) * y[0] / y[2],
                                                          (k[0] + k[2] * y[1]) * y[1] / y[2]);
  };
  EXPECT_LE((jacobian<SE3, Vector3, Vector3>(pixel, 2, pose, intrinsics, point) -
             by_dual_numbers<12>(pixel, pose, intrinsics, point))
                .norm(),
            1e-10);
  // Vertices of fixed and of run-time size.
  const auto mixed = [](const auto& a, const auto& x, const auto& p) { return (x.dot(x) * (a * p)).eval(); };
  const X x = X::LinSpaced(4, 1, 2);
  EXPECT_LE((jacobian<SE3, X, Vector3>(mixed, 3, pose, x, point) - by_dual_numbers<13>(mixed, pose, x, point))
                .norm(),
            1e-11);
}

TEST(Jacobian, OfAnErrorThatTakesAVertexInTwoScalarTypesIsExact) {
  // The error converts its arguments to plain numbers, and uses both.
  const auto e = [](const auto& a, const auto& p) {
    const auto y = a * p;
    const double start = detail::scalar_value(p[0]);
    return (y[0] * y[1] - start * y[2] + start * start * p[2]) / y[2];
  };
  const SE3 pose = SE3::from_minimal((Vector<double, 6>() << 1, 2, 3, 0.1, -0.2, 0.3).finished());
  const Vector3 point(0.5, -1, 9);
  Eigen::MatrixXd J(1, 9);
  double error = 0;
  detail::automatic_jacobian<SE3, Vector3>(e, &error, J.data(), 1, 9, pose, point);
  EXPECT_LE((J - by_dual_numbers<9>(e, pose, point)).norm(), 1e-13);
}

/// The pixel of a point, with the intrinsic parameters as a vertex.
struct Pixel {
  Vector2 measurement;
  template <class S>
  Vector<S, 2> error(const BasicSE3<S>& pose, const Vector<S, 3>& k, const Vector<S, 3>& point) const {
    const Vector<S, 3> y = pose * point;
    return {k[0] * y[0] / y[2] + k[1] - measurement[0], k[0] * y[1] / y[2] + k[2] - measurement[1]};
  }
};

TEST(Jacobian, DoesNotDependOnTheEdgesBeforeInTheSameCall) {
  Graph graph;
  std::vector<VertexHandle<SE3>> poses;
  std::vector<VertexHandle<Vector3>> intrinsics, points;
  for (int i = 0; i < 4; ++i) {
    const double t = 0.1 * i;
    poses.push_back(
        graph.add_vertex(SE3::from_minimal((Vector<double, 6>() << t, 2, 3, t, -0.2, 0.3).finished())));
    intrinsics.push_back(graph.add_vertex(Vector3(500 + t, 3, 4 - t)));
    points.push_back(graph.add_vertex(Vector3(t, t * t, 9 - t)));
  }
  std::vector<std::uint32_t> edges;
  for (std::size_t k = 0; k < 16; ++k) {
    edges.push_back(static_cast<std::uint32_t>(k));
    graph.add_edge(Pixel{Vector2(1, 2)}, poses[k / 4], intrinsics[k / 8], points[k % 4]);
  }
  std::vector<double> error(32), jacobian(16 * 24), alone(24);
  detail::EdgeTile tile;
  tile.error = error.data();
  tile.jacobian = jacobian.data();
  graph.edge_pools()[0]->linearize(edges, tile, false);
  for (std::size_t k = 0; k < 16; ++k) {
    double e[2];
    detail::automatic_jacobian<SE3, Vector3, Vector3>(
        Pixel{Vector2(1, 2)}, e, alone.data(), 2, 12, graph.estimate(poses[k / 4]),
        graph.estimate(intrinsics[k / 8]), graph.estimate(points[k % 4]));
    EXPECT_EQ(error[2 * k], e[0]);
    EXPECT_EQ(error[2 * k + 1], e[1]);
    const auto first = jacobian.begin() + static_cast<std::ptrdiff_t>(24 * k);
    EXPECT_EQ(std::vector<double>(first, first + 24), alone);
  }
}

TEST(Jacobian, OfAPolynomialEqualsTheTextbookFormula) {
  const auto e = [](const auto& x, const auto& y) { return x * x * y; };
  EXPECT_EQ((jacobian<double, double>(e, 1, 3, 5)), Eigen::RowVector2d(30, 9));
}

TEST(Jacobian, OfAnSe2BetweenErrorEqualsTheFormulaDerivedByHand) {
  const auto e = [](const auto& a, const auto& b) { return a.inverse_times(b).vector(); };
  const SE2 a(1, 2, 0.3), b(4, -1, -2.5);
  const Eigen::MatrixXd J = jacobian<SE2, SE2>(e, 3, a, b);
  const SE2 z = a.inverse_times(b);
  Eigen::Matrix<double, 3, 6> expected = Eigen::Matrix<double, 3, 6>::Zero();
  expected.block<3, 3>(0, 0) = -Eigen::Matrix3d::Identity();
  expected(0, 2) = z.y();
  expected(1, 2) = -z.x();
  expected.block<2, 2>(0, 3) = z.rotation();
  expected(2, 5) = 1;
  EXPECT_LE((J - expected).norm(), 1e-14);
}

TEST(Jacobian, OfAnSe3BetweenErrorOfZeroIsTheIdentityForTheSecondPose) {
  const SE3 a = SE3::from_minimal((Vector<double, 6>() << 1, 2, 3, 0.1, -0.2, 0.3).finished());
  const SE3 z = SE3::from_minimal((Vector<double, 6>() << 3, 2, 1, 0.4, 0.1, -0.3).finished());
  const auto e = [z](const auto& x, const auto& y) {
    return z.inverse_times(x.inverse_times(y)).minimal().eval();
  };
  const Eigen::MatrixXd J = jacobian<SE3, SE3>(e, 6, a, a * z);
  EXPECT_LE((J.rightCols<6>() - Eigen::MatrixXd::Identity(6, 6)).norm(), 1e-13);
  // The derivative of the translation of Z⁻¹ (X ⊞ δ)⁻¹ Y by the translation of δ is −R(z)ᵀ.
  EXPECT_LE((J.block<3, 3>(0, 0) + z.rotation().transpose()).norm(), 1e-13);
  const SE3 far = a * z * SE3::from_minimal((Vector<double, 6>() << 1, -1, 2, 0.5, 0.3, 0.2).finished());
  jacobian<SE3, SE3>(e, 6, a, far);
}

TEST(Jacobian, OfAnSe3PointMeasurementEqualsTheTextbookFormula) {
  const auto e = [](const auto& x, const auto& p) { return x.inverse_times(p); };
  const SE3 x = SE3::from_minimal((Vector<double, 6>() << 1, 2, 3, 0.1, -0.2, 0.3).finished());
  const Eigen::Vector3d p(4, 5, 7);
  const Eigen::MatrixXd J = jacobian<SE3, Eigen::Vector3d>(e, 3, x, p);
  EXPECT_LE((J.leftCols<3>() + Eigen::Matrix3d::Identity()).norm(), 1e-14);
  const Eigen::Vector3d q = x.inverse_times(p);
  Eigen::Matrix3d skew;
  skew << 0, -q[2], q[1], q[2], 0, -q[0], -q[1], q[0], 0;
  // The factor 2 is needed because the vector part of a quaternion is half of a small rotation vector.
  EXPECT_LE((J.middleCols<3>(3) - 2 * skew).norm(), 1e-13);
  EXPECT_LE((J.rightCols<3>() - x.rotation().transpose()).norm(), 1e-14);
}

constexpr auto kProducts = [](const auto& a, const auto& b, const auto& c, const auto& d, const auto& f) {
  using S = std::remove_cvref_t<decltype(a[0])>;
  Eigen::Matrix<S, 2, 1> e;
  e << S(a[0] * b[5] + c[3] * d[1] * f[4]), S(a[2] - f[5] * f[5]);
  return e;
};

TEST(Jacobian, OfThirtyColumnsIsComputedInSeveralPasses) {
  using Vector6 = Eigen::Matrix<double, 6, 1>;
  static_assert(detail::kDualSize<Vector6, Vector6, Vector6, Vector6, Vector6> == detail::kDualChunk);
  Vector6 x;
  x << 1, 2, 3, 4, 5, 6;
  const Eigen::MatrixXd J =
      jacobian<Vector6, Vector6, Vector6, Vector6, Vector6>(kProducts, 2, x, 2 * x, 3 * x, 5 * x, 7 * x);
  Eigen::MatrixXd expected = Eigen::MatrixXd::Zero(2, 30);
  expected(0, 0) = 12;
  expected(0, 6 + 5) = 1;
  expected(0, 12 + 3) = 10 * 35;
  expected(0, 18 + 1) = 12 * 35;
  expected(0, 24 + 4) = 120;
  expected(1, 2) = 1;
  expected(1, 24 + 5) = -84;
  EXPECT_EQ(J, expected);
}

TEST(Jacobian, OfARangeHasTheColumnsOfEachOfItsVertices) {
  const auto e = [](const auto& scale, const auto& points) {
    using S = std::remove_cvref_t<decltype(scale)>;
    Eigen::Matrix<S, 3, 1> sum = Eigen::Matrix<S, 3, 1>::Zero();
    double weight = 1;
    for (const auto& p : points) sum += scale * (weight++) * p;
    return sum;
  };
  const std::vector<Eigen::Vector3d> points(11, Eigen::Vector3d(1, 2, 3));
  const Eigen::MatrixXd J = jacobian<double, detail::Tail<Eigen::Vector3d>>(e, 3, 2, points);
  ASSERT_EQ(J.cols(), 34);
  EXPECT_EQ(J.col(0), 66 * points[0]);
  for (int k = 0; k < 11; ++k) {
    EXPECT_EQ((J.middleCols<3>(1 + 3 * k)), (2.0 * (k + 1) * Eigen::Matrix3d::Identity()));
  }
}

TEST(Jacobian, OfAnEmptyRangeHasOnlyTheColumnsOfTheOtherVertices) {
  const auto e = [](const auto& x, const auto& tail) { return x * x + static_cast<double>(tail.size()); };
  EXPECT_EQ((jacobian<double, detail::Tail<double>>(e, 1, 3, {}))(0, 0), 6);
}

TEST(Jacobian, OfVectorsOfRunTimeSizeEqualsTheFormula) {
  const auto e = [](const auto& x, const auto& y) { return (x.squaredNorm() * y).eval(); };
  const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(13, 1, 13), y = Eigen::VectorXd::LinSpaced(2, 1, 2);
  const Eigen::MatrixXd J = jacobian<Eigen::VectorXd, Eigen::VectorXd>(e, 2, x, y);
  EXPECT_LE((J.leftCols(13) - 2 * y * x.transpose()).norm(), 1e-12);
  EXPECT_LE((J.rightCols(2) - x.squaredNorm() * Eigen::Matrix2d::Identity()).norm(), 1e-12);
}

TEST(Jacobian, HasNoColumnsForAVertexOfDimensionZero) {
  const auto e = [](const auto& x, const auto& frozen, const auto& y) { return x * frozen.value + y; };
  EXPECT_EQ((jacobian<double, Frozen, double>(e, 1, 3, Frozen{5}, 7)), Eigen::RowVector2d(5, 1));
  const auto constant = [](const auto& frozen) { return frozen.value; };
  EXPECT_EQ((jacobian<Frozen>(constant, 1, Frozen{5})).cols(), 0);
}

TEST(Jacobian, IsAccurateForLargeAndSmallErrorsEvenIfItIsNumeric) {
  for (const double scale : {1e-6, 1.0, 1e6}) {
    const auto e = [scale](const auto& x) {
      using std::sin;
      return scale * sin(x);
    };
    double error = 0, derivative = 0;
    detail::numeric_jacobian<double>(e, &error, &derivative, 1, 1, 0.7);
    EXPECT_NEAR(derivative, scale * std::cos(0.7), 1e-10 * scale);
  }
}

}  // namespace
}  // namespace boxplus
