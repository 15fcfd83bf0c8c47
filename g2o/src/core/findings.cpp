// SPDX-License-Identifier: BSD-3-Clause
#include "core/findings.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <exception>
#include <set>
#include <typeindex>
#include <typeinfo>
#include <unordered_map>
#include <vector>

#include "base/disjoint_sets.h"
#include "engine/edge_parts.h"
#include "g2o/core/base_edge.h"
#include "g2o/core/factory.h"
#include "g2o/stuff/logger.h"

namespace g2o {
namespace internal {
namespace {

using Edge = OptimizableGraph::Edge;
using Vertex = OptimizableGraph::Vertex;

/// The elements with one kind of fault.
class Faults {
 public:
  explicit Faults(const char* kind) : kind_(kind) {}
  void add(const std::string& element) {
    if (count_++ < kNamed) names_ += (names_.empty() ? "" : "; ") + element;
  }
  void report() const {
    if (count_ == 0) return;
    const std::string more = count_ > kNamed ? " and " + std::to_string(count_ - kNamed) + " more" : "";
    G2O_ERROR("finding: {}: {}{}", kind_, names_, more);
  }

 private:
  static constexpr int kNamed = 3;
  const char* kind_;
  std::string names_;
  int count_ = 0;
};

/// What is wrong with Ω, or an empty text.
std::string fault_of_information(const Edge& edge) {
  const InformationCheck check = checkInformation(edge);
  if (!std::isfinite(check.largest)) return "not finite";
  if (check.largest == 0) return "zero";
  if (!check.symmetric) return "not symmetric";
  if (!check.definite) return "indefinite, with the eigenvalue " + std::to_string(check.least_eigenvalue);
  return "";
}

class Search {
 public:
  explicit Search(SparseOptimizer& optimizer)
      : optimizer_(optimizer), sets_(optimizer.indexMapping().size()) {
    for (const Vertex* v : optimizer.indexMapping()) derivatives_.emplace_back(VectorX::Zero(v->dimension()));
    is_held_.resize(derivatives_.size(), false);
  }

  void run() {
    for (Edge* edge : optimizer_.activeEdges()) visit(*edge);
    add_vertices();
    for (const Faults* faults : {&errors_, &information_, &jacobians_, &wrong_, &still_, &free_})
      faults->report();
  }

 private:
  void visit(Edge& edge) {
    if (!is_complete(edge) || edge.dimension() <= 0) return;
    join(edge);
    if (const std::string fault = fault_of_information(edge); !fault.empty())
      information_.add(nameOf(edge) + " (" + fault + ")");
    edge.computeError();
    if (!Eigen::Map<const VectorX>(edge.errorData(), edge.dimension()).allFinite())
      return errors_.add(nameOf(edge));
    edge.linearizeOplus(optimizer_.jacobianWorkspace());
    const bool is_first = types_.insert(std::type_index(typeid(edge))).second;
    for (size_t i = 0; i < edge.vertices().size(); ++i) {
      auto* v = static_cast<Vertex*>(edge.vertex(i));
      if (!is_active(*v) || v->dimension() <= 0) continue;
      const MatrixX J =
          Eigen::Map<const MatrixX>(optimizer_.jacobianWorkspace().workspaceForVertex(static_cast<int>(i)),
                                    edge.dimension(), v->dimension());
      if (!J.allFinite()) {
        jacobians_.add(nameOf(edge) + " with respect to vertex " + std::to_string(v->id()));
        continue;
      }
      derivatives_[index(*v)] += J.colwise().squaredNorm().transpose();
      if (is_first) compare(edge, *v, J);
    }
  }

  static size_t index(const Vertex& v) { return static_cast<size_t>(v.hessianIndex()); }
  /// Clients can change Hessian indices.
  bool is_active(const Vertex& v) const {
    return v.hessianIndex() >= 0 && index(v) < derivatives_.size() &&
           derivatives_[index(v)].size() == v.dimension();
  }

  /// Puts the vertices of the edge into one part of the graph.
  void join(const Edge& edge) {
    const Vertex* first = nullptr;
    bool holds = edge.vertices().size() == 1;
    for (const HyperGraph::Vertex* u : edge.vertices()) {
      const auto* v = static_cast<const Vertex*>(u);
      if (!is_active(*v)) {
        holds = holds || v->fixed();
        continue;
      }
      if (first == nullptr) first = v;
      sets_.join(static_cast<std::uint32_t>(index(*first)), static_cast<std::uint32_t>(index(*v)));
    }
    if (holds && first != nullptr) is_held_[index(*first)] = true;
  }

