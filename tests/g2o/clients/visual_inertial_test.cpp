// SPDX-License-Identifier: BSD-3-Clause
// A client that fuses images with inertial measurements. It has its own classes for estimates, and its
// multi-edges have partly analytic Jacobians. After a run, the client reads Hessians from edges and keeps
// them as a prior for the next run. The client allocates all vertices and edges with `new`.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>
#include <vector>

#include "g2o/core/base_binary_edge.h"
#include "g2o/core/base_multi_edge.h"
#include "g2o/core/base_unary_edge.h"
#include "g2o/core/base_vertex.h"
#include "g2o/core/block_solver.h"
#include "g2o/core/optimization_algorithm_gauss_newton.h"
#include "g2o/core/optimization_algorithm_levenberg.h"
#include "g2o/core/robust_kernel_impl.h"
#include "g2o/core/sparse_optimizer.h"
#include "g2o/solvers/linear_solver_eigen.h"
#include "g2o/types/types_six_dof_expmap.h"

namespace {

typedef Eigen::Matrix<double, 9, 1> Vector9d;
typedef Eigen::Matrix<double, 9, 9> Matrix9d;

Eigen::Matrix3d expSO3(const Eigen::Vector3d& w) {
  return w.norm() > 0 ? Eigen::AngleAxisd(w.norm(), w.normalized()).toRotationMatrix()
                      : Eigen::Matrix3d::Identity().eval();
}

Eigen::Vector3d logSO3(const Eigen::Matrix3d& R) {
  const Eigen::AngleAxisd turn(R);
  return turn.angle() * turn.axis();
}

/// The pose of a body in the world. The frame of the camera is the frame of the body.
class ImuCamPose {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  ImuCamPose() : its(0) {
    Rwb.setIdentity();
    twb.setZero();
  }
  void Update(const double* pu) {
    twb += Rwb * Eigen::Vector3d(pu[3], pu[4], pu[5]);
    Rwb = Rwb * expSO3(Eigen::Vector3d(pu[0], pu[1], pu[2]));
    if (++its < 3) return;
    Rwb = Eigen::Quaterniond(Rwb).normalized().toRotationMatrix();
    its = 0;
  }
  Eigen::Vector3d inCamera(const Eigen::Vector3d& p) const { return Rwb.transpose() * (p - twb); }

