// SPDX-License-Identifier: BSD-3-Clause
// A client that tracks, maps and closes loops as in visual SLAM, with the types of the library and old header
// paths. It optimizes single poses, runs bundle adjustment, finds the similarity between two keyframes, and
// closes a loop with scale drift.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include "g2o/core/block_solver.h"
#include "g2o/core/factory.h"
#include "g2o/core/optimization_algorithm_levenberg.h"
#include "g2o/core/robust_kernel_impl.h"
#include "g2o/core/sparse_optimizer.h"
#include "g2o/solvers/linear_solver_dense.h"
#include "g2o/solvers/linear_solver_eigen.h"
#include "g2o/types/types_seven_dof_expmap.h"
#include "g2o/types/types_six_dof_expmap.h"

G2O_USE_TYPE_GROUP(sba);
G2O_USE_TYPE_GROUP(expmap);

namespace {

struct KeyFrame {
  static constexpr float fx = 500, fy = 510, cx = 320, cy = 240, mbf = 60;
  g2o::SE3Quat Tcw;
};

/// Cameras along an arc, and points in front of them.
struct World {
  std::mt19937 random{7};
  std::vector<KeyFrame> frames;
  std::vector<Eigen::Vector3d> points;

  World() {
    std::uniform_real_distribution<double> uniform(-1, 1);
    for (int i = 0; i < 7; ++i) {
      const Eigen::AngleAxisd turn(0.04 * i, Eigen::Vector3d::UnitY());
      frames.push_back(
          {g2o::SE3Quat(turn.toRotationMatrix(), Eigen::Vector3d(-0.3 * i, 0.02 * i, 0.05 * i))});
    }
    for (int j = 0; j < 150; ++j)
      points.emplace_back(3 * uniform(random), 2 * uniform(random), 6 + 2 * uniform(random));
  }

