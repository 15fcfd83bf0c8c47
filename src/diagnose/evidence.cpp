// SPDX-License-Identifier: BSD-3-Clause
#include "diagnose/evidence.h"

#include <Eigen/Core>
#include <bit>
#include <cmath>
#include <type_traits>

#include "base/all_finite.h"
#include "base/paced_stop.h"
#include "base/symmetric_eigen.h"
#include "graph/weighted_rows.h"

namespace boxplus {
namespace {

/// Mixes a number into a hash (the finalizer of MurmurHash3).
std::uint64_t mixed(std::uint64_t hash, std::uint64_t number) {
  hash = (hash ^ number) * 0xFF51AFD7ED558CCDull;
  hash = (hash ^ (hash >> 33)) * 0xC4CEB9FE1A85EC53ull;
  return hash ^ (hash >> 33);
}

std::uint64_t signature_of(std::span<const std::uint32_t> vertices, const double* error, int rows) {
  std::uint64_t hash = vertices.size();
  for (const std::uint32_t slot : vertices) hash = mixed(hash, slot);
  for (int i = 0; i < rows; ++i) hash = mixed(hash, std::bit_cast<std::uint64_t>(error[i] + 0.0));
  return hash | 1;
}

bool all_zero(const double* values, std::size_t size) {
  for (std::size_t i = 0; i < size; ++i) {
    if (values[i] != 0) return false;
  }
  return true;
}

/// Calls f with the number of rows, as a type if it is a common one, so that loops over rows are unrolled.
template <class F>
void with_rows(int rows, F&& f) {
  switch (rows) {
    case 1:
      return f(std::integral_constant<int, 1>());
    case 2:
      return f(std::integral_constant<int, 2>());
    case 3:
      return f(std::integral_constant<int, 3>());
    case 6:
      return f(std::integral_constant<int, 6>());
    default:
      return f(rows);
  }
}

/// y = Ω x for `columns` columns.
void weigh(const detail::InformationView& omega, const double* x, int columns, double* y) {
  if (omega.kind != detail::InformationKind::kFull || omega.rows > 6) return omega.apply(x, columns, y);
  with_rows(omega.rows, [&](auto n) {
    double full[36];
    const double* value = omega.values;
    for (int i = 0; i < n; ++i) {
      for (int j = i; j < n; ++j) full[i * n + j] = full[j * n + i] = *value++;
    }
    for (int c = 0; c < columns; ++c, x += n, y += n) {
      for (int i = 0; i < n; ++i) y[i] = full[i] * x[0];
      for (int j = 1; j < n; ++j) {
        for (int i = 0; i < n; ++i) y[i] += full[j * n + i] * x[j];
      }
    }
  });
}

/// Adds JᵀΩJ to the lower triangle of a block of H, and weight · JᵀΩe to the gradient. J has `rows` rows and
/// `dim` columns.
void add_block(int rows, int dim, const double* J, const double* omega_J, const double* omega_e,
               double weight, double* block, double* gradient) {
  with_rows(rows, [&](auto n) {
    for (int a = 0; a < dim; ++a) {
      const double* left = J + a * n;
      double slope = 0;
      for (int r = 0; r < n; ++r) slope += left[r] * omega_e[r];
      gradient[a] += weight * slope;
      for (int b = 0; b <= a; ++b) {
        double sum = 0;
        for (int r = 0; r < n; ++r) sum += left[r] * omega_J[b * n + r];
        block[b * dim + a] += sum;
      }
    }
  });
}

PlanRequest request_of(const Options& options, const StopToken& stop) {
  PlanRequest request;
  request.level = options.level;
  request.vertices = options.vertices;
  request.edges = options.edges;
  request.stop = stop;
  return request;
}

/// The Cholesky factorization of D⁻½ A D⁻½ for a symmetric A with the diagonal D.
class ScaledCholesky {
 public:
  /// `fixed` directions count as determined. Returns false if a pivot is so small that a direction may be
  /// free.
  bool factorize(std::span<const double> block, int dim, std::span<const int> fixed) {
    constexpr double kSmallPivot = 1e-10;
    n_ = dim;
    scale_.resize(static_cast<std::size_t>(n_));
    factor_.assign(block.begin(), block.end());
    for (const int direction : fixed) clear(direction);
    for (int i = 0; i < n_; ++i) {
      if (!(at(i, i) > 0)) return false;
      scale_[i] = 1 / std::sqrt(at(i, i));
    }
    for (int j = 0; j < n_; ++j) {
      for (int i = j; i < n_; ++i) at(i, j) *= scale_[i] * scale_[j];
    }
    for (int j = 0; j < n_; ++j) {
      double pivot = at(j, j);
      for (int k = 0; k < j; ++k) pivot -= at(j, k) * at(j, k);
      if (!(pivot > kSmallPivot)) return false;
      at(j, j) = std::sqrt(pivot);
      for (int i = j + 1; i < n_; ++i) {
        double sum = at(i, j);
        for (int k = 0; k < j; ++k) sum -= at(i, k) * at(j, k);
        at(i, j) = sum / at(j, j);
      }
    }
    return true;
  }
  /// bᵀ A⁻¹ b. factorize() must have returned true.
  double squared_norm(std::span<const double> b, std::span<const int> fixed) {
    solution_.assign(b.begin(), b.end());
    for (const int direction : fixed) solution_[direction] = 0;
    double sum = 0;
    for (int i = 0; i < n_; ++i) {
      double& x = solution_[i];
      x *= scale_[i];
      for (int k = 0; k < i; ++k) x -= at(i, k) * solution_[k];
      x /= at(i, i);
      sum += x * x;
    }
    return sum;
  }

