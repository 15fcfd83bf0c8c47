// SPDX-License-Identifier: BSD-3-Clause
// A client as in direct visual SLAM: a graph of keyframes whose estimates are custom similarity transforms.
// It sets estimates and measurements from arrays, computes an initial guess along the edges, registers its
// own file tags, and uses old names and raw pointers.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <sstream>
#include <vector>

#include "g2o/core/base_binary_edge.h"
#include "g2o/core/base_vertex.h"
#include "g2o/core/block_solver.h"
#include "g2o/core/estimate_propagator.h"
#include "g2o/core/factory.h"
#include "g2o/core/optimization_algorithm_levenberg.h"
#include "g2o/core/robust_kernel_impl.h"
#include "g2o/core/solver.h"
#include "g2o/core/sparse_optimizer.h"
#include "g2o/solvers/csparse/linear_solver_csparse.h"

namespace {

/// The similarity transform p ↦ s R p + t, a type of the client.
struct Similarity {
  Eigen::Quaterniond q = Eigen::Quaterniond::Identity();
  Eigen::Vector3d t = Eigen::Vector3d::Zero();
  double s = 1;

  Similarity operator*(const Similarity& o) const {
    Similarity r;
    r.q = (q * o.q).normalized();
    r.t = s * (q * o.t) + t;
    r.s = s * o.s;
    return r;
  }
  Similarity inverse() const {
    Similarity r;
    r.q = q.conjugate();
    r.s = 1 / s;
    r.t = -r.s * (r.q * t);
    return r;
  }
  /// The similarity with the given translation, rotation vector and logarithm of the scale. This is not the
  /// exponential map, but another map from the tangent space.
  static Similarity step(const Eigen::Matrix<double, 7, 1>& v) {
    Similarity r;
    const Eigen::Vector3d w = v.segment<3>(3);
    if (w.norm() > 0) r.q = Eigen::AngleAxisd(w.norm(), w.normalized());
    r.t = v.head<3>();
    r.s = std::exp(v[6]);
    return r;
  }
  Eigen::Matrix<double, 7, 1> chart() const {
    const Eigen::AngleAxisd turn(q);
    Eigen::Matrix<double, 7, 1> v;
    v << t, turn.angle() * turn.axis(), std::log(s);
    return v;
  }
};

class VertexFrame : public g2o::BaseVertex<7, Similarity> {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  VertexFrame() : _fix_scale(false) { _marginalized = false; }
  virtual bool read(std::istream& is) {
    Eigen::Matrix<double, 7, 1> v;
    for (int i = 0; i < 7; ++i) is >> v[i];
    setEstimate(Similarity::step(v));
    return !is.fail();
  }
  virtual bool write(std::ostream& os) const {
    const Eigen::Matrix<double, 7, 1> v = estimate().chart();
    for (int i = 0; i < 7; ++i) os << v[i] << " ";
    return os.good();
  }
  virtual void setToOriginImpl() { _estimate = Similarity(); }
  virtual void oplusImpl(const double* update_) {
    Eigen::Map<Eigen::Matrix<double, 7, 1> > update(const_cast<double*>(update_));
    if (_fix_scale) update[6] = 0;
    setEstimate(Similarity::step(update) * estimate());
  }
  virtual bool setEstimateDataImpl(const double* est) {
    Eigen::Map<const Eigen::Matrix<double, 7, 1> > v(est);
    _estimate = Similarity::step(v);
    return true;
  }
  virtual bool getEstimateData(double* est) const {
    Eigen::Map<Eigen::Matrix<double, 7, 1> > v(est);
    v = estimate().chart();
    return true;
  }
  virtual int estimateDimension() const { return 7; }
  virtual bool setMinimalEstimateDataImpl(const double* est) { return setEstimateDataImpl(est); }
  virtual bool getMinimalEstimateData(double* est) const { return getEstimateData(est); }
  virtual int minimalEstimateDimension() const { return 7; }
  bool _fix_scale;
};

class EdgeFrames : public g2o::BaseBinaryEdge<7, Similarity, VertexFrame, VertexFrame> {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  EdgeFrames() { _information.setIdentity(); }
  virtual bool read(std::istream& is) {
    Eigen::Matrix<double, 7, 1> v;
    for (int i = 0; i < 7; ++i) is >> v[i];
    setMeasurement(Similarity::step(v));
    return readInformationMatrix(is);
  }
  virtual bool write(std::ostream& os) const {
    const Eigen::Matrix<double, 7, 1> v = _measurement.chart();
    for (int i = 0; i < 7; ++i) os << v[i] << " ";
    return writeInformationMatrix(os);
  }
  void computeError() {
    const VertexFrame* _from = static_cast<const VertexFrame*>(_vertices[0]);
    const VertexFrame* _to = static_cast<const VertexFrame*>(_vertices[1]);
    const Similarity delta = _from->estimate().inverse() * _to->estimate() * _inverseMeasurement;
    _error = delta.chart();
  }
  virtual void setMeasurement(const Similarity& m) {
    _measurement = m;
    _inverseMeasurement = m.inverse();
  }
  virtual bool setMeasurementData(const double* m) {
    Eigen::Map<const Eigen::Matrix<double, 7, 1> > v(m);
    setMeasurement(Similarity::step(v));
    return true;
  }
  virtual bool setMeasurementFromState() {
    const VertexFrame* from = static_cast<const VertexFrame*>(_vertices[0]);
    const VertexFrame* to = static_cast<const VertexFrame*>(_vertices[1]);
    setMeasurement(from->estimate().inverse() * to->estimate());
    return true;
  }
  virtual int measurementDimension() const { return 7; }
  virtual double initialEstimatePossible(const g2o::OptimizableGraph::VertexSet&,
                                         g2o::OptimizableGraph::Vertex*) {
    return 1.;
  }
  virtual void initialEstimate(const g2o::OptimizableGraph::VertexSet& from,
                               g2o::OptimizableGraph::Vertex* /*to*/) {
    VertexFrame* _from = static_cast<VertexFrame*>(_vertices[0]);
    VertexFrame* _to = static_cast<VertexFrame*>(_vertices[1]);
    if (from.count(_from) > 0) {
      _to->setEstimate(_from->estimate() * _measurement);
    } else {
      _from->setEstimate(_to->estimate() * _inverseMeasurement);
    }
  }