  Eigen::Vector2d mono(const KeyFrame& frame, const Eigen::Vector3d& point) const {
    const Eigen::Vector3d p = frame.Tcw.map(point);
    return {frame.fx * p.x() / p.z() + frame.cx, frame.fy * p.y() / p.z() + frame.cy};
  }
  Eigen::Vector3d stereo(const KeyFrame& frame, const Eigen::Vector3d& point) const {
    const Eigen::Vector2d uv = mono(frame, point);
    return {uv[0], uv[1], uv[0] - frame.mbf / frame.Tcw.map(point).z()};
  }
  Eigen::Vector3d noise(double sigma) {
    std::normal_distribution<double> normal(0, sigma);
    const double x = normal(random), y = normal(random);
    return {x, y, normal(random)};
  }
  g2o::SE3Quat disturbed(const g2o::SE3Quat& T, double meters, double radians) {
    g2o::Vector6 step;
    step << noise(radians), noise(meters);
    return g2o::SE3Quat::exp(step) * T;
  }
};

double distance_of_centers(const g2o::SE3Quat& a, const g2o::SE3Quat& b) {
  return (a.inverse().translation() - b.inverse().translation()).norm();
}

constexpr float chi2Mono = 5.991f, chi2Stereo = 7.815f;

template <class Edge>
void setCamera(Edge* e, const KeyFrame& frame) {
  e->fx = frame.fx;
  e->fy = frame.fy;
  e->cx = frame.cx;
  e->cy = frame.cy;
}

TEST(VisualSlam, FindsAPoseDespiteOutliersInFourRounds) {
  World world;
  const KeyFrame& frame = world.frames[3];

  g2o::SparseOptimizer optimizer;
  g2o::BlockSolver_6_3::LinearSolverType* linearSolver;
  linearSolver = new g2o::LinearSolverDense<g2o::BlockSolver_6_3::PoseMatrixType>();
  g2o::BlockSolver_6_3* solver_ptr = new g2o::BlockSolver_6_3(linearSolver);
  g2o::OptimizationAlgorithmLevenberg* solver = new g2o::OptimizationAlgorithmLevenberg(solver_ptr);
  optimizer.setAlgorithm(solver);

  const g2o::SE3Quat start = world.disturbed(frame.Tcw, 0.1, 0.03);
  g2o::VertexSE3Expmap* vSE3 = new g2o::VertexSE3Expmap();
  vSE3->setEstimate(start);
  vSE3->setId(0);
  vSE3->setFixed(false);
  optimizer.addVertex(vSE3);

  std::vector<g2o::EdgeSE3ProjectXYZOnlyPose*> monoEdges;
  std::vector<g2o::EdgeStereoSE3ProjectXYZOnlyPose*> stereoEdges;
  for (size_t i = 0; i < world.points.size(); ++i) {
    const Eigen::Vector3d gross = i % 10 == 0 ? Eigen::Vector3d(40, -30, 20) : Eigen::Vector3d::Zero();
    const Eigen::Vector3d z = world.stereo(frame, world.points[i]) + world.noise(0.5) + gross;
    g2o::RobustKernelHuber* rk = new g2o::RobustKernelHuber;
    if (i % 2 == 0) {
      auto* e = new g2o::EdgeSE3ProjectXYZOnlyPose();
      e->setVertex(0, dynamic_cast<g2o::OptimizableGraph::Vertex*>(optimizer.vertex(0)));
      e->setMeasurement(z.head<2>());
      e->setInformation(Eigen::Matrix2d::Identity());
      e->setRobustKernel(rk);
      rk->setDelta(std::sqrt(chi2Mono));
      setCamera(e, frame);
      e->Xw = world.points[i];
      optimizer.addEdge(e);
      monoEdges.push_back(e);
    } else {
      auto* e = new g2o::EdgeStereoSE3ProjectXYZOnlyPose();
      e->setVertex(0, dynamic_cast<g2o::OptimizableGraph::Vertex*>(optimizer.vertex(0)));
      e->setMeasurement(z);
      Eigen::Matrix3d Info = Eigen::Matrix3d::Identity();
      e->setInformation(Info);
      e->setRobustKernel(rk);
      rk->setDelta(std::sqrt(chi2Stereo));
      setCamera(e, frame);
      e->bf = frame.mbf;
      e->Xw = world.points[i];
      optimizer.addEdge(e);
      stereoEdges.push_back(e);
    }
  }

  size_t bad = 0;
  const auto classify = [&bad](auto& edges, float threshold, bool last_with_kernel) {
    for (auto* e : edges) {
      if (e->level() == 1) e->computeError();  // optimize() does not update inactive edges
      const bool outlier = e->chi2() > threshold;
      e->setLevel(outlier ? 1 : 0);
      bad += outlier;
      if (last_with_kernel) e->setRobustKernel(0);
    }
  };
  for (int round = 0; round < 4; ++round) {
    vSE3->setEstimate(start);
    optimizer.initializeOptimization(0);
    EXPECT_GT(optimizer.optimize(10), 0);
    bad = 0;
    classify(monoEdges, chi2Mono, round == 2);
    classify(stereoEdges, chi2Stereo, round == 2);
  }
  EXPECT_GE(bad, world.points.size() / 10);
  EXPECT_LT(bad, world.points.size() / 6);
  g2o::VertexSE3Expmap* recovered = static_cast<g2o::VertexSE3Expmap*>(optimizer.vertex(0));
  EXPECT_LT(distance_of_centers(recovered->estimate(), frame.Tcw), 0.01);
  EXPECT_LT((recovered->estimate().to_homogeneous_matrix() - frame.Tcw.to_homogeneous_matrix()).norm(), 0.02);
}

class LocalMap : public testing::Test {
 protected:
  void SetUp() override {
    g2o::BlockSolver_6_3::LinearSolverType* linearSolver =
        new g2o::LinearSolverEigen<g2o::BlockSolver_6_3::PoseMatrixType>();
    optimizer.setAlgorithm(new g2o::OptimizationAlgorithmLevenberg(new g2o::BlockSolver_6_3(linearSolver)));
    optimizer.setForceStopFlag(&stop);
  }