 private:
  double& at(int i, int j) { return factor_[j * n_ + i]; }
  void clear(int direction) {
    for (int k = 0; k < n_; ++k) at(k, direction) = at(direction, k) = k == direction ? 1 : 0;
  }

  int n_ = 0;
  std::vector<double> factor_, scale_, solution_;
};

/// The directions x with Ax = 0, apart from rounding errors.
std::vector<std::vector<double>> null_directions(std::span<const double> block, int dim,
                                                 std::span<const int> fixed) {
  constexpr double kZero = 1e-13;  // of the largest eigenvalue
  Eigen::MatrixXd A(dim, dim);
  for (int j = 0; j < dim; ++j) {
    for (int i = j; i < dim; ++i) A(i, j) = A(j, i) = block[j * dim + i];
  }
  for (const int direction : fixed) {
    A.row(direction).setZero();
    A.col(direction).setZero();
    A(direction, direction) = 1;
  }
  Eigen::VectorXd scale(dim);
  for (int i = 0; i < dim; ++i) scale[i] = A(i, i) > 0 ? 1 / std::sqrt(A(i, i)) : 1;
  const SymmetricEigen eigen = symmetric_eigen(scale.asDiagonal() * A * scale.asDiagonal());
  std::vector<std::vector<double>> result;
  for (int i = 0; i < dim; ++i) {
    if (eigen.values[i] > kZero) continue;
    const Eigen::VectorXd direction = scale.cwiseProduct(eigen.vectors.col(i)).normalized();
    result.emplace_back(direction.begin(), direction.end());
  }
  return result;
}

}  // namespace

Evidence::Evidence(const Graph& g, const Options& o, const StopToken& token)
    : graph(g), options(o), stop(token), active(find_active_set(g, request_of(o, token))) {
  list_vertices();
  for (std::uint32_t p = 0; p < active.edges.size(); ++p) {
    if (!active.edges[p].empty()) linearize_pool(p);
  }
  examine_vertices();
}

bool Evidence::at_minimum() const {
  // A minimum that was written with six digits stays below this bound.
  constexpr double kNoticeable = 1e-2;
  constexpr double kNothing = 1e-12;  // per row; chi2 may be zero but for rounding
  return non_finite_errors.empty() && non_finite_jacobians.empty() && !vertices.empty() &&
         single_decrease <= std::max(kNoticeable * chi2, kNothing * static_cast<double>(rows));
}

void Evidence::list_vertices() {
  for (const auto& pool : graph.vertex_pools()) index_of_.emplace_back(pool->slots(), kNone);
  std::size_t values = 0, scalars = 0;
  const auto add = [&](const VertexRef& vertex) {
    const int dim = graph.vertex_pools()[vertex.pool]->tangent_dim(vertex.slot);
    index_of_[vertex.pool][vertex.slot] = static_cast<std::uint32_t>(vertices.size());
    VertexEvidence& added = vertices.emplace_back();
    added.vertex = vertex;
    added.dim = dim;
    added.first_value = values;
    added.first_scalar = scalars;
    values += static_cast<std::size_t>(dim) * static_cast<std::size_t>(dim);
    scalars += static_cast<std::size_t>(dim);
  };
  vertices.reserve(active.block_vertex.size() + active.gauge.held.size());
  for (const VertexRef& vertex : active.block_vertex) add(vertex);
  for (const detail::GaugeVertex& held : active.gauge.held) add(held.vertex);
  hessian_.assign(values, 0.0);
  gradient_.assign(scalars, 0.0);
}

void Evidence::linearize_pool(std::uint32_t p) {
  const detail::EdgePool& pool = *graph.edge_pools()[p];
  PoolEvidence evidence;
  evidence.pool = p;
  for (const std::uint32_t slot : active.edges[p]) {
    if (pool.enabled(slot)) evidence.edges.push_back(slot);
  }
  if (evidence.edges.empty()) return;
  evidence.chi2.reserve(evidence.edges.size());
  evidence.signatures.reserve(evidence.edges.size());
  std::vector<double> error, jacobian;
  PacedStop pace(stop, 512);
  std::span<const std::uint32_t> rest = evidence.edges;
  while (!rest.empty()) {
    const detail::EdgeShape shape = pool.shape(rest[0]);
    const auto capacity = pool.uniform_shape() ? static_cast<std::size_t>(tile_capacity(shape)) : 1;
    const auto some = rest.first(std::min(capacity, rest.size()));
    const auto rows_per_edge = static_cast<std::size_t>(shape.rows);
    const std::size_t size = rows_per_edge * static_cast<std::size_t>(shape.cols);
    error.resize(std::max(error.size(), some.size() * rows_per_edge));
    jacobian.resize(std::max(jacobian.size(), some.size() * size));
    detail::EdgeTile tile;
    tile.error = error.data();
    tile.jacobian = jacobian.data();
    pool.linearize(some, tile, options.numeric_jacobians);
    for (std::size_t k = 0; k < some.size(); ++k)
      add_edge(evidence, some[k], error.data() + k * rows_per_edge, jacobian.data() + k * size, shape);
    pace.step(static_cast<std::int64_t>(some.size()));
    rest = rest.subspan(some.size());
  }
  pools.push_back(std::move(evidence));
}

void Evidence::add_edge(PoolEvidence& evidence, std::uint32_t slot, const double* error,
                        const double* jacobian, const detail::EdgeShape& shape) {
  const detail::EdgePool& pool = *graph.edge_pools()[evidence.pool];
  const auto n = static_cast<std::size_t>(shape.rows);
  const std::size_t size = n * static_cast<std::size_t>(shape.cols);
  const detail::InformationView omega = pool.information(slot, shape.rows);
  const double e2 = omega.squared_norm(error);
  double value = e2, weight = 1;
  if (const RobustKernel* kernel = pool.kernel(slot)) {
    const RobustKernel::Rho rho = (*kernel)(e2);
    value = rho.value;
    weight = std::max(0.0, rho.first);
    has_kernels = true;
  }
  rows += static_cast<std::uint64_t>(weighted_rows(omega));
  evidence.chi2.push_back(e2);
  evidence.signatures.push_back(
      all_zero(jacobian, size) ? 0 : signature_of(pool.vertex_slots(slot), error, shape.rows));
  if (!all_finite(error, n) || !std::isfinite(e2) || !std::isfinite(value)) {
    non_finite_errors.push_back(edge_ref(evidence.pool, slot));
  } else if (!all_finite(jacobian, size) || !std::isfinite(weight)) {
    non_finite_jacobians.push_back(edge_ref(evidence.pool, slot));
  } else {
    weighted_.resize(std::max(weighted_.size(), size + n));
    weigh(omega, jacobian, shape.cols, weighted_.data());
    weigh(omega, error, 1, weighted_.data() + size);
    chi2 += value;
    return add_to_vertices(evidence, slot, jacobian, shape, weight);
  }
  add_to_vertices(evidence, slot, nullptr, shape, 0);
}

/// Adds an edge to its vertices. `jacobian` is null if the edge is not finite.
void Evidence::add_to_vertices(const PoolEvidence& evidence, std::uint32_t slot, const double* jacobian,
                               const detail::EdgeShape& shape, double weight) {
  const detail::EdgePool& pool = *graph.edge_pools()[evidence.pool];
  const auto slots = pool.vertex_slots(slot);
  const double* weighted_error = jacobian != nullptr ? weighted_.data() + shape.rows * shape.cols : nullptr;
  std::ptrdiff_t column = 0;
  for (std::size_t i = 0; i < slots.size(); ++i) {
    const std::uint32_t p = pool.vertex_pool(slot, static_cast<int>(i));
    const std::uint32_t index = index_of_[p][slots[i]];
    if (index == kNone) {
      column += graph.vertex_pools()[p]->tangent_dim(slots[i]);
      continue;
    }
    VertexEvidence& vertex = vertices[index];
    ++vertex.edges;
    vertex.last = slot;
    vertex.last_pool = evidence.pool;
    vertex.is_finite = vertex.is_finite && jacobian != nullptr;
    if (jacobian != nullptr) {
      const std::ptrdiff_t first = column * shape.rows;
      add_block(shape.rows, vertex.dim, jacobian + first, weighted_.data() + first, weighted_error, weight,
                hessian_.data() + vertex.first_value, gradient_.data() + vertex.first_scalar);
    }
    column += vertex.dim;
  }
}

/// The directions of a vertex in which it cannot move to lower chi2: those that are fixed, and entries at
/// limits beyond which chi2 would fall (Graph::set_bounds()).
std::vector<int> Evidence::held_directions(VertexRef vertex, std::span<const double> gradient) const {
  detail::VertexPool& pool = *graph.vertex_pools()[vertex.pool];
  const auto fixed = pool.fixed_directions(vertex.slot);
  std::vector<int> held(fixed.begin(), fixed.end());
  if (!pool.has_bounds()) return held;
  for (const detail::Bound& bound : pool.bounds(vertex.slot)) {
    const double value = *pool.entry(vertex.slot, bound.entry), slope = gradient[bound.entry];
    if ((slope > 0 && value <= bound.lower) || (slope < 0 && value >= bound.upper))
      held.push_back(bound.entry);
  }
  return held;
}

void Evidence::examine_vertices() {
  ScaledCholesky cholesky;
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    const VertexEvidence& vertex = vertices[k];
    const auto fixed = graph.vertex_pools()[vertex.vertex.pool]->fixed_directions(vertex.vertex.slot);
    if (vertex.edges == 0 || !vertex.is_finite) continue;
    if (cholesky.factorize(block(vertex), vertex.dim, fixed)) {
      const std::span gradient(gradient_.data() + vertex.first_scalar, static_cast<std::size_t>(vertex.dim));
      const std::vector<int> held = held_directions(vertex.vertex, gradient);
      const bool is_held = held.size() > fixed.size();
      if (is_held && !cholesky.factorize(block(vertex), vertex.dim, held)) continue;
      single_decrease += cholesky.squared_norm(gradient, held);
      continue;
    }
    std::vector<std::vector<double>> directions = null_directions(block(vertex), vertex.dim, fixed);
    if (!directions.empty()) free_directions.push_back({k, std::move(directions)});
  }
}

}  // namespace boxplus
