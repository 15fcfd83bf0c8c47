// SPDX-License-Identifier: BSD-3-Clause
#include "engine/batch_division.h"

#include <algorithm>
#include <utility>

namespace g2o {
namespace internal {

/// Returns the batch of an edge, or none if edges like this are not taken.
std::optional<std::uint32_t> TakenEdges::batch_of(const OptimizableGraph::Edge& edge, const EdgeKind& kind) {
  const std::uint32_t mask = positions_in_hessian(edge);
  for (std::uint32_t k = 0; k < batches.size(); ++k) {
    const EdgeBatch& batch = batches[k];
    if (batch.kind == &kind && batch.mask == mask) return k;
  }
  std::optional<EdgeAdder> adder = EdgeAdder::find(kind, mask);
  if (!adder) return std::nullopt;
  EdgeBatch batch;
  batch.kind = &kind;
  batch.mask = mask;
  batch.adder = std::move(*adder);
  for (const int n : batch.adder.positions) batch.columns += kind.dims[n];
  batches.push_back(std::move(batch));
  return static_cast<std::uint32_t>(batches.size() - 1);
}

bool TakenEdges::take(OptimizableGraph::Edge& edge, const EdgeKind& kind) {
  if (edge.vertices().size() != kind.dims.size()) return false;
  for (const HyperGraph::Vertex* v : edge.vertices()) {
    if (hessian_index(v) >= static_cast<int>(is_marginalized.size())) return false;  // the client changed it
  }
  const std::optional<std::uint32_t> batch = batch_of(edge, kind);
  if (!batch) return false;
  items.push_back({&edge, *batch, static_cast<std::uint32_t>(indices.size())});
  for (const int n : batches[*batch].adder.positions) {
    const auto* v = static_cast<const OptimizableGraph::Vertex*>(edge.vertex(static_cast<std::size_t>(n)));
    is_marginalized[v->hessianIndex()] = v->marginalized() ? 1 : 0;
    indices.push_back(v->hessianIndex());
  }
  return true;
}

BatchDivision::BatchDivision(const TakenEdges& taken)
    : taken_(taken), number_(taken.is_marginalized.size(), -1) {
  int seen = 0;
  for (const int h : taken.indices) {
    if (number(h) < 0) number_[h] = seen++;
  }
  std::vector<std::int64_t> owned(static_cast<std::size_t>(seen));
  for (const TakenEdges::Item& item : taken.items) ++owned[number(owner(item))];
  const auto count = static_cast<std::int64_t>(taken.items.size());
  std::int64_t before = 0;
  for (const std::int64_t here : owned) {
    part_.push_back(static_cast<int>(std::min<std::int64_t>(kParts - 1, before * kParts / count)));
    before += here;
  }
}

/// The vertex whose part has the edge: its marginalized vertex, or its vertex with the largest number.
int BatchDivision::owner(const TakenEdges::Item& item) const {
  const auto is_before = [&](int a, int b) {
    const char marginalized_a = taken_.is_marginalized[a];
    const char marginalized_b = taken_.is_marginalized[b];
    return marginalized_a != marginalized_b ? marginalized_a < marginalized_b : number(a) < number(b);
  };
  return *std::max_element(taken_.begin(item), taken_.end(item), is_before);
}

}  // namespace internal
}  // namespace g2o