  void add() {
    for (size_t i = 0; i < world.frames.size(); ++i) {
      auto* vSE3 = new g2o::VertexSE3Expmap();
      vSE3->setEstimate(i < 2 ? world.frames[i].Tcw : world.disturbed(world.frames[i].Tcw, 0.05, 0.01));
      vSE3->setId(static_cast<int>(i));
      vSE3->setFixed(i < 2);
      ASSERT_TRUE(optimizer.addVertex(vSE3));
    }
    for (size_t j = 0; j < world.points.size(); ++j) {
      auto* vPoint = new g2o::VertexSBAPointXYZ();
      vPoint->setEstimate(world.points[j] + world.noise(0.05));
      const int id = static_cast<int>(world.frames.size() + j);
      vPoint->setId(id);
      vPoint->setMarginalized(true);
      ASSERT_TRUE(optimizer.addVertex(vPoint));
      for (size_t i = 0; i < world.frames.size(); ++i)
        observe(id, i, (i + j) % 2 == 0, (7 * i + j) % 20 == 0);
    }
  }

  void observe(int pointId, size_t i, bool mono, bool gross) {
    const KeyFrame& frame = world.frames[i];
    const Eigen::Vector3d& point = world.points[static_cast<size_t>(pointId) - world.frames.size()];
    Eigen::Vector3d z = world.stereo(frame, point) + world.noise(0.5);
    if (gross) z += Eigen::Vector3d(50, 40, 20);
    auto* rk = new g2o::RobustKernelHuber;
    rk->setDelta(std::sqrt(mono ? chi2Mono : chi2Stereo));
    const auto attach = [&](auto* e) {
      e->setVertex(0, dynamic_cast<g2o::OptimizableGraph::Vertex*>(optimizer.vertex(pointId)));
      e->setVertex(1, dynamic_cast<g2o::OptimizableGraph::Vertex*>(optimizer.vertex(static_cast<int>(i))));
      e->setRobustKernel(rk);
      setCamera(e, frame);
      ASSERT_TRUE(optimizer.addEdge(e));
    };
    if (mono) {
      auto* e = new g2o::EdgeSE3ProjectXYZ();
      e->setMeasurement(z.head<2>());
      e->setInformation(Eigen::Matrix2d::Identity() * 4);
      attach(e);
      monoEdges.push_back(e);
    } else {
      auto* e = new g2o::EdgeStereoSE3ProjectXYZ();
      e->setMeasurement(z);
      e->setInformation(Eigen::Matrix3d::Identity() * 4);
      e->bf = frame.mbf;
      attach(e);
      stereoEdges.push_back(e);
    }
  }

  template <class Edges>
  size_t takeOut(const Edges& edges, float threshold) {
    size_t count = 0;
    for (auto* e : edges) {
      if (e->chi2() > threshold || !e->isDepthPositive()) {
        e->setLevel(1);
        ++count;
      }
      e->setRobustKernel(0);
    }
    return count;
  }

  double worst() {
    double largest = 0;
    for (size_t i = 0; i < world.frames.size(); ++i) {
      const auto* v = static_cast<g2o::VertexSE3Expmap*>(optimizer.vertex(static_cast<int>(i)));
      largest = std::max(largest, distance_of_centers(v->estimate(), world.frames[i].Tcw));
    }
    return largest;
  }

