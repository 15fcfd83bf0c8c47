// SPDX-License-Identifier: BSD-3-Clause
#include "engine/edge_parts.h"

#include <atomic>
#include <cstdint>
#include <typeinfo>

#include "core/prefetch.h"
#include "core/thread_safe_types.h"
#include "engine/last_type.h"
#include "engine/part_threads.h"
#include "g2o/core/robust_kernel.h"

namespace g2o {
namespace internal {
namespace {

double robust_chi2(const OptimizableGraph::Edge& edge) {
  if (edge.robustKernel() == nullptr) return edge.chi2();
  Vector3 rho;
  edge.robustKernel()->robustify(edge.chi2(), rho);
  return rho[0];
}

/// Assigns vertices to parts. Vertices are numbered in the order in which edges first use them, and each part
/// gets a range of numbers. Vertices with similar numbers are mostly neighbors, so most edges have all of
/// their vertices in one part.
class VertexParts {
 public:
  explicit VertexParts(const OptimizableGraph::EdgeContainer& edges, int vertices)
      : number_(static_cast<size_t>(vertices), -1) {
    for (const OptimizableGraph::Edge* edge : edges) {
      for (const HyperGraph::Vertex* v : edge->vertices()) {
        const size_t h = index(v);
        if (h < number_.size() && number_[h] < 0) number_[h] = seen_++;
      }
    }
  }

  /// Returns the index of the part that contains all vertices of an edge except the fixed vertices, or −1 if
  /// there is no such part. There are `count` parts.
  int of(const OptimizableGraph::Edge& edge, int count) const {
    int part = -1;
    for (const HyperGraph::Vertex* v : edge.vertices()) {
      const size_t h = index(v);
      if (h == kFixed) continue;
      if (h >= number_.size()) return -1;  // the client changed its Hessian index
      const int here = static_cast<int>(static_cast<std::int64_t>(number_[h]) * count / seen_);
      if (part >= 0 && part != here) return -1;
      part = here;
    }
    return part;
  }

 private:
  static constexpr size_t kFixed = static_cast<size_t>(-1);
  static size_t index(const HyperGraph::Vertex* v) {
    if (v == nullptr) return kFixed;
    const int h = static_cast<const OptimizableGraph::Vertex*>(v)->hessianIndex();
    return h < 0 ? kFixed : static_cast<size_t>(h);
  }

  std::vector<int> number_;  // the number of each vertex, by Hessian index
  int seen_ = 0;
};

}  // namespace

bool EdgeParts::is_of(const Edges& edges) const {
  return known_types_ == thread_safe_types_revision() && edges_ == edges;
}

void EdgeParts::part(const Edges& edges, int vertices) {
  edges_ = edges;
  known_types_ = thread_safe_types_revision();
  left_.clear();
  others_.clear();
  batches_.take(edges, vertices, others_);
  pass_ = {};
  for (Edges& part : parts_) part.clear();
  if (others_.size() < kFewestEdgesForThreads) {
    left_ = others_;
    return;
  }
  const VertexParts vertex_parts(others_, vertices);
  LastType type;
  for (Edge* edge : others_) {
    const int part = type.allowed(typeid(*edge)) ? vertex_parts.of(*edge, kParts) : -1;
    (part < 0 ? left_ : parts_[static_cast<size_t>(part)]).push_back(edge);
  }
}

bool EdgeParts::compute_errors(bool with_batches) {
  std::atomic<bool> is_any_incomplete = false;
  const auto compute = [&](Edge& edge) {
    if (is_complete(edge)) {
      edge.computeError();
    } else {
      is_any_incomplete = true;
    }
  };
  if (left_.size() < others_.size())
    for_each_part(kParts, [&](int part) { for_each_ahead(parts_[static_cast<size_t>(part)], compute); });
  for_each_ahead(left_, compute);
  return (with_batches && compute_errors_of_batches()) || is_any_incomplete;
}

bool EdgeParts::compute_errors_of_batches() {
  if (batches_.empty()) return false;
  pass_ = batches_.compute_errors();
  return pass_.any_incomplete;
}

double EdgeParts::robust_chi2_of_pass() const {
  double sum = pass_.chi2;
  for (const Edge* edge : pass_.with_unknown_kernels) sum += robust_chi2(*edge);
  for_each_ahead(others_, [&](const Edge& edge) { sum += robust_chi2(edge); });
  return sum;
}

bool EdgeParts::linearize_batches(double* values, double* gradient, bool with_errors) {
  pass_ = batches_.linearize(values, gradient, with_errors);
  return pass_.any_incomplete;
}

void EdgeParts::for_each_of_batches(JacobianWorkspace& workspace,
                                    boxplus::detail::FunctionRef<void(Edge&, JacobianWorkspace&)> f,
                                    bool were_linearized) const {
  if (were_linearized) {
    for (Edge* edge : pass_.not_added) f(*edge, workspace);
  } else {
    batches_.for_each([&](Edge& edge) { f(edge, workspace); });
  }
}

void EdgeParts::for_each_by_parts(JacobianWorkspace& workspace,
                                  boxplus::detail::FunctionRef<void(Edge&, JacobianWorkspace&)> f) {
  if (left_.size() < others_.size()) {
    for_each_part(kParts, [&](int number) {
      const auto part = static_cast<size_t>(number);
      workspaces_[part] = workspace;
      with_unknown_kernels_[part].clear();
      LastType type;
      for_each_ahead(parts_[part], [&](Edge& edge) {
        const RobustKernel* kernel = edge.robustKernel();
        if (kernel == nullptr || type.allowed(typeid(*kernel))) {
          f(edge, workspaces_[part]);
        } else {
          with_unknown_kernels_[part].push_back(&edge);
        }
      });
    });
    for (const Edges& part : with_unknown_kernels_) {
      for (Edge* edge : part) f(*edge, workspace);
    }
  }
  for_each_ahead(left_, [&](Edge& edge) { f(edge, workspace); });
}

}  // namespace internal
}  // namespace g2o
