// SPDX-License-Identifier: BSD-3-Clause
// Evaluates ready-made edges in runs of one type, without virtual calls. For edges of all other types, the
// optimizer calls the virtual functions of each edge.
#pragma once

#include <cstddef>
#include <new>
#include <typeinfo>
#include <utility>
#include <vector>

#include "core/prefetch.h"
#include "g2o/core/base_edge.h"
#include "g2o/core/thread_safe.h"

namespace g2o {
namespace internal {

enum class EdgeState : unsigned char {
  kGood,
  kIncomplete,  ///< a vertex is missing; the other results are undefined
  kAsymmetric   ///< Ω is not symmetric, so there is no triangle of it
};

/// Consecutive edges of one kind, and memory for their results, edge after edge.
struct EdgeRun {
  OptimizableGraph::Edge* const* edges;
  int count;
  int ahead;  ///< the number of edges that follow after the run, and may be prefetched
  EdgeState* state;
  double* chi2;  ///< eᵀΩe
  /// The Jacobian of vertex n of edge k starts at jacobian[n] + k · stride[n].
  double* const* jacobian;
  const int* stride;
  double *error, *omega;  ///< e, and the upper triangle of Ω by rows
};

/// The functions for edges of one type.
struct EdgeKind {
  int rows;
  std::vector<int> dims;  ///< the dimensions of the vertices
  /// Calls computeError() and computes chi2.
  void (*compute_errors)(const EdgeRun& run);
  /// Computes everything. Calls computeError() only if `with_errors` is true.
  void (*linearize)(const EdgeRun& run, bool with_errors);
};

/// Declares the kind of the edges whose type is exactly `type`, or withdraws the declaration.
G2O_CORE_API void declare_edge_kind(const std::type_info& type, const EdgeKind& kind, bool declared);
/// Returns nullptr if no kind is declared.
const EdgeKind* edge_kind(const std::type_info& type);

/// The kind of the edge type E, which must be thread-safe.
template <class E, class Positions = std::make_index_sequence<E::_nr_of_vertices>>
struct EdgeKindOf;
template <class E, std::size_t... N>
struct EdgeKindOf<E, std::index_sequence<N...>> {
  static constexpr int kRows = E::Dimension, kTriangle = kRows * (kRows + 1) / 2;
  template <std::size_t M>
  using VertexType = typename E::template VertexXnType<static_cast<int>(M)>;

  static EdgeKind make() { return {kRows, {VertexType<N>::Dimension...}, compute_errors, linearize}; }

 private:
  static E* next(const EdgeRun& run, int k) {
    const int known = run.count + run.ahead;
    if (k + kEdgesAhead < known) prefetch(run.edges[k + kEdgesAhead], sizeof(E));
    if (k + kVerticesAhead < known) {
      const OptimizableGraph::Edge& later = *run.edges[k + kVerticesAhead];
      prefetch(later.robustKernel(), 1);
      (prefetch(later.vertices()[N], sizeof(VertexType<N>)), ...);
    }
    E* edge = static_cast<E*>(run.edges[k]);
    const bool complete = ((edge->vertices()[N] != nullptr) && ...);
    run.state[k] = complete ? EdgeState::kGood : EdgeState::kIncomplete;
    return complete ? edge : nullptr;
  }

  [[gnu::flatten]] static void compute_errors(const EdgeRun& run) {
    for (int k = 0; k < run.count; ++k) {
      E* edge = next(run, k);
      if (edge == nullptr) continue;
      edge->E::computeError();
      run.chi2[k] = edge->E::chi2();
    }
  }

  [[gnu::flatten]] static void linearize(const EdgeRun& run, bool with_errors) {
    for (int k = 0; k < run.count; ++k) {
      E* edge = next(run, k);
      if (edge == nullptr) continue;
      if (with_errors) edge->E::computeError();
      run.chi2[k] = edge->E::chi2();
      (map_jacobian<N>(*edge, run.jacobian[N] + k * run.stride[N]), ...);
      edge->E::linearizeOplus();
      for (int r = 0; r < kRows; ++r) run.error[k * kRows + r] = edge->error()[r];
      if (!upperTriangle<kRows>(edge->information(), run.omega + k * kTriangle))
        run.state[k] = EdgeState::kAsymmetric;
    }
  }

  template <std::size_t M>
  static void map_jacobian(E& edge, double* to) {
    auto& J = edge.template jacobianOplusXn<static_cast<int>(M)>();
    using Map = std::remove_reference_t<decltype(J)>;
    new (&J) Map(to);
  }
};

/// While an object of this class exists, edges of exactly the type E are thread-safe and evaluated in runs.
template <class E>
class EvaluatedInRuns {
  // Edges of different parts must not have two vertices in common (EdgeBatches).
  static_assert(E::_nr_of_vertices <= 2);

 public:
  EvaluatedInRuns() { declare_edge_kind(typeid(E), kind_, true); }
  ~EvaluatedInRuns() { declare_edge_kind(typeid(E), kind_, false); }
  EvaluatedInRuns(const EvaluatedInRuns&) = delete;
  EvaluatedInRuns& operator=(const EvaluatedInRuns&) = delete;

 private:
  EdgeKind kind_ = EdgeKindOf<E>::make();
  ThreadSafe<E> thread_safe_;
};

}  // namespace internal
}  // namespace g2o