  World world;
  bool stop = false;
  g2o::SparseOptimizer optimizer;
  std::vector<g2o::EdgeSE3ProjectXYZ*> monoEdges;
  std::vector<g2o::EdgeStereoSE3ProjectXYZ*> stereoEdges;
};

TEST_F(LocalMap, IsOptimizedInTwoRoundsDespiteOutliers) {
  add();
  EXPECT_GT(worst(), 0.04);
  optimizer.initializeOptimization();
  EXPECT_GT(optimizer.optimize(5), 0);
  const size_t edges = monoEdges.size() + stereoEdges.size();
  const size_t bad = takeOut(monoEdges, chi2Mono * 2) + takeOut(stereoEdges, chi2Stereo * 2);
  EXPECT_GE(bad, edges / 21);
  EXPECT_LT(bad, edges / 10);
  optimizer.initializeOptimization(0);
  EXPECT_EQ(optimizer.activeEdges().size(), edges - bad);
  EXPECT_GT(optimizer.optimize(10), 0);
  EXPECT_LT(worst(), 0.01);
  EXPECT_LT(optimizer.activeChi2() / static_cast<double>(optimizer.activeEdges().size()), 3);
}

TEST_F(LocalMap, IsRestoredFromAFileWithItsCameras) {
  add();
  optimizer.computeActiveErrors();
  std::stringstream file;
  ASSERT_TRUE(optimizer.save(file));
  g2o::SparseOptimizer other;
  ASSERT_TRUE(other.load(file));
  const auto chi2 = [](g2o::SparseOptimizer& o) {
    o.initializeOptimization();
    o.computeActiveErrors();
    return o.activeChi2();
  };
  const double expected = chi2(optimizer);
  EXPECT_NEAR(chi2(other), expected, 1e-9 * expected);
}

// Two keyframes observe the same map points. Each keyframe has its own frame and its own scale.
TEST(VisualSlam, FindsTheSimilarityBetweenTwoKeyframes) {
  World world;
  g2o::SparseOptimizer optimizer;
  g2o::BlockSolverX::LinearSolverType* linearSolver;
  linearSolver = new g2o::LinearSolverDense<g2o::BlockSolverX::PoseMatrixType>();
  g2o::OptimizationAlgorithmLevenberg* solver =
      new g2o::OptimizationAlgorithmLevenberg(new g2o::BlockSolverX(linearSolver));
  optimizer.setAlgorithm(solver);

  const g2o::Sim3 truth(Eigen::Quaterniond(Eigen::AngleAxisd(0.1, Eigen::Vector3d::UnitY())),
                        Eigen::Vector3d(0.4, -0.1, 0.2), 1.2);
  g2o::Vector7 off;
  off << 0.02, -0.03, 0.01, 0.05, 0.1, -0.05, 0.1;
  g2o::VertexSim3Expmap* vSim3 = new g2o::VertexSim3Expmap();
  vSim3->_fix_scale = false;
  vSim3->setEstimate(g2o::Sim3(off) * truth);
  vSim3->setId(0);
  vSim3->setFixed(false);
  vSim3->_principle_point1[0] = vSim3->_principle_point2[0] = KeyFrame::cx;
  vSim3->_principle_point1[1] = vSim3->_principle_point2[1] = KeyFrame::cy;
  vSim3->_focal_length1[0] = vSim3->_focal_length2[0] = KeyFrame::fx;
  vSim3->_focal_length1[1] = vSim3->_focal_length2[1] = KeyFrame::fy;
  optimizer.addVertex(vSim3);

  std::vector<g2o::EdgeSim3ProjectXYZ*> edges12;
  std::vector<g2o::EdgeInverseSim3ProjectXYZ*> edges21;
  for (size_t i = 0; i < 60; ++i) {
    const int id1 = static_cast<int>(2 * i + 1), id2 = static_cast<int>(2 * i + 2);
    const Eigen::Vector3d P1 = world.points[i], P2 = truth.inverse().map(P1);
    for (const auto& [id, P] : {std::make_pair(id1, P1), std::make_pair(id2, P2)}) {
      auto* v = new g2o::VertexSBAPointXYZ();
      v->setEstimate(P);
      v->setId(id);
      v->setFixed(true);
      optimizer.addVertex(v);
    }
    const auto pixel = [&](const Eigen::Vector3d& p) {
      return Eigen::Vector2d(KeyFrame::fx * p.x() / p.z() + KeyFrame::cx,
                             KeyFrame::fy * p.y() / p.z() + KeyFrame::cy);
    };
    auto* e12 = new g2o::EdgeSim3ProjectXYZ();
    e12->setVertex(0, optimizer.vertex(id2));
    e12->setVertex(1, dynamic_cast<g2o::OptimizableGraph::Vertex*>(optimizer.vertex(0)));
    e12->setMeasurement(pixel(P1) + world.noise(0.5).head<2>());
    e12->setInformation(Eigen::Matrix2d::Identity());
    auto* rk1 = new g2o::RobustKernelHuber;
    e12->setRobustKernel(rk1);
    rk1->setDelta(std::sqrt(10));
    optimizer.addEdge(e12);
    auto* e21 = new g2o::EdgeInverseSim3ProjectXYZ();
    e21->setVertex(0, optimizer.vertex(id1));
    e21->setVertex(1, dynamic_cast<g2o::OptimizableGraph::Vertex*>(optimizer.vertex(0)));
    e21->setMeasurement(pixel(P2) + world.noise(0.5).head<2>() +
                        (i % 10 == 0 ? Eigen::Vector2d(60, 0) : Eigen::Vector2d::Zero()));
    e21->setInformation(Eigen::Matrix2d::Identity());
    auto* rk2 = new g2o::RobustKernelHuber;
    e21->setRobustKernel(rk2);
    rk2->setDelta(std::sqrt(10));
    optimizer.addEdge(e21);
    edges12.push_back(e12);
    edges21.push_back(e21);
  }
  optimizer.initializeOptimization();
  EXPECT_GT(optimizer.optimize(5), 0);
  int bad = 0;
  for (size_t i = 0; i < edges12.size(); ++i) {
    if (edges12[i]->chi2() <= 10 && edges21[i]->chi2() <= 10) continue;
    optimizer.removeEdge(edges12[i]);
    optimizer.removeEdge(edges21[i]);
    ++bad;
  }
  EXPECT_GE(bad, 6);
  EXPECT_LT(bad, 12);
  optimizer.initializeOptimization();
  EXPECT_GT(optimizer.optimize(10), 0);
  const g2o::Sim3 S = static_cast<g2o::VertexSim3Expmap*>(optimizer.vertex(0))->estimate();
  EXPECT_LT((S * truth.inverse()).log().norm(), 0.02);
}

/// Keyframes on a ring. The scale of the map shrinks by a constant factor from one keyframe to the next.
class EssentialGraph : public testing::Test {
 protected:
  static constexpr int kFrames = 60;
  static constexpr double kShrinks = 0.99, kRadius = 10;

