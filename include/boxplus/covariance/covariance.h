// SPDX-License-Identifier: BSD-3-Clause
// Marginal covariances of vertices: how certain the estimates are.
#pragma once

#include <concepts>
#include <cstdint>
#include <initializer_list>
#include <map>
#include <optional>
#include <ranges>
#include <span>
#include <string>
#include <vector>

#include "boxplus/graph/graph.h"
#include "boxplus/options/options.h"

namespace boxplus {

/// Blocks of H⁻¹. H = Σ ρ′JᵀΩJ is evaluated at the estimates that the graph has when the covariance is
/// computed.
///
/// The covariance of a vertex x is the covariance of δ in x ⊞ δ. It has the order, units and frame of the
/// tangent: for SE2 (Δx, Δy, Δθ) in the body frame, for SE3 (Δt, Δq) in the body frame. Δq is the vector part
/// of a quaternion, which is half of an angle. (SE3RotationVector has whole angles.)
class [[nodiscard]] Covariance {
 public:
  enum class Status : std::uint8_t {
    kOk,
    kSingular,   ///< the edges do not determine a vertex; failed_vertex() names it
    kNotFinite,  ///< an error, a Jacobian or a weight is NaN or infinite
    kStopped     ///< Options::stop was raised
  };

  Status status() const { return status_; }
  bool ok() const { return status_ == Status::kOk; }
  /// One sentence that says why there is no covariance; empty if the computation succeeded.
  const std::string& message() const { return message_; }
  std::optional<VertexRef> failed_vertex() const { return failed_vertex_; }
  /// The vertices that were held, that is, fixed for this computation only, because nothing else determines
  /// where their component of the graph is (GaugePolicy). Their covariance is zero, and the covariances of
  /// all other vertices are relative to them. (If the scale of the component is free, too, one direction of
  /// another vertex is also held, and the variance in this direction is zero.)
  const std::vector<VertexRef>& held() const { return held_; }

  /// The covariance of one of the requested vertices; symmetric. Throws InvalidArgument if the vertex was not
  /// requested, and Error with message() if there is no covariance. Takes a search for the vertex, and a copy
  /// of the block.
  Eigen::MatrixXd of(VertexRef vertex) const;
  /// The cross-covariance E[δ_a δ_bᵀ], of tangent_dim(a) × tangent_dim(b) entries. Throws the same exceptions
  /// as of(vertex), and InvalidArgument if a and b differ and only marginal covariances were requested.
  Eigen::MatrixXd of(VertexRef a, VertexRef b) const;
  /// The joint covariance of all requested vertices, in their order. Throws the same exceptions as of(a, b).
  Eigen::MatrixXd joint() const;

 private:
  friend class CovarianceMaker;
  struct Place {
    std::size_t index;
    int dim;
  };
  const Place& place(VertexRef vertex) const;
  std::size_t block_index(std::size_t i, std::size_t j) const;

  Status status_ = Status::kOk;
  std::string message_;
  std::optional<VertexRef> failed_vertex_;
  std::vector<VertexRef> held_, vertices_;
  std::map<VertexRef, Place> places_;
  bool is_joint_ = false;
  /// One column-major block per vertex or, if is_joint_ is true, per pair (i, j) with j ≤ i, in the order
  /// (0,0) (1,0) (1,1) … A block of zeros is stored as an empty vector.
  std::vector<std::vector<double>> blocks_;
};

/// The covariances of `vertices` at the current estimates, with all cross-covariances. H is not damped, and
/// no estimate changes.
///
/// Fixed vertices, fixed directions (Graph::fix_directions()), fixed parameters and vertices outside of
/// Options::vertices have zero covariance. Vertices that are held to fix the gauge (Covariance::held()) have
/// zero covariance, too, and the covariances of all other vertices are relative to the held vertices. To
/// choose the reference yourself, fix a vertex or add a prior. Whether a vertex is eliminated does not affect
/// its covariance. An edge with a robust kernel has the weight ρ′ at the current estimates. The options
/// `level`, `vertices`, `edges`, `gauge`, `threads`, `numeric_jacobians`, `triggs_correction` and `stop` mean
/// the same as for optimize(); all other options are ignored.
///
/// If H is singular or not finite, status() says so, and failed_vertex() names a vertex (not necessarily a
/// requested one): fix it, or leave it out (Options::vertices). Throws InvalidArgument for stale handles.
///
/// The function linearizes once, and analyzes and factorizes H once by a block Cholesky in double. Then it
/// substitutes forward along the paths from `vertices` to the root of the elimination tree. If it is cheaper,
/// it instead computes those entries of H⁻¹ that are in the nonzero pattern of the factor; this takes about
/// as long as three factorizations, and the memory of a second factor. For several queries about the same
/// graph, Optimizer::covariance() is faster, because it keeps the plan and the factor.
Covariance covariance(const Graph& graph, std::span<const VertexRef> vertices, const Options& options = {});
Covariance covariance(const Graph& graph, std::initializer_list<VertexRef> vertices,
                      const Options& options = {});

/// Like covariance(), but computes only the covariance of each vertex with itself. This is cheap enough for
/// all vertices of a large graph.
Covariance marginal_covariances(const Graph& graph, std::span<const VertexRef> vertices,
                                const Options& options = {});

namespace detail {
/// A range of handles of one type, such as a std::vector<VertexHandle<SE2>>.
template <class R>
concept VertexHandles =
    std::ranges::input_range<R> && std::derived_from<std::ranges::range_value_t<R>, VertexRef> &&
    !std::same_as<std::ranges::range_value_t<R>, VertexRef>;
}  // namespace detail

template <detail::VertexHandles R>
Covariance covariance(const Graph& graph, const R& vertices, const Options& options = {}) {
  return covariance(graph, std::vector<VertexRef>(vertices.begin(), vertices.end()), options);
}
template <detail::VertexHandles R>
Covariance marginal_covariances(const Graph& graph, const R& vertices, const Options& options = {}) {
  return marginal_covariances(graph, std::vector<VertexRef>(vertices.begin(), vertices.end()), options);
}

// These functions are inline because Eigen's allocator depends on compiler flags: the client's own code must
// allocate the matrices that the client frees.

inline Eigen::MatrixXd Covariance::of(VertexRef vertex) const {
  return of(vertex, vertex);
}

inline Eigen::MatrixXd Covariance::of(VertexRef a, VertexRef b) const {
  const Place &row = place(a), &column = place(b);
  if (row.index < column.index) return of(b, a).transpose();
  if (row.index != column.index && !is_joint_)
    throw InvalidArgument(
        "Covariance: expected one vertex, got two: cross-covariances come from covariance()");
  const std::vector<double>& values = blocks_[block_index(row.index, column.index)];
  if (values.empty()) return Eigen::MatrixXd::Zero(row.dim, column.dim);
  return Eigen::Map<const Eigen::MatrixXd>(values.data(), row.dim, column.dim);
}

inline Eigen::MatrixXd Covariance::joint() const {
  Eigen::Index size = 0;
  for (const VertexRef& vertex : vertices_) size += place(vertex).dim;
  Eigen::MatrixXd result(size, size);
  Eigen::Index row = 0;
  for (const VertexRef& a : vertices_) {
    Eigen::Index column = 0;
    for (const VertexRef& b : vertices_) {
      const Eigen::MatrixXd block = of(a, b);
      result.block(row, column, block.rows(), block.cols()) = block;
      column += block.cols();
    }
    row += place(a).dim;
  }
  return result;
}

}  // namespace boxplus
