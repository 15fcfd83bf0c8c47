// SPDX-License-Identifier: BSD-3-Clause
// Client edges that compute their error in a function template. The macros of g2o derive the Jacobians from
// this template.
#include "g2o/core/auto_differentiation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "g2o/core/base_binary_edge.h"
#include "g2o/core/base_unary_edge.h"
#include "g2o/core/base_vertex.h"
#include "g2o/core/block_solver.h"
#include "g2o/core/optimization_algorithm_levenberg.h"
#include "g2o/core/sparse_optimizer.h"
#include "g2o/edge_checks.h"
#include "g2o/solvers/eigen/linear_solver_eigen.h"

namespace {

using g2o::VectorN;
using ::testing::ElementsAre;
using Jet = g2o::ceres::Jet<double, 2>;

template <int D>
class VertexNumbers : public g2o::BaseVertex<D, VectorN<D>> {
 public:
  void setToOriginImpl() override { this->_estimate.setZero(); }
  void oplusImpl(const double* update) override { this->_estimate += Eigen::Map<const VectorN<D>>(update); }
  bool read(std::istream&) override { return false; }
  bool write(std::ostream&) const override { return false; }
};

/// The error of a measured point (x, y) with respect to the curve y = a exp(−λ x) + b.
class EdgeCurve : public g2o::BaseUnaryEdge<1, Eigen::Vector2d, VertexNumbers<3>> {
 public:
  template <typename T>
  bool operator()(const T* params, T* error) const {
    const T &a = params[0], &b = params[1], &lambda = params[2];
    error[0] = a * exp(-lambda * T(_measurement[0])) + b - _measurement[1];
    return true;
  }
  bool read(std::istream&) override { return false; }
  bool write(std::ostream&) const override { return false; }
  G2O_MAKE_AUTO_AD_FUNCTIONS  // use autodiff
};

TEST(AutoDifferentiation, FitsACurve) {
  using std::exp;
  g2o::SparseOptimizer optimizer;
  optimizer.setAlgorithm(new g2o::OptimizationAlgorithmLevenberg(std::make_unique<g2o::BlockSolverX>(
      std::make_unique<g2o::LinearSolverEigen<g2o::BlockSolverX::PoseMatrixType>>())));
  auto* v = new VertexNumbers<3>;
  v->setId(0);
  v->setEstimate({1, 1, 1});
  optimizer.addVertex(v);
  for (int i = 0; i < 50; ++i) {
    auto* e = new EdgeCurve;
    e->setVertex(0, v);
    const double x = 0.1 * i;
    e->setMeasurement({x, 2 * std::exp(-0.5 * x) + 0.4});
    e->setInformation(Eigen::Matrix<double, 1, 1>::Identity());
    ASSERT_TRUE(optimizer.addEdge(e));
  }
  ASSERT_TRUE(optimizer.initializeOptimization());
  EXPECT_GT(optimizer.optimize(20), 0);
  EXPECT_LT((v->estimate() - Eigen::Vector3d(2, 0.4, 0.5)).norm(), 1e-6);
  edge_checks::expect_exact_jacobians(**optimizer.activeEdges().begin());
}

/// The observation of a point by a camera with nine parameters (rotation vector, translation, focal length,
/// two distortion coefficients), as in the BAL data sets. Eigen maps the arrays of Jets as vectors.
class EdgeObservationBAL
    : public g2o::BaseBinaryEdge<2, Eigen::Vector2d, VertexNumbers<9>, VertexNumbers<3>> {
 public:
  template <typename T>
  bool operator()(const T* p_camera, const T* p_point, T* p_error) const {
    typename VectorN<9, T>::ConstMapType camera(p_camera);
    Eigen::Map<const VectorN<3, T>> point(p_point);
    VectorN<3, T> p = turned<T>(camera.template head<3>(), point);
    p += camera.template segment<3>(3);
    if (p.z() == T(0)) return false;
    const VectorN<2, T> image = -p.template head<2>() / p.z();
    const T r2 = image.squaredNorm();
    const T distortion = T(1) + r2 * (camera[7] + camera[8] * r2);
    typename VectorN<2, T>::MapType error(p_error);
    error = image * (camera[6] * distortion) - _measurement.template cast<T>();
    return true;
  }
  bool read(std::istream&) override { return false; }
  bool write(std::ostream&) const override { return false; }
  G2O_MAKE_AUTO_AD_FUNCTIONS

 private:
  template <typename T>
  static VectorN<3, T> turned(const VectorN<3, T>& omega, const VectorN<3, T>& p) {
    const T theta2 = omega.squaredNorm();
    if (!(theta2 > T(0))) return p + omega.cross(p);
    const T theta = sqrt(theta2);
    const VectorN<3, T> axis = omega / theta;
    return p * cos(theta) + axis.cross(p) * sin(theta) + axis * (axis.dot(p) * (T(1) - cos(theta)));
  }
};

class Bundle : public testing::Test {
 protected:
  void add() {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> uniform(-1, 1);
    const auto noise = [&](auto v, double size) {
      for (auto& x : v) x += size * uniform(random);
      return v;
    };
    std::vector<VectorN<9>> cameras(4);
    for (size_t i = 0; i < cameras.size(); ++i)
      cameras[i] << 0.1 * static_cast<double>(i), -0.1, 0.05, 0.5 * static_cast<double>(i), 0.2, -6, 500,
          0.01, -0.02;
    for (size_t i = 0; i < cameras.size(); ++i) {
      auto* v = new VertexNumbers<9>;
      v->setId(static_cast<int>(i));
      v->setEstimate(i < 2 ? cameras[i] : noise(cameras[i], 0.01));
      v->setFixed(i < 2);
      optimizer.addVertex(v);
    }
    for (int j = 0; j < 40; ++j) {
      const VectorN<3> point(2 * uniform(random), 2 * uniform(random), uniform(random));
      auto* v = new VertexNumbers<3>;
      v->setId(100 + j);
      v->setEstimate(point);
      v->setMarginalized(true);
      optimizer.addVertex(v);
      for (size_t i = 0; i < cameras.size(); ++i) {
        auto* e = new EdgeObservationBAL;
        e->setVertex(0, optimizer.vertex(static_cast<int>(i)));
        e->setVertex(1, v);
        Eigen::Vector2d z(0, 0);
        e->setMeasurement(z);
        (*e)(cameras[i].data(), point.data(), z.data());
        e->setMeasurement(z);
        ASSERT_TRUE(optimizer.addEdge(e));
      }
      v->setEstimate(noise(point, 0.05));
    }
  }

