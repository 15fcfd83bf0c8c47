// SPDX-License-Identifier: BSD-3-Clause
// No certificate is false, whatever the scale of Ω, the span of the weights and the positions.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "boxplus/certify/certificate.h"
#include "optimize/small_graphs.h"

namespace boxplus {
namespace {

using Verdict = Certificate::Verdict;

struct Units {
  int count = 20;     ///< of poses on a circle
  int turns = 1;      ///< how often the start is wound too often
  double omega = 1;   ///< the scale of all Ω
  double heavy = 0;   ///< the Ω of an edge to a further pose, which is satisfied
  double offset = 0;  ///< of all positions
};

/// Identical poses on a circle whose start is wound.
Graph wound(const Units& units) {
  Graph graph;
  std::vector<VertexHandle<SE3>> poses;
  for (int k = 0; k < units.count; ++k) {
    const double half = kPi * units.turns * k / units.count;
    poses.push_back(graph.add_vertex(
        SE3(Vector3::Constant(units.offset), SE3::Quaternion{0, 0, std::sin(half), std::cos(half)})));
  }
  for (std::size_t k = 0; k < poses.size(); ++k)
    graph.add_edge(Between(SE3()), units.omega, poses[k], poses[(k + 1) % poses.size()]);
  if (units.heavy > 0)
    graph.add_edge(Between(SE3()), units.heavy, poses[0],
                   graph.add_vertex(SE3(Vector3::Constant(units.offset), SO3())));
  return graph;
}

TEST(CertifyWoundCircle, IsNoGlobalMinimumWhateverItsUnits) {
  for (const Units& units :
       {Units{}, Units{.omega = 1e-8}, Units{.omega = 1e-12}, Units{.omega = 1e12}, Units{.heavy = 1e26},
        Units{.heavy = 1e12}, Units{.offset = 1e6}, Units{.offset = 1e13}}) {
    Graph graph = wound(units);
    std::ignore = optimize(graph);
    const Certificate certificate = certify(graph);
    EXPECT_NE(certificate.verdict, Verdict::kGlobalMinimum)
        << certificate << ' ' << units.omega << ' ' << units.heavy << ' ' << units.offset;
  }
}

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double normal() { return normal_(engine_); }
  double uniform() { return static_cast<double>(engine_()) / 4294967296.0; }
  double one_of(std::initializer_list<double> values) {
    return values.begin()[static_cast<std::size_t>(uniform() * static_cast<double>(values.size()))];
  }

 private:
  std::mt19937 engine_;
  std::normal_distribution<> normal_{0, 1};
};

SE2 pose_of(const SE2&, double x, double y, double /*z*/, double heading) {
  return {x, y, heading};
}
SE3 pose_of(const SE3&, double x, double y, double z, double heading) {
  return {Vector3(x, y, z), SE3::Quaternion{0, 0, std::sin(heading / 2), std::cos(heading / 2)}};
}

/// A circle or a grid with random units, weights and noise, whose start is wound.
template <class Pose>
class HardGraph {
 public:
  explicit HardGraph(unsigned seed) : random_(seed) {
    noise_ = random_.one_of({0, 1e-9, 1e-6, 1e-3, 0.02, 0.1, 0.5});
    size_ = random_.one_of({1, 1, 1, 1e-3, 1e4, 1e13});
    offset_ = random_.one_of({0, 0, 0, 1e5, 1e10, 1e13, 1e14});
    unit_ = random_.one_of({1, 1, 1e-12, 1e-8, 1e-4, 1e4, 1e8, 1e12});
    span_ = random_.one_of({0, 0, 2, 8, 12, 16});
    heavy_ = random_.one_of({0, 0, 0, 1e8, 1e16, 1e26});
    turns_ = static_cast<int>(random_.one_of({0, 0, 1, 1, 2}));
    random_.uniform() < 0.7 ? circle() : grid();
    if (heavy_ > 0) {
      truth_.push_back(truth_[0]);
      edges_.push_back({0, truth_.size() - 1, Pose(), information(heavy_, heavy_)});
    }
  }

  /// The graph with the truth, wound `turns` times and moved by `offset`, as its start.
  Graph graph(int turns, double offset) const {
    Graph graph;
    std::vector<VertexHandle<Pose>> poses;
    const auto count = static_cast<double>(truth_.size() - (heavy_ > 0 ? 1 : 0));
    for (std::size_t k = 0; k < truth_.size(); ++k) {
      const double turn = 2 * kPi * turns * static_cast<double>(k) / count;
      const bool is_pendant = heavy_ > 0 && k + 1 == truth_.size();
      const Pose place = pose_of(Pose(), offset, -offset, 0.3 * offset, 0.0);
      poses.push_back(graph.add_vertex(place * truth_[k] * pose_of(Pose(), 0, 0, 0, is_pendant ? 0 : turn)));
    }
    for (const Edge& edge : edges_)
      graph.add_edge(Between(edge.motion), edge.omega, poses[edge.from], poses[edge.to]);
    return graph;
  }
  Graph start() const { return graph(turns_, offset_); }

  /// The lowest chi2 that runs from several starts find, at the origin.
  double best() const {
    double lowest = std::numeric_limits<double>::infinity();
    for (const Start start : {Start::kCurrent, Start::kChordal}) {
      Graph copy = graph(0, 0);
      Options options;
      options.start = start;
      std::ignore = optimize(copy, options);
      lowest = std::min({lowest, copy.chi2(), graph(0, 0).chi2()});
    }
    return lowest;
  }

