// SPDX-License-Identifier: BSD-3-Clause
#include "incremental/marginal_pool.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "boxplus/autodiff/numeric.h"

namespace boxplus {
namespace {

std::vector<std::uint32_t> all_pools(const Graph& graph) {
  std::vector<std::uint32_t> pools(graph.vertex_pools().size());
  std::iota(pools.begin(), pools.end(), 0u);
  return pools;
}

/// R and r with RᵀR = H and Rᵀr = b, from S H S = Pᵀ L D Lᵀ P, where `unit` is the diagonal of S. Directions
/// in which H is zero to within rounding errors of 1/S² get no row.
dense_prior::Rows square_root(const Eigen::MatrixXd& H, const Eigen::VectorXd& b,
                              const Eigen::VectorXd& unit) {
  const Eigen::MatrixXd scaled = unit.asDiagonal() * H * unit.asDiagonal();
  const Eigen::LDLT<Eigen::MatrixXd> ldlt(scaled);
  const Eigen::VectorXd d = ldlt.vectorD();
  const double floor = 1e-13 * static_cast<double>(H.rows());
  const Eigen::MatrixXd L = ldlt.matrixL();
  const Eigen::VectorXd back = unit.unaryExpr([](double s) { return s > 0 ? 1 / s : 0.0; });
  const Eigen::MatrixXd root = (ldlt.transpositionsP().transpose() * L).transpose() * back.asDiagonal();
  Eigen::VectorXd offset = ldlt.transpositionsP() * (unit.asDiagonal() * b);
  ldlt.matrixL().solveInPlace(offset);
  std::vector<Eigen::Index> kept;
  for (Eigen::Index i = 0; i < d.size(); ++i) {
    if (d[i] > floor) kept.push_back(i);
  }
  Eigen::MatrixXd R(static_cast<Eigen::Index>(kept.size()), H.cols());
  Eigen::VectorXd r(R.rows());
  for (Eigen::Index i = 0; i < R.rows(); ++i) {
    const Eigen::Index row = kept[i];
    const double scale = std::sqrt(d[row]);
    R.row(i) = scale * root.row(row);
    r[i] = offset[row] / scale;
  }
  return dense_prior::from_root(R, r, static_cast<int>(H.cols()));
}

}  // namespace

MarginalPool::MarginalPool(const Graph& graph)
    : EdgePool(all_pools(graph), static_cast<int>(graph.vertex_pools().size())) {
  for (const auto& pool : graph.vertex_pools()) pools_.push_back(pool.get());
}

MarginalPool::MarginalPool(const MarginalPool& other,
                           std::span<const std::unique_ptr<detail::VertexPool>> pools)
    : EdgePool(other) {
  for (std::size_t p = 0; p < other.pools_.size(); ++p) pools_.push_back(pools[p].get());
  for (const Prior& prior : other.priors_) {
    Prior& copy = priors_.emplace_back();
    copy.rows = prior.rows;
    for (const auto& means : prior.means) copy.means.push_back(means ? means->clone() : nullptr);
  }
}

std::unique_ptr<detail::EdgePool> MarginalPool::clone(
    std::span<const std::unique_ptr<detail::VertexPool>> pools) const {
  return std::unique_ptr<EdgePool>(new MarginalPool(*this, pools));
}

std::uint32_t MarginalPool::add(std::span<const VertexRef> vertices, const Eigen::MatrixXd& H,
                                const Eigen::VectorXd& b, const Eigen::VectorXd& unit,
                                std::span<const std::unique_ptr<detail::VertexPool>> means) {
  Prior prior;
  prior.rows = square_root(H, b, unit);
  std::vector<std::uint32_t> slots, sizes(pools_.size(), 0);
  for (const VertexRef& vertex : vertices) {
    slots.push_back(vertex.slot);
    ++sizes[vertex.pool];
  }
  std::size_t first = 0;
  prior.means.resize(pools_.size());
  for (std::size_t p = 0; p < pools_.size(); ++p) {
    if (sizes[p] == 0) continue;
    means[p]->save(std::span(slots).subspan(first, sizes[p]), prior.means[p]);
    first += sizes[p];
  }
  for (std::uint32_t edge = 0; edge < this->slots(); ++edge) {
    if (!alive(edge)) priors_[edge] = {};  // its memory is no longer needed
  }
  const std::uint32_t slot = next_slot(slots.size());
  if (slot >= priors_.size()) priors_.resize(slot + std::size_t{1});
  priors_[slot] = std::move(prior);
  return acquire_slot(slots, sizes, Information(1.0), priors_[slot].rows.rows);
}

detail::EdgeShape MarginalPool::shape(std::uint32_t edge) const {
  return {arity(edge), priors_[edge].rows.rows, priors_[edge].rows.cols};
}

template <class F>
void MarginalPool::for_each_vertex(std::uint32_t edge, F&& f) const {
  const auto slots = vertex_slots(edge);
  const Prior& prior = priors_[edge];
  std::size_t in_pool = 0;
  int first = 0;
  for (std::size_t i = 0; i < slots.size(); ++i) {
    const std::uint32_t p = vertex_pool(edge, static_cast<int>(i));
    in_pool = i > 0 && vertex_pool(edge, static_cast<int>(i) - 1) == p ? in_pool + 1 : 0;
    f(*pools_[p], slots[i], *prior.means[p], in_pool, first);
    first += pools_[p]->tangent_dim(slots[i]);
  }
}

void MarginalPool::errors(std::span<const std::uint32_t> edges, double* out) const {
  std::vector<double> delta;
  for (const std::uint32_t edge : edges) {
    const dense_prior::Rows& rows = priors_[edge].rows;
    delta.resize(static_cast<std::size_t>(rows.cols));
    for_each_vertex(edge, [&](const detail::VertexPool& pool, std::uint32_t slot,
                              const detail::SavedEstimates& means, std::size_t k,
                              int first) { pool.difference(slot, nullptr, means, k, delta.data() + first); });
    dense_prior::evaluate(rows, delta.data(), out);
    out += rows.rows;
  }
}

/// The Jacobian is R D, where D is the derivative of x ⊟ mean. D is the identity if x is the mean.
void MarginalPool::linearize(std::span<const std::uint32_t> edges, detail::EdgeTile& tile, bool) const {
  const std::uint32_t edge = edges[0];
  const dense_prior::Rows& rows = priors_[edge].rows;
  tile.count = 1;
  tile.rows = rows.rows;
  tile.cols = rows.cols;
  tile.in_lanes = false;
  errors(edges, tile.error);
  double* out = tile.jacobian;
  detail::NumericDerivative differentiate;
  for_each_vertex(edge, [&](const detail::VertexPool& pool, std::uint32_t slot,
                            const detail::SavedEstimates& means, std::size_t k, int first) {
    const int dim = pool.tangent_dim(slot);
    const auto size = static_cast<std::size_t>(dim);
    std::vector<double> delta(size), D(size * size, 0.0);
    pool.difference(slot, nullptr, means, k, delta.data());
    const bool is_at_mean = std::all_of(delta.begin(), delta.end(), [](double d) { return d == 0; });
    for (std::size_t i = 0; i < size; ++i) {
      if (is_at_mean) {
        D[i * size + i] = 1;
        continue;
      }
      std::fill(delta.begin(), delta.end(), 0.0);
      differentiate(
          [&](double h, double* values) {
            delta[i] = h;
            pool.difference(slot, delta.data(), means, k, values);
          },
          dim, D.data() + i * size);
    }
    dense_prior::multiply(rows, first, dim, D.data(), out);
    out += static_cast<std::ptrdiff_t>(rows.rows) * dim;
  });
}

void MarginalPool::reserve(std::size_t edges) {
  reserve_slots(edges);
  priors_.reserve(edges);
}

}  // namespace boxplus
