// SPDX-License-Identifier: BSD-3-Clause
#include "incremental/dense_marginal.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "base/symmetric_eigen.h"
#include "incremental/marginal_pool.h"

namespace boxplus {

void DenseModel::set_vertices(const Graph& graph, std::span<const VertexRef> first,
                              std::vector<VertexRef> others) {
  std::sort(others.begin(), others.end());
  others.erase(std::unique(others.begin(), others.end()), others.end());
  vertices.assign(first.begin(), first.end());
  vertices.insert(vertices.end(), others.begin(), others.end());
  offset.assign(1, 0);
  for (const VertexRef& vertex : vertices) offset.push_back(offset.back() + graph.tangent_dim(vertex));
  H = Eigen::MatrixXd::Zero(offset.back(), offset.back());
  b = Eigen::VectorXd::Zero(offset.back());
}

Eigen::Index DenseModel::find(VertexRef vertex) const {
  const auto at = std::find(vertices.begin(), vertices.end(), vertex);
  return at == vertices.end() ? -1 : at - vertices.begin();
}

Eigen::VectorXd unit_scale(const Eigen::VectorXd& diagonal) {
  return diagonal.unaryExpr([](double value) { return value > 0 ? 1 / std::sqrt(value) : 0.0; });
}

DenseModel eliminated(const DenseModel& model, std::size_t count) {
  const Eigen::Index gone = model.offset[count], size = model.offset.back(), rest = size - gone;
  const auto own = model.H.topLeftCorner(gone, gone);
  if (rest == 0) return {};
  if (gone == 0) {
    DenseModel same = model;
    same.scale = model.H.diagonal();
    return same;
  }
  Eigen::MatrixXd gain;  // H_ro H_oo⁻¹
  const Eigen::LLT<Eigen::MatrixXd> llt(own);
  constexpr double kRounding = 1e-13;
  const auto well_determined = [&] {
    return llt.info() == Eigen::Success &&
           (llt.matrixLLT().diagonal().array().square() > kRounding * own.diagonal().array()).all();
  };
  if (well_determined()) {
    gain = llt.solve(model.H.topRightCorner(gone, rest)).transpose();
  } else {
    const Eigen::VectorXd unit = unit_scale(own.diagonal());
    const SymmetricEigen eigen = symmetric_eigen(unit.asDiagonal() * own * unit.asDiagonal());
    const double floor = kRounding * static_cast<double>(gone);
    const Eigen::VectorXd inverse =
        eigen.values.unaryExpr([floor](double value) { return value > floor ? 1 / value : 0.0; });
    gain = model.H.bottomLeftCorner(rest, gone) * unit.asDiagonal() * eigen.vectors * inverse.asDiagonal() *
           eigen.vectors.transpose() * unit.asDiagonal();
  }
  DenseModel result;
  result.vertices.assign(model.vertices.begin() + static_cast<std::ptrdiff_t>(count), model.vertices.end());
  for (std::size_t k = count + 1; k < model.offset.size(); ++k)
    result.offset.push_back(model.offset[k] - gone);
  result.H = model.H.bottomRightCorner(rest, rest) - gain * model.H.topRightCorner(gone, rest);
  result.scale = model.H.diagonal().tail(rest);
  result.H = (result.H + result.H.transpose().eval()) / 2;
  result.b = model.b.tail(rest) - gain * model.b.head(gone);
  return result;
}

EdgeRef add_marginal_prior(Graph& graph, const DenseModel& model,
                           std::span<const std::unique_ptr<detail::VertexPool>> means) {
  std::uint32_t index = 0;
  MarginalPool* pool = nullptr;
  for (; index < graph.edge_pools().size() && pool == nullptr; ++index) {
    pool = dynamic_cast<MarginalPool*>(graph.edge_pools()[index].get());
    if (pool != nullptr && !pool->suits(graph)) pool = nullptr;
  }
  if (pool == nullptr) {
    auto fresh = std::make_unique<MarginalPool>(graph);
    pool = fresh.get();
    index = graph.add_edge_pool(std::move(fresh)) + 1;
  }
  return graph.add_edge(index - 1, model.vertices, [&](std::span<const std::uint32_t>) {
    return pool->add(model.vertices, model.H, model.b, unit_scale(model.scale), means);
  });
}

}  // namespace boxplus