  g2o::SparseOptimizer optimizer;
};

TEST_F(Bundle, JacobiansAreExactIfTheErrorUsesEigenMapsOfJets) {
  add();
  for (g2o::HyperGraph::Edge* e : optimizer.edges()) {
    const auto* camera = static_cast<g2o::OptimizableGraph::Vertex*>(e->vertices()[0]);
    if (!camera->fixed()) edge_checks::expect_exact_jacobians(*static_cast<g2o::OptimizableGraph::Edge*>(e));
  }
}

TEST_F(Bundle, ConvergesToTheGroundTruth) {
  add();
  optimizer.setAlgorithm(new g2o::OptimizationAlgorithmLevenberg(
      std::make_unique<g2o::BlockSolver<g2o::BlockSolverTraits<9, 3>>>(
          std::make_unique<
              g2o::LinearSolverEigen<g2o::BlockSolver<g2o::BlockSolverTraits<9, 3>>::PoseMatrixType>>())));
  ASSERT_TRUE(optimizer.initializeOptimization());
  EXPECT_GT(optimizer.optimize(20), 0);
  EXPECT_LT(optimizer.activeChi2(), 1e-9);
}

/// An estimate type without data(), so that the edge must call getEstimateData() of the vertex.
struct Interval {
  double from = 0, to = 1;
};
class VertexInterval : public g2o::BaseVertex<2, Interval> {
 public:
  void setToOriginImpl() override { _estimate = Interval(); }
  void oplusImpl(const double* update) override {
    _estimate.from += update[0];
    _estimate.to += update[1];
  }
  int estimateDimension() const override { return 2; }
  bool getEstimateData(double* est) const override {
    est[0] = _estimate.from;
    est[1] = _estimate.to;
    return true;
  }
  bool read(std::istream&) override { return false; }
  bool write(std::ostream&) const override { return false; }
};

class VertexNumber : public g2o::BaseVertex<1, double> {
 public:
  void setToOriginImpl() override { _estimate = 0; }
  void oplusImpl(const double* update) override { _estimate += *update; }
  int estimateDimension() const override { return 1; }
  bool getEstimateData(double* est) const override {
    *est = _estimate;
    return true;
  }
  bool read(std::istream&) override { return false; }
  bool write(std::ostream&) const override { return false; }
};

class EdgeByGet : public g2o::BaseBinaryEdge<2, double, VertexInterval, VertexNumber> {
 public:
  template <typename T>
  bool operator()(const T* interval, const T* x, T* error) const {
    using std::atan2;
    error[0] = (x[0] - interval[0]) / (interval[1] - interval[0]) - _measurement;
    error[1] = atan2(interval[1] * x[0], interval[0]);
    return true;
  }
  bool read(std::istream&) override { return false; }
  bool write(std::ostream&) const override { return false; }
  G2O_MAKE_AUTO_AD_FUNCTIONS_BY_GET
};

class EdgeNumber : public g2o::BaseUnaryEdge<1, double, VertexNumber> {
 public:
  template <typename T>
  bool operator()(const T* x, T* error) const {
    error[0] = pow(*x, 3.) - _measurement;
    return !fails;
  }
  bool read(std::istream&) override { return false; }
  bool write(std::ostream&) const override { return false; }
  bool fails = false;
  G2O_MAKE_AUTO_AD_FUNCTIONS
};

TEST(AutoDifferentiation, JacobiansAreExactForScalarEstimatesAndForEstimatesWithoutData) {
  g2o::SparseOptimizer optimizer;
  auto* interval = new VertexInterval;
  interval->setId(0);
  interval->setEstimate({0.5, 2});
  auto* number = new VertexNumber;
  number->setId(1);
  number->setEstimate(1.2);
  optimizer.addVertex(interval);
  optimizer.addVertex(number);
  auto* e = new EdgeByGet;
  e->setVertex(0, interval);
  e->setVertex(1, number);
  e->setMeasurement(0.3);
  ASSERT_TRUE(optimizer.addEdge(e));
  edge_checks::expect_exact_jacobians(*e);
  e->computeError();
  EXPECT_NEAR(e->error()[0], 0.7 / 1.5 - 0.3, 1e-15);
  auto* unary = new EdgeNumber;
  unary->setVertex(0, number);
  unary->setMeasurement(1);
  ASSERT_TRUE(optimizer.addEdge(unary));
  edge_checks::expect_exact_jacobians(*unary);
}

TEST(AutoDifferentiation, JacobiansAreZeroIfTheTemplateReturnsFalse) {
  VertexNumber number;
  number.setEstimate(1.2);
  EdgeNumber e;
  e.setVertex(0, &number);
  e.setMeasurement(1);
  e.fails = true;
  g2o::JacobianWorkspace workspace;
  workspace.updateSize(&e);
  ASSERT_TRUE(workspace.allocate());
  *workspace.workspaceForVertex(0) = 7;
  static_cast<g2o::OptimizableGraph::Edge&>(e).linearizeOplus(workspace);
  EXPECT_EQ(*workspace.workspaceForVertex(0), 0);
}

/// Checks that f returns the same value for a Jet as for a double, and that the derivative in the Jet matches
/// central differences.
template <class F>
void expect_slope(const char* name, double x, F f) {
  SCOPED_TRACE(name);
  const Jet y = f(Jet(x, 1));
  const double h = 1e-6;
  EXPECT_DOUBLE_EQ(y.a, f(x));
  EXPECT_EQ(y.v[0], 0);
  EXPECT_NEAR(y.v[1], (f(x + h) - f(x - h)) / (2 * h), 1e-8 * std::max(1., std::abs(y.v[1])));
}

/// The products of the values of two arrays: (x₀ y₀, x₀ y₁, x₁ y₂).
struct Products {
  template <typename T>
  bool operator()(const T* x, const T* y, T* result) const {
    result[0] = x[0] * y[0];
    result[1] = x[0] * y[1];
    result[2] = x[1] * y[2];
    return works;
  }
  bool works = true;
};

TEST(AutoDifferentiate, WritesRowMajorJacobiansForAnyNumberOfRows) {
  using Dims = g2o::ceres::internal::StaticParameterDims<2, 3>;
  static_assert(Dims::kNumParameterBlocks == 2 && Dims::kNumParameters == 5 && Dims::GetDim(1) == 3, "");
  const double x[] = {2, 3}, y[] = {5, 7, 11};
  const double* parameters[] = {x, y};
  double value[3], by_x[6], by_y[9];
  double* jacobians[] = {by_x, by_y};
  ASSERT_TRUE(
      (g2o::ceres::internal::AutoDifferentiate<3, Dims>(Products(), parameters, 3, value, jacobians)));
  EXPECT_THAT(value, ElementsAre(10, 14, 33));
  EXPECT_THAT(by_x, ElementsAre(5, 0, 7, 0, 0, 11));
  EXPECT_THAT(by_y, ElementsAre(2, 0, 0, 0, 2, 0, 0, 0, 3));
  jacobians[0] = nullptr;  // not wanted
  by_x[0] = by_y[0] = 99;
  ASSERT_TRUE((g2o::ceres::internal::AutoDifferentiate<g2o::ceres::DYNAMIC, Dims>(Products(), parameters, 3,
                                                                                  value, jacobians)));
  EXPECT_EQ(by_x[0], 99);
  EXPECT_EQ(by_y[0], 2);
  EXPECT_FALSE(
      (g2o::ceres::internal::AutoDifferentiate<3, Dims>(Products{false}, parameters, 3, value, jacobians)));
}

TEST(Jets, ComputeTheDerivativesOfAllFunctions) {
  using namespace g2o::ceres;
  for (const double x : {0.3, 0.7, -0.4}) {
    expect_slope("arithmetic", x,
                 [](auto t) { return decltype(t)((2. * t - 1.) / (t * t + 3.) + t / 2. - 1. / t); });
    expect_slope("compound", x, [](auto t) {
      auto s = t;
      s *= t;
      s -= 2.;
      s /= t;
      s += t;
      s *= 3.;
      return s;
    });
    expect_slope("abs", x, [](auto t) { return abs(t); });
    expect_slope("cbrt", x, [](auto t) { return cbrt(t); });
    expect_slope("exp", x, [](auto t) { return exp(t); });
    expect_slope("exp2", x, [](auto t) { return exp2(t); });
    expect_slope("sin", x, [](auto t) { return sin(t); });
    expect_slope("cos", x, [](auto t) { return cos(t); });
    expect_slope("tan", x, [](auto t) { return tan(t); });
    expect_slope("asin", x, [](auto t) { return asin(t); });
    expect_slope("acos", x, [](auto t) { return acos(t); });
    expect_slope("atan", x, [](auto t) { return atan(t); });
    expect_slope("sinh", x, [](auto t) { return sinh(t); });
    expect_slope("cosh", x, [](auto t) { return cosh(t); });
    expect_slope("tanh", x, [](auto t) { return tanh(t); });
    expect_slope("atan2", x, [](auto t) { return atan2(decltype(t)(t * t), decltype(t)(t + 2.)); });
    expect_slope("hypot", x, [](auto t) { return hypot(t, decltype(t)(t + 2.)); });
    expect_slope("2^t", x, [](auto t) { return pow(2., t); });
    expect_slope("t^2", x, [](auto t) { return pow(t, 2.); });
  }
  for (const double x : {0.3, 4.}) {
    expect_slope("sqrt", x, [](auto t) { return sqrt(t); });
    expect_slope("log", x, [](auto t) { return log(t); });
    expect_slope("log2", x, [](auto t) { return log2(t); });
    expect_slope("t^t", x, [](auto t) { return pow(t, t); });
    expect_slope("fmax", x, [](auto t) { return fmax(t, decltype(t)(1.)); });
    expect_slope("fmin", x, [](auto t) { return fmin(t, decltype(t)(1.)); });
  }
}

TEST(Jets, TheNormOfAConstantZeroVectorHasTheDerivativeZero) {
  const Eigen::Matrix<Jet, 3, 1> zero = Eigen::Matrix<Jet, 3, 1>::Zero();
  const Jet norm = zero.norm();
  EXPECT_EQ(norm.a, 0);
  EXPECT_EQ(norm.v[0], 0);
  EXPECT_EQ(norm.v[1], 0);
}

TEST(Jets, WorkAsScalarsOfEigenMatrices) {
  Jet numbers[4] = {Jet(1, 0), Jet(2), Jet(3), Jet(4, 1)};
  const Eigen::Map<Eigen::Matrix<Jet, 2, 2>> m(numbers);
  const Jet determinant = m.determinant();
  EXPECT_EQ(determinant.a, -2);
  EXPECT_EQ(determinant.v[0], 4);
  EXPECT_EQ(determinant.v[1], 1);
  const Eigen::Matrix2d plain = (Eigen::Matrix2d() << 1, 2, 3, 4).finished();
  const Eigen::Matrix<Jet, 2, 2> product = plain * m;
  EXPECT_EQ(product(0, 0).a, 1 * 1 + 2 * 2);
  EXPECT_EQ(product(0, 0).v[0], 1);
  EXPECT_TRUE(isfinite(determinant) && !isnan(determinant));
  EXPECT_LT(determinant, Jet(0.));
}

}  // namespace