  Eigen::Matrix3d Rwb;
  Eigen::Vector3d twb;
  int its;
};

class VertexPose : public g2o::BaseVertex<6, ImuCamPose> {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  VertexPose() {}
  virtual bool read(std::istream&) { return false; }
  virtual bool write(std::ostream&) const { return false; }
  virtual void setToOriginImpl() {}
  virtual void oplusImpl(const double* update_) {
    _estimate.Update(update_);
    updateCache();
  }
};

class VertexVelocity : public g2o::BaseVertex<3, Eigen::Vector3d> {
 public:
  VertexVelocity() { setEstimate(Eigen::Vector3d::Zero()); }
  virtual bool read(std::istream&) { return false; }
  virtual bool write(std::ostream&) const { return false; }
  virtual void setToOriginImpl() {}
  virtual void oplusImpl(const double* update_) {
    Eigen::Vector3d uv;
    uv << update_[0], update_[1], update_[2];
    setEstimate(estimate() + uv);
  }
};

class VertexScale : public g2o::BaseVertex<1, double> {
 public:
  VertexScale() { setEstimate(1.0); }
  VertexScale(double ps) { setEstimate(ps); }
  virtual bool read(std::istream&) { return false; }
  virtual bool write(std::ostream&) const { return false; }
  virtual void setToOriginImpl() { setEstimate(1.0); }
  virtual void oplusImpl(const double* update_) { setEstimate(estimate() * std::exp(*update_)); }
};

struct Preintegrated {
  double dt = 0;
  Eigen::Matrix3d dR = Eigen::Matrix3d::Identity();
  Eigen::Vector3d dV = Eigen::Vector3d::Zero(), dP = Eigen::Vector3d::Zero();
};
const Eigen::Vector3d g(0, 0, -9.81);

/// The preintegrated change of rotation, velocity and position between two states. The positions are known
/// except for their common scale.
class EdgeInertial : public g2o::BaseMultiEdge<9, Vector9d> {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  EdgeInertial(Preintegrated* pInt) : mpInt(pInt) {
    resize(5);
    Matrix9d Info = Matrix9d::Identity() * 1e4;
    setInformation(Info);
  }
  virtual bool read(std::istream&) { return false; }
  virtual bool write(std::ostream&) const { return false; }
  void computeError() {
    const VertexPose* VP1 = static_cast<const VertexPose*>(_vertices[0]);
    const VertexVelocity* VV1 = static_cast<const VertexVelocity*>(_vertices[1]);
    const VertexPose* VP2 = static_cast<const VertexPose*>(_vertices[2]);
    const VertexVelocity* VV2 = static_cast<const VertexVelocity*>(_vertices[3]);
    const double s = static_cast<const VertexScale*>(_vertices[4])->estimate();
    const Eigen::Matrix3d Rbw = VP1->estimate().Rwb.transpose();
    const double dt = mpInt->dt;
    const Eigen::Vector3d er = logSO3(mpInt->dR.transpose() * Rbw * VP2->estimate().Rwb);
    const Eigen::Vector3d ev = Rbw * (s * (VV2->estimate() - VV1->estimate()) - g * dt) - mpInt->dV;
    const Eigen::Vector3d ep =
        Rbw * (s * (VP2->estimate().twb - VP1->estimate().twb - VV1->estimate() * dt) - g * dt * dt / 2) -
        mpInt->dP;
    _error << er, ev, ep;
  }
  /// The Jacobians of the velocities and of the scale are analytic. The base class computes the Jacobians of
  /// the poses numerically.
  virtual void linearizeOplus() {
    g2o::BaseMultiEdge<9, Vector9d>::linearizeOplus();
    const VertexPose* VP1 = static_cast<const VertexPose*>(_vertices[0]);
    const VertexVelocity* VV1 = static_cast<const VertexVelocity*>(_vertices[1]);
    const VertexPose* VP2 = static_cast<const VertexPose*>(_vertices[2]);
    const VertexVelocity* VV2 = static_cast<const VertexVelocity*>(_vertices[3]);
    const double s = static_cast<const VertexScale*>(_vertices[4])->estimate();
    const Eigen::Matrix3d Rbw = VP1->estimate().Rwb.transpose();
    _jacobianOplus[1].setZero();
    _jacobianOplus[1].block<3, 3>(3, 0) = -s * Rbw;
    _jacobianOplus[1].block<3, 3>(6, 0) = -s * Rbw * mpInt->dt;
    _jacobianOplus[3].setZero();
    _jacobianOplus[3].block<3, 3>(3, 0) = s * Rbw;
    _jacobianOplus[4].setZero();
    _jacobianOplus[4].block<3, 1>(3, 0) = Rbw * (VV2->estimate() - VV1->estimate()) * s;
    _jacobianOplus[4].block<3, 1>(6, 0) =
        Rbw * (VP2->estimate().twb - VP1->estimate().twb - VV1->estimate() * mpInt->dt) * s;
  }
  Eigen::Matrix<double, 9, 9> GetHessian2() {
    linearizeOplus();
    Eigen::Matrix<double, 9, 9> J;
    J.block<9, 6>(0, 0) = _jacobianOplus[2];
    J.block<9, 3>(0, 6) = _jacobianOplus[3];
    return J.transpose() * information() * J;
  }
  Preintegrated* mpInt;
};

/// The observation of a known point, in normalized image coordinates.
class EdgeMonoOnlyPose : public g2o::BaseUnaryEdge<2, Eigen::Vector2d, VertexPose> {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  EdgeMonoOnlyPose(const Eigen::Vector3d& Xw_) : Xw(Xw_) {}
  virtual bool read(std::istream&) { return false; }
  virtual bool write(std::ostream&) const { return false; }
  void computeError() {
    const VertexPose* VPose = static_cast<const VertexPose*>(_vertices[0]);
    _error = _measurement - g2o::project(VPose->estimate().inCamera(Xw));
  }
  virtual void linearizeOplus() {
    const VertexPose* VPose = static_cast<const VertexPose*>(_vertices[0]);
    const Eigen::Vector3d Xc = VPose->estimate().inCamera(Xw);
    Eigen::Matrix<double, 2, 3> proj_jac;
    proj_jac << 1 / Xc[2], 0, -Xc[0] / (Xc[2] * Xc[2]), 0, 1 / Xc[2], -Xc[1] / (Xc[2] * Xc[2]);
    Eigen::Matrix<double, 3, 6> SE3deriv;
    SE3deriv << g2o::skew(Xc), -Eigen::Matrix3d::Identity();
    _jacobianOplusXi = -proj_jac * SE3deriv;
  }
  Eigen::Matrix<double, 6, 6> GetHessian() {
    linearizeOplus();
    return _jacobianOplusXi.transpose() * information() * _jacobianOplusXi;
  }
  const Eigen::Vector3d Xw;
};

/// A prior on a state, which comes from an earlier run.
class EdgePriorPoseVelocity : public g2o::BaseMultiEdge<9, Vector9d> {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  EdgePriorPoseVelocity(const ImuCamPose& pose, const Eigen::Vector3d& velocity, const Matrix9d& H)
      : pose_(pose), velocity_(velocity) {
    resize(2);
    setInformation((H + H.transpose()) / 2);
  }
  virtual bool read(std::istream&) { return false; }
  virtual bool write(std::ostream&) const { return false; }
  void computeError() {
    const ImuCamPose& P = static_cast<const VertexPose*>(_vertices[0])->estimate();
    const VertexVelocity* VV = static_cast<const VertexVelocity*>(_vertices.at(1));
    _error << logSO3(pose_.Rwb.transpose() * P.Rwb), pose_.Rwb.transpose() * (P.twb - pose_.twb),
        VV->estimate() - velocity_;
  }