  EssentialGraph() {
    for (int i = 0; i < kFrames; ++i) {
      const double angle = 2 * M_PI * i / kFrames;
      const g2o::SE3Quat Twc(Eigen::Quaterniond(Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ())),
                             Eigen::Vector3d(kRadius * std::cos(angle), kRadius * std::sin(angle), 0));
      truth.push_back(Twc.inverse());
    }
    mapped.push_back(truth[0]);
    for (size_t i = 1; i < truth.size(); ++i) {
      g2o::SE3Quat motion = truth[i] * truth[i - 1].inverse();
      motion.setTranslation(std::pow(kShrinks, static_cast<double>(i)) * motion.translation());
      mapped.push_back(motion * mapped.back());
    }
  }

  void addEdge(size_t i, size_t j, const g2o::Sim3& Sji) {
    auto* e = new g2o::EdgeSim3();
    e->setVertex(1, dynamic_cast<g2o::OptimizableGraph::Vertex*>(optimizer.vertex(static_cast<int>(j))));
    e->setVertex(0, dynamic_cast<g2o::OptimizableGraph::Vertex*>(optimizer.vertex(static_cast<int>(i))));
    e->setMeasurement(Sji);
    e->information() = Eigen::Matrix<double, 7, 7>::Identity();
    ASSERT_TRUE(optimizer.addEdge(e));
  }