 protected:
  Similarity _inverseMeasurement;
};

G2O_REGISTER_TYPE(VERTEX_FRAME, VertexFrame)
G2O_REGISTER_TYPE(EDGE_FRAMES, EdgeFrames)

/// The class of the client that keeps the optimizer as a member.
class KeyFrameGraph {
 public:
  KeyFrameGraph() {
    typedef g2o::BlockSolver_7_3 BlockSolver;
    typedef g2o::LinearSolverCSparse<BlockSolver::PoseMatrixType> LinearSolver;
    LinearSolver* solver = new LinearSolver();
    BlockSolver* blockSolver = new BlockSolver(solver);
    g2o::OptimizationAlgorithmLevenberg* algorithm = new g2o::OptimizationAlgorithmLevenberg(blockSolver);
    graph.setAlgorithm(algorithm);
    graph.setVerbose(false);
    solver->setWriteDebug(true);
    blockSolver->setWriteDebug(true);
    algorithm->setWriteDebug(true);
  }

  void addKeyFrame(int id) {
    VertexFrame* vertex = new VertexFrame();
    vertex->setId(id);
    if (id == 0) vertex->setFixed(true);
    vertex->setMarginalized(false);
    ASSERT_TRUE(graph.addVertex(vertex));
  }

  void insertConstraint(int first, int second, const Similarity& z, double weight) {
    EdgeFrames* edge = new EdgeFrames();
    edge->setId(totalEdges++);
    edge->setMeasurement(z);
    edge->setInformation(Eigen::Matrix<double, 7, 7>::Identity() * weight);
    edge->resize(2);
    edge->setVertex(0, graph.vertex(first));
    edge->setVertex(1, graph.vertex(second));
    g2o::RobustKernelHuber* robustKernel = new g2o::RobustKernelHuber();
    edge->setRobustKernel(robustKernel);
    robustKernel->setDelta(10);
    ASSERT_TRUE(graph.addEdge(edge));
  }

  int optimize(int num_iterations) {
    if (graph.edges().size() == 0) return 0;
    graph.setVerbose(false);
    graph.initializeOptimization();
    return graph.optimize(num_iterations, false);
  }

  g2o::SparseOptimizer graph;
  int totalEdges = 0;
};

/// Keyframes on a ring, each connected to the next one by an edge without noise.
class DirectSlam : public testing::Test {
 protected:
  static constexpr int kFrames = 20;

  DirectSlam() {
    Eigen::Matrix<double, 7, 1> v;
    v << 1, 0.1, 0, 0, 0, 2 * M_PI / kFrames, 0.01;
    const Similarity motion = Similarity::step(v);
    truth.resize(kFrames);
    for (size_t i = 1; i < kFrames; ++i) truth[i] = truth[i - 1] * motion;
    for (int i = 0; i < kFrames; ++i) frames.addKeyFrame(i);
    for (int i = 0; i < kFrames; ++i) {
      const int j = (i + 1) % kFrames;
      frames.insertConstraint(i, j, between(i, j), 1 + i % 3);
    }
  }
  Similarity between(int i, int j) const {
    return truth[static_cast<size_t>(i)].inverse() * truth[static_cast<size_t>(j)];
  }
  VertexFrame* frame(int i) { return dynamic_cast<VertexFrame*>(frames.graph.vertex(i)); }
  double worst() {
    double largest = 0;
    for (int i = 0; i < kFrames; ++i) {
      const Similarity off = frame(i)->estimate().inverse() * truth[static_cast<size_t>(i)];
      largest = std::max(largest, off.chart().norm());
    }
    return largest;
  }