 private:
  ImuCamPose pose_;
  Eigen::Vector3d velocity_;
};

class VisualInertial : public testing::Test {
 protected:
  static constexpr int kStates = 6;
  static constexpr double kScale = 1.3, kDt = 0.5;

  VisualInertial() {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> uniform(-1, 1);
    ImuCamPose pose;
    Eigen::Vector3d v(0.4, 0, 0.1);
    for (int i = 0; i < kStates; ++i) {
      poses.push_back(pose);
      velocities.push_back(v);
      const Eigen::Vector3d a(0.3 * std::sin(i), 0.2 * std::cos(i), 0.1);
      ImuCamPose next = pose;
      next.Rwb = pose.Rwb * expSO3(Eigen::Vector3d(0.02, 0.05 * std::sin(i), 0.03));
      next.twb = pose.twb + v * kDt + a * kDt * kDt / 2;
      const Eigen::Vector3d vNext = v + a * kDt;
      Preintegrated p;
      p.dt = kDt;
      p.dR = pose.Rwb.transpose() * next.Rwb;
      p.dV = pose.Rwb.transpose() * (kScale * (vNext - v) - g * kDt);
      p.dP = pose.Rwb.transpose() * (kScale * (next.twb - pose.twb - v * kDt) - g * kDt * kDt / 2);
      steps.push_back(p);
      pose = next;
      v = vNext;
    }
    for (int j = 0; j < 60; ++j)
      points.emplace_back(3 * uniform(random), 3 * uniform(random), 6 + 2 * uniform(random));
  }

  void observe(g2o::SparseOptimizer& optimizer, VertexPose* VP, const ImuCamPose& truth) {
    for (const Eigen::Vector3d& point : points) {
      EdgeMonoOnlyPose* e = new EdgeMonoOnlyPose(point);
      e->setVertex(0, dynamic_cast<g2o::OptimizableGraph::Vertex*>(VP));
      e->setMeasurement(g2o::project(truth.inCamera(point)));
      e->setInformation(Eigen::Matrix2d::Identity() * 1e5);
      g2o::RobustKernelHuber* rk = new g2o::RobustKernelHuber;
      e->setRobustKernel(rk);
      rk->setDelta(std::sqrt(5.991));
      ASSERT_TRUE(optimizer.addEdge(e));
      monos.push_back(e);
    }
  }