  void closeLoop(bool bFixScale) {
    optimizer.setVerbose(false);
    auto linearSolver = std::make_unique<g2o::LinearSolverEigen<g2o::BlockSolver_7_3::PoseMatrixType>>();
    auto solver_ptr = std::make_unique<g2o::BlockSolver_7_3>(std::move(linearSolver));
    auto* solver = new g2o::OptimizationAlgorithmLevenberg(std::move(solver_ptr));
    solver->setUserLambdaInit(1e-16);
    optimizer.setAlgorithm(solver);
    for (size_t i = 0; i < mapped.size(); ++i) {
      auto* VSim3 = new g2o::VertexSim3Expmap();
      VSim3->setEstimate(g2o::Sim3(mapped[i].rotation(), mapped[i].translation(), 1.0));
      VSim3->setFixed(i == 0);
      VSim3->setId(static_cast<int>(i));
      VSim3->setMarginalized(false);
      VSim3->_fix_scale = bFixScale;
      ASSERT_TRUE(optimizer.addVertex(VSim3));
    }
    const auto vertex = [this](size_t i) {
      return static_cast<g2o::VertexSim3Expmap*>(optimizer.vertex(static_cast<int>(i)))->estimate();
    };
    for (size_t i = 1; i < mapped.size(); ++i) addEdge(i - 1, i, vertex(i) * vertex(i - 1).inverse());
    for (size_t i = 2; i < mapped.size(); ++i) addEdge(i - 2, i, vertex(i) * vertex(i - 2).inverse());
    // The loop closure: the last keyframe observes the first keyframe, and measures by how much the scale has
    // shrunk.
    const g2o::SE3Quat back = truth.front() * truth.back().inverse();
    const double scale = bFixScale ? 1 : std::pow(kShrinks, 1 - kFrames);
    addEdge(mapped.size() - 1, 0, g2o::Sim3(back.rotation(), back.translation(), scale));
    ASSERT_TRUE(optimizer.initializeOptimization());
    EXPECT_GT(optimizer.optimize(20), 0);
  }

  /// The largest distance of a keyframe's center from its true position. As in SLAM, the center of a
  /// similarity (s, R, t) is computed from R and t / s.
  double worst() {
    double largest = 0;
    for (size_t i = 0; i < truth.size(); ++i) {
      const g2o::Sim3 S =
          static_cast<g2o::VertexSim3Expmap*>(optimizer.vertex(static_cast<int>(i)))->estimate();
      const g2o::SE3Quat Tiw(S.rotation().toRotationMatrix(), S.translation() * (1. / S.scale()));
      largest = std::max(largest, distance_of_centers(Tiw, truth[i]));
    }
    return largest;
  }

  std::vector<g2o::SE3Quat> truth, mapped;
  g2o::SparseOptimizer optimizer;
};

TEST_F(EssentialGraph, LosesItsScaleDriftWhenTheLoopIsClosed) {
  double before = 0;
  for (size_t i = 0; i < truth.size(); ++i)
    before = std::max(before, distance_of_centers(mapped[i], truth[i]));
  EXPECT_GT(before, 0.3 * kRadius);
  closeLoop(false);
  EXPECT_LT(worst(), 0.1 * kRadius);
  const auto* last = static_cast<g2o::VertexSim3Expmap*>(optimizer.vertex(kFrames - 1));
  EXPECT_NEAR(last->estimate().scale(), std::pow(kShrinks, kFrames - 1), 0.05);
}

TEST_F(EssentialGraph, KeepsAFixedScaleWhenTheLoopIsClosed) {
  closeLoop(true);
  for (int i = 0; i < kFrames; ++i)
    EXPECT_EQ(static_cast<g2o::VertexSim3Expmap*>(optimizer.vertex(i))->estimate().scale(), 1);
  EXPECT_GT(worst(), 0.2 * kRadius);
}

}  // namespace
