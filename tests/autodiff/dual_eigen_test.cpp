// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "boxplus/autodiff/dual.h"
#include "boxplus/base/matrix.h"

namespace boxplus {
namespace {

using D2 = detail::Dual<double, 2>;

Matrix<double, 2, 2> literal_matrix() {
  Matrix<double, 2, 2> m;
  m << 1, 2, 3, 4;
  return m;
}
const Vector<D2, 2> kPoint(D2::variable(5, 0), D2::variable(6, 1));

TEST(DualInEigen, MultipliesByAMatrixOfDoubles) {
  const Vector<D2, 2> y = literal_matrix() * kPoint;
  EXPECT_EQ(y[1].value, 39);
  EXPECT_EQ(y[1].derivative[0], 3);
  EXPECT_EQ(y[1].derivative[1], 4);
}

TEST(DualInEigen, EvaluatesAQuadraticForm) {
  const D2 f = kPoint.dot(literal_matrix() * kPoint);
  EXPECT_EQ(f.value, 25 + 30 * 5 + 36 * 4);
  EXPECT_EQ(f.derivative[0], 2 * 5 + 5 * 6);
  EXPECT_EQ(f.derivative[1], 5 * 5 + 8 * 6);
  const D2 same = kPoint.transpose() * literal_matrix() * kPoint;
  EXPECT_EQ(same.value, f.value);
}

TEST(DualInEigen, ScalesAddsAndNormalizes) {
  const Vector<double, 2> c(1, 1);
  Vector<D2, 2> y = 2.0 * kPoint - kPoint * 3 + c;
  y += c;
  y *= 2.0;
  EXPECT_EQ(y[0].value, -6);
  EXPECT_EQ(y[0].derivative[0], -2);
  EXPECT_DOUBLE_EQ(kPoint.norm().value, std::sqrt(61));
  EXPECT_DOUBLE_EQ(kPoint.norm().derivative[0], 5 / std::sqrt(61));
  EXPECT_NEAR(kPoint.normalized().squaredNorm().derivative[1], 0, 1e-16);
}

TEST(DualInEigen, TheNormOfAConstantZeroVectorHasDerivativeZero) {
  const Vector<D2, 2> zero = Vector<D2, 2>::Zero();
  EXPECT_EQ(zero.norm().derivative[0], 0);
}

TEST(DualInEigen, WorksInMatricesOfRunTimeSize) {
  const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic> m = Eigen::MatrixXd::Identity(30, 30) * 2;
  Eigen::Matrix<D2, Eigen::Dynamic, 1> x(30);
  x.setConstant(D2::variable(3, 1));
  const Eigen::Matrix<D2, Eigen::Dynamic, 1> y = m * x;
  EXPECT_EQ(y[29].value, 6);
  EXPECT_EQ(y[29].derivative[1], 2);
  const Eigen::Matrix<D2, Eigen::Dynamic, Eigen::Dynamic> p = m.lazyProduct(m.cast<D2>());
  EXPECT_EQ(p(3, 3).value, 4);
}

TEST(DualInEigen, AppliesFunctionsToArrays) {
  const Eigen::Array<D2, 2, 1> y = kPoint.array().sin() * kPoint.array().exp();
  EXPECT_DOUBLE_EQ(y[0].derivative[0], (std::sin(5) + std::cos(5)) * std::exp(5));
}

TEST(DualInEigen, NestedDualsCombineWithTheirInnerDuals) {
  using H = detail::Dual<detail::Dual<double, 1>, 2>;
  const Vector<H, 2> x(H::variable(5, 0), H::variable(6, 1));
  const Vector<detail::Dual<double, 1>, 2> inner(detail::Dual<double, 1>(1), detail::Dual<double, 1>(2));
  const Vector<H, 2> y = literal_matrix() * x + inner;
  EXPECT_EQ(detail::scalar_value(y[0]), 18);
}

}  // namespace
}  // namespace boxplus