  std::vector<ImuCamPose> poses;
  std::vector<Eigen::Vector3d> velocities;
  std::vector<Preintegrated> steps;
  std::vector<Eigen::Vector3d> points;
  std::vector<EdgeMonoOnlyPose*> monos;
};

TEST_F(VisualInertial, FindsTheScaleOfItsMap) {
  g2o::SparseOptimizer optimizer;
  g2o::BlockSolverX::LinearSolverType* linearSolver;
  linearSolver = new g2o::LinearSolverEigen<g2o::BlockSolverX::PoseMatrixType>();
  g2o::BlockSolverX* solver_ptr = new g2o::BlockSolverX(linearSolver);
  g2o::OptimizationAlgorithmLevenberg* solver = new g2o::OptimizationAlgorithmLevenberg(solver_ptr);
  solver->setUserLambdaInit(1e-5);
  optimizer.setAlgorithm(solver);
  for (int i = 0; i < kStates; ++i) {
    VertexPose* VP = new VertexPose;
    VP->setEstimate(poses[static_cast<size_t>(i)]);
    VP->setId(i);
    VP->setFixed(true);
    optimizer.addVertex(VP);
    VertexVelocity* VV = new VertexVelocity;
    VV->setId(kStates + i);
    optimizer.addVertex(VV);
  }
  VertexScale* VS = new VertexScale(1.0);
  VS->setId(2 * kStates);
  optimizer.addVertex(VS);
  for (int i = 0; i + 1 < kStates; ++i) {
    EdgeInertial* ei = new EdgeInertial(&steps[static_cast<size_t>(i)]);
    g2o::HyperGraph::Vertex* VP1 = optimizer.vertex(i);
    ei->setVertex(0, dynamic_cast<g2o::OptimizableGraph::Vertex*>(VP1));
    ei->setVertex(1, optimizer.vertex(kStates + i));
    ei->setVertex(2, optimizer.vertex(i + 1));
    ei->setVertex(3, optimizer.vertex(kStates + i + 1));
    ei->setVertex(4, optimizer.vertex(2 * kStates));
    ASSERT_TRUE(optimizer.addEdge(ei));
  }
  optimizer.initializeOptimization();
  optimizer.computeActiveErrors();
  const double before = optimizer.activeRobustChi2();
  EXPECT_GT(optimizer.optimize(100), 0);
  EXPECT_LT(optimizer.activeRobustChi2(), 1e-6 * before);
  EXPECT_NEAR(VS->estimate(), kScale, 1e-5);
  for (size_t i = 0; i < kStates; ++i) {
    const auto* VV = static_cast<VertexVelocity*>(optimizer.vertex(kStates + static_cast<int>(i)));
    EXPECT_LT((VV->estimate() - velocities[i]).norm(), 1e-4);
  }
}

TEST_F(VisualInertial, TheHessianOfARunIsThePriorOfTheNextRun) {
  Matrix9d H = Matrix9d::Zero();
  ImuCamPose pose;
  Eigen::Vector3d velocity;
  for (const bool has_prior : {false, true}) {
    monos.clear();
    const size_t k = has_prior ? 1 : 0;
    g2o::SparseOptimizer optimizer;
    optimizer.setAlgorithm(new g2o::OptimizationAlgorithmGaussNewton(
        new g2o::BlockSolverX(new g2o::LinearSolverEigen<g2o::BlockSolverX::PoseMatrixType>())));
    VertexPose* VP[2];
    VertexVelocity* VV[2];
    for (size_t i = 0; i < 2; ++i) {
      VP[i] = new VertexPose;
      ImuCamPose start = has_prior && i == 0 ? pose : poses[k + i];
      if (i == 1) start.twb += Eigen::Vector3d(0.05, -0.03, 0.04);
      VP[i]->setEstimate(start);
      VP[i]->setId(static_cast<int>(i));
      VP[i]->setFixed(i == 0 && !has_prior);
      optimizer.addVertex(VP[i]);
      VV[i] = new VertexVelocity;
      VV[i]->setEstimate(has_prior && i == 0 ? velocity : velocities[k + i]);
      VV[i]->setId(static_cast<int>(2 + i));
      VV[i]->setFixed(i == 0 && !has_prior);
      optimizer.addVertex(VV[i]);
    }
    VertexScale* VS = new VertexScale(kScale);
    VS->setId(4);
    VS->setFixed(true);
    optimizer.addVertex(VS);
    EdgeInertial* ei = new EdgeInertial(&steps[k]);
    ei->setVertex(0, VP[0]);
    ei->setVertex(1, VV[0]);
    ei->setVertex(2, VP[1]);
    ei->setVertex(3, VV[1]);
    ei->setVertex(4, VS);
    ASSERT_TRUE(optimizer.addEdge(ei));
    observe(optimizer, VP[1], poses[k + 1]);
    if (has_prior) {
      EdgePriorPoseVelocity* ep = new EdgePriorPoseVelocity(pose, velocity, H);
      ep->setVertex(0, VP[0]);
      ep->setVertex(1, VV[0]);
      ASSERT_TRUE(optimizer.addEdge(ep));
    }
    ASSERT_TRUE(optimizer.initializeOptimization(0));
    EXPECT_EQ(optimizer.optimize(10), 10);
    EXPECT_LT((VP[1]->estimate().twb - poses[k + 1].twb).norm(), 1e-6);
    EXPECT_LT((VV[1]->estimate() - velocities[k + 1]).norm(), 1e-5);

    // The Hessian of the second state, summed up from the Jacobians of the edges after the run.
    H.setZero();
    H += ei->GetHessian2();
    for (EdgeMonoOnlyPose* e : monos) H.block<6, 6>(0, 0) += e->GetHessian();
    if (!has_prior) {
      const Eigen::Matrix<double, 6, 6> mapped = VP[1]->A();
      EXPECT_LT((H.block<6, 6>(0, 0) - mapped).norm(), 1e-5 * mapped.norm());
    }
    pose = VP[1]->estimate();
    velocity = VV[1]->estimate();
  }
}

}  // namespace