  std::vector<Similarity> truth;
  KeyFrameGraph frames;
};

TEST_F(DirectSlam, AnInitialGuessIsExactIfTheEdgesAreConsistent) {
  EXPECT_GT(worst(), 1);
  ASSERT_TRUE(frames.graph.initializeOptimization());
  frames.graph.computeInitialGuess();
  EXPECT_LT(worst(), 1e-9);
  frames.graph.setToOrigin();
  EXPECT_GT(worst(), 1);
  g2o::EstimatePropagatorCostOdometry along_the_path(&frames.graph);
  frames.graph.computeInitialGuess(along_the_path);
  EXPECT_LT(worst(), 1e-9);
}

TEST_F(DirectSlam, OptimizesFromEstimatesThatAreSetAsArrays) {
  for (int i = 0; i < kFrames; ++i) {
    std::vector<double> data;
    static_cast<g2o::OptimizableGraph::Vertex*>(frame(i))->setEstimateData(
        truth[static_cast<size_t>(i)].chart());
    ASSERT_TRUE(static_cast<g2o::OptimizableGraph::Vertex*>(frame(i))->getEstimateData(data));
    ASSERT_EQ(data.size(), 7u);
    if (i > 0) data[static_cast<size_t>(i % 7)] += 0.05;
    ASSERT_TRUE(frame(i)->setMinimalEstimateData(data));
  }
  EXPECT_GT(worst(), 0.04);
  EXPECT_GT(frames.optimize(50), 0);
  EXPECT_LT(worst(), 1e-4);
  EXPECT_LT(frames.graph.chi2(), 1e-6);
}

TEST_F(DirectSlam, AVertexCanKeepItsScaleFixed) {
  for (int i = 0; i < kFrames; ++i) frame(i)->_fix_scale = true;
  EXPECT_GT(frames.optimize(10), 0);
  for (int i = 0; i < kFrames; ++i) EXPECT_EQ(frame(i)->estimate().s, 1);
}

TEST_F(DirectSlam, MeasurementsAreSetFromTheEstimatesAndTheGraphIsSavedAndLoaded) {
  ASSERT_TRUE(frames.graph.initializeOptimization());
  frames.graph.computeInitialGuess();
  for (g2o::HyperGraph::EdgeSet::iterator it = frames.graph.edges().begin(); it != frames.graph.edges().end();
       ++it) {
    g2o::OptimizableGraph::Edge* e = static_cast<g2o::OptimizableGraph::Edge*>(*it);
    ASSERT_TRUE(e->setMeasurementFromState());
  }
  frames.graph.computeActiveErrors();
  EXPECT_LT(frames.graph.activeChi2(), 1e-20);
  std::stringstream file;
  ASSERT_TRUE(frames.graph.save(file));
  KeyFrameGraph loaded;
  ASSERT_TRUE(loaded.graph.load(file));
  EXPECT_EQ(loaded.graph.vertices().size(), static_cast<size_t>(kFrames));
  EXPECT_TRUE(loaded.graph.vertex(0)->fixed());
  EXPECT_GT(loaded.optimize(3), 0);
  EXPECT_LT(loaded.graph.activeChi2(), 1e-15);
}

TEST_F(DirectSlam, AKeyframeCanBeRemovedAfterItsEdges) {
  frames.insertConstraint(3, 5, between(3, 5), 1);
  g2o::OptimizableGraph::Vertex* dropped = frames.graph.vertex(4);
  const std::vector<g2o::HyperGraph::Edge*> its(dropped->edges().begin(), dropped->edges().end());
  for (g2o::HyperGraph::Edge* e : its) EXPECT_TRUE(frames.graph.removeEdge(e));
  EXPECT_TRUE(dropped->edges().empty());
  EXPECT_TRUE(frames.graph.removeVertex(dropped));
  ASSERT_TRUE(frames.graph.initializeOptimization());
  frames.graph.computeInitialGuess();
  EXPECT_GT(frames.graph.optimize(2), 0);
  EXPECT_LT((frame(5)->estimate().inverse() * truth[5]).chart().norm(), 1e-8);
}

}  // namespace