  /// By how much chi2 may be wrong because positions have only the digits of a double.
  double rounding(double chi2) const {
    double sum = 0;
    for (const Edge& edge : edges_) {
      const double far =
          offset_ + 1 + edge.motion.translation().norm() + truth_[edge.from].translation().norm();
      sum += edge.omega.diagonal().maxCoeff() * std::pow(4e-16 * far, 2);
    }
    return sum + 2 * std::sqrt(sum * chi2);
  }

  std::string text() const {
    return "noise " + std::to_string(noise_) + " size " + std::to_string(size_) + " offset " +
           std::to_string(offset_) + " unit " + std::to_string(std::log10(unit_)) + " span " +
           std::to_string(span_) + " heavy " + std::to_string(heavy_) + " turns " + std::to_string(turns_) +
           " edges " + std::to_string(edges_.size());
  }

 private:
  static constexpr int kDim = Manifold<Pose>::kDim;

  struct Edge {
    std::size_t from, to;
    Pose motion;
    Eigen::MatrixXd omega;
  };

  /// Isotropic for the translation.
  static Eigen::MatrixXd information(double translation, double rotation) {
    Eigen::VectorXd diagonal = Eigen::VectorXd::Constant(kDim, rotation);
    diagonal.head(kDim == 3 ? 2 : 3).setConstant(translation);
    return diagonal.asDiagonal();
  }

  void circle() {
    const int count = 5 + static_cast<int>(20 * random_.uniform());
    const bool turns = random_.uniform() < 0.5;
    for (int k = 0; k < count; ++k) {
      const double angle = 2 * kPi * k / count;
      truth_.push_back(
          pose_of(Pose(), size_ * std::cos(angle), size_ * std::sin(angle), 0, turns ? angle : 0));
    }
    for (int k = 0; k < count; ++k) link(k, (k + 1) % count);
  }

  void grid() {
    const int side = 2 + static_cast<int>(3 * random_.uniform());
    for (int k = 0; k < side * side; ++k)
      truth_.push_back(pose_of(Pose(), size_ * (k % side), size_ * (k / side), 0, 6.28 * random_.uniform()));
    for (int k = 0; k < side * side; ++k) {
      if (k % side + 1 < side) link(k, k + 1);
      if (k + side < side * side) link(k, k + side);
    }
  }

  void link(int a, int b) {
    const auto from = static_cast<std::size_t>(a), to = static_cast<std::size_t>(b);
    double delta[kDim];
    for (int k = 0; k < kDim; ++k)
      delta[k] = noise_ * random_.normal() * (k < (kDim == 3 ? 2 : 3) ? size_ : 1);
    const double weight = unit_ * std::pow(10, span_ * random_.uniform());
    const double rotation = std::pow(10, std::min(span_, 4.0) * (random_.uniform() - 0.5));
    const Pose motion = Manifold<Pose>::oplus(truth_[from].inverse() * truth_[to], delta);
    edges_.push_back({from, to, motion, information(weight / (size_ * size_), weight * rotation)});
  }

  Random random_;
  double noise_, size_, offset_, unit_, span_, heavy_;
  int turns_;
  std::vector<Pose> truth_;
  std::vector<Edge> edges_;
};

/// Whether all measurements fit up to rounding.
bool fits(const Graph& graph, const std::vector<EdgeRef>& edges) {
  return std::all_of(edges.begin(), edges.end(), [&](const EdgeRef& edge) {
    const Eigen::MatrixXd omega = graph.information(edge).matrix();
    return graph.chi2(edge) <= 1e-20 * omega.diagonal().minCoeff();
  });
}

struct Counts {
  int global = 0, local = 0, undecided = 0, wrong = 0;
};

template <class Pose>
void judge(unsigned seed, Counts& counts) {
  const HardGraph<Pose> hard(seed);
  Graph graph = hard.start();
  std::ignore = optimize(graph);
  const Certificate certificate = certify(graph);
  ++(certificate.verdict == Verdict::kGlobalMinimum  ? counts.global
     : certificate.verdict == Verdict::kLocalMinimum ? counts.local
                                                     : counts.undecided);
  const double best = hard.best(), rounding = hard.rounding(best);
  const bool is_bound = certificate.chi2_bound() <= best * (1 + 1e-9) + rounding;
  const bool is_false = certificate.verdict == Verdict::kGlobalMinimum &&
                        certificate.chi2 > best * (1 + 1e-6) + rounding && !fits(graph, graph.all_edges());
  counts.wrong += !is_bound || is_false;
  EXPECT_TRUE(is_bound) << seed << ' ' << certificate.chi2_bound() << " best " << best << ' ' << hard.text();
  EXPECT_FALSE(is_false) << seed << ' ' << certificate << ' ' << certificate.chi2 << " best " << best << " + "
                         << rounding << ' ' << hard.text();
}

constexpr unsigned kGraphs = 150;  // of each kind

TEST(CertifyHardGraphs, GiveNoFalseCertificate) {
  Counts plane, space;
  for (unsigned seed = 0; seed < kGraphs; ++seed) {
    judge<SE2>(seed, plane);
    judge<SE3>(seed, space);
  }
  for (const Counts& counts : {plane, space}) {
    EXPECT_EQ(counts.wrong, 0);
    EXPECT_GT(counts.global, kGraphs / 5);
    EXPECT_GT(counts.local, kGraphs / 20);
  }
}

}  // namespace
}  // namespace boxplus