  /// Compares with central differences. A type may leave out small terms on purpose.
  void compare(Edge& edge, Vertex& v, const MatrixX& J) {
    constexpr double kTolerance = 0.05;
    MatrixX numeric(J.rows(), J.cols());
    numericJacobian(edge, v, numeric.data());
    if (!numeric.allFinite()) return;
    int row = 0, column = 0;
    const double largest = (J - numeric).cwiseAbs().maxCoeff(&row, &column);
    if (largest <= kTolerance * std::max(J.cwiseAbs().maxCoeff(), numeric.cwiseAbs().maxCoeff())) return;
    wrong_.add(nameOf(edge) + ": row " + std::to_string(row + 1) + ", column " + std::to_string(column + 1) +
               " for vertex " + std::to_string(v.id()) + " is " + std::to_string(J(row, column)) +
               ", central differences give " + std::to_string(numeric(row, column)));
  }

  void add_vertices() {
    std::unordered_map<std::uint32_t, std::vector<int>> parts;
    std::set<std::uint32_t> held;
    for (const Vertex* v : optimizer_.indexMapping()) {
      if (!is_active(*v)) continue;
      const VectorX& d = derivatives_[index(*v)];
      std::string directions;
      for (int k = 0; k < d.size(); ++k) {
        if (d[k] == 0) directions += (directions.empty() ? "" : ", ") + std::to_string(k);
      }
      if (!directions.empty())
        still_.add("vertex " + std::to_string(v->id()) + " (" + directions + " of " +
                   std::to_string(d.size()) + ")");
      const std::uint32_t root = sets_.find(static_cast<std::uint32_t>(index(*v)));
      parts[root].push_back(v->id());
      if (is_held_[index(*v)]) held.insert(root);
    }
    for (const Vertex* v : optimizer_.indexMapping()) {  // in a fixed order
      if (!is_active(*v)) continue;
      const auto part = parts.find(static_cast<std::uint32_t>(index(*v)));
      if (part == parts.end() || held.count(part->first) > 0) continue;
      const auto [least, most] = std::minmax_element(part->second.begin(), part->second.end());
      free_.add(std::to_string(part->second.size()) + " vertices with ids from " + std::to_string(*least) +
                " to " + std::to_string(*most));
    }
  }

  SparseOptimizer& optimizer_;
  boxplus::DisjointSets sets_;
  std::vector<VectorX> derivatives_;  // squared norms of the columns, per vertex
  std::vector<bool> is_held_;
  std::set<std::type_index> types_;
  Faults errors_{"errors that are not finite"}, information_{"faulty information matrices"},
      jacobians_{"Jacobians that are not finite"}, wrong_{"wrong Jacobians"},
      still_{"directions that change no error"},
      free_{"parts of the graph without a fixed vertex and without an edge to a single vertex"};
};

}  // namespace

InformationCheck checkInformation(const Edge& edge) {
  constexpr double kRounding = 1e-9;
  const MatrixX omega = Eigen::Map<const MatrixX>(edge.informationData(), edge.dimension(), edge.dimension());
  InformationCheck check;
  if (!omega.allFinite()) return check;
  check.largest = omega.cwiseAbs().maxCoeff();
  check.symmetric = (omega - omega.transpose()).cwiseAbs().maxCoeff() <= kRounding * check.largest;
  if (!check.symmetric) return check;
  check.least_eigenvalue =
      Eigen::SelfAdjointEigenSolver<MatrixX>(omega, Eigen::EigenvaluesOnly).eigenvalues()[0];
  check.definite = check.least_eigenvalue >= -kRounding * check.largest;
  return check;
}

std::string nameOf(const Edge& edge) {
  std::string name = Factory::instance()->tag(&edge);
  if (name.empty()) name = typeid(edge).name();
  for (const HyperGraph::Vertex* v : edge.vertices())
    name += v != nullptr ? " " + std::to_string(v->id()) : " -";
  return name;
}

void reportFindings(SparseOptimizer& optimizer) {
  try {
    Search(optimizer).run();
  } catch (const std::exception& error) {
    G2O_ERROR("finding: an error function or a vertex throws: {}", error.what());
  }
}

}  // namespace internal
}  // namespace g2o
