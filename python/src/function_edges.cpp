// SPDX-License-Identifier: BSD-3-Clause
#include "function_edges.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "batched_pool.h"
#include "edge_kinds.h"

namespace boxplus::python {
namespace {

/// A pool of the function for vertices of these pools and measurements of this width, if the graph has one.
std::optional<std::uint32_t> find_pool(const Graph& graph, py::handle edge,
                                       std::span<const VertexRef> vertices, int width, bool is_constraint) {
  const auto pools = graph.edge_pools();
  for (std::uint32_t index = 0; index < pools.size(); ++index) {
    const auto* pool = dynamic_cast<const BatchedPool*>(pools[index].get());
    if (pool == nullptr || !pool->edge().is(edge) || pool->width() != width) continue;
    if (pool->is_constraint() != is_constraint) continue;
    if (pool->function().kinds().size() != vertices.size()) continue;
    bool is_same = true;
    for (std::size_t i = 0; i < vertices.size(); ++i)
      is_same = is_same && pool->pool_of_argument(static_cast<int>(i)) == vertices[i].pool;
    if (is_same) return index;
  }
  return std::nullopt;
}

/// The number of rows of the error of the first edge.
int count_rows(EdgeFunction& function, py::handle edge, const Graph& graph,
               std::span<const VertexRef> vertices, const Numbers& measurements, int width) {
  Batch batch;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const VertexKind& kind = *function.kinds()[i];
    Numbers& row = batch.estimates.emplace_back(std::vector<py::ssize_t>{1, kind.size});
    kind.read(*graph.vertex_pools()[vertices[i].pool], vertices[i].slot, row.mutable_data());
  }
  if (width > 0) {
    batch.has_measurements = true;
    batch.measurements = Numbers(std::vector<py::ssize_t>{1, width});
    std::copy_n(measurements.data(), width, batch.measurements.mutable_data());
  }
  return function(edge, batch, 0, EdgeFunction::Want::kErrors).rows;
}

}  // namespace

bool is_function(py::handle edge) {
  return PyCallable_Check(edge.ptr()) != 0 && !py::isinstance<py::type>(edge) &&
         !py::isinstance<EdgeValue>(edge);
}

bool is_batched_function(py::handle edge) {
  if (py::isinstance<py::type>(edge)) return false;
  return is_function(edge) || (py::hasattr(edge, "error") && !py::isinstance<EdgeValue>(edge));
}

FunctionEdges::FunctionEdges(Graph& graph, const py::object& edge, std::span<const VertexRef> first,
                             const py::object& measurements, bool is_constraint)
    : graph_(&graph) {
  if (first.empty())
    throw py::type_error("vertices: expected at least one vertex of an error function, got none");
  if (!measurements.is_none()) {
    measurements_ = read_numbers(measurements, "measurements");
    if (measurements_.ndim() < 1 || measurements_.ndim() > 2)
      throw_value_error("measurements", "an array with a row per edge", measurements);
    width_ = measurements_.ndim() == 1 ? 1 : static_cast<int>(measurements_.shape(1));
    if (width_ == 0) throw_value_error("measurements", "at least one number per edge", measurements);
  }
  std::vector<const VertexKind*> kinds;
  std::vector<std::uint32_t> indices;
  std::vector<const detail::VertexPool*> pools;
  for (const VertexRef& vertex : first) {
    kinds.push_back(&kind_of_vertex(graph, vertex));
    indices.push_back(vertex.pool);
    pools.push_back(graph.vertex_pools()[vertex.pool].get());
  }
  if (const auto found = find_pool(graph, edge, first, width_, is_constraint)) {
    pool_ = *found;
    rows_ = graph.edge_pools()[pool_]->shape(0).rows;
    return;
  }
  auto function = std::make_shared<EdgeFunction>(edge, std::move(kinds));
  rows_ = count_rows(*function, edge, graph, first, measurements_, width_);
  pool_ = graph.add_edge_pool(std::make_unique<BatchedPool>(edge, std::move(function), std::move(indices),
                                                            std::move(pools), rows_, width_, is_constraint));
}

EdgeRef FunctionEdges::add(std::size_t edge, const Information& information,
                           std::span<const VertexRef> vertices) {
  return graph_->add_edge(pool_, vertices, [&](std::span<const std::uint32_t> slots) {
    auto& pool = const_cast<BatchedPool&>(  // the graph is not const
        dynamic_cast<const BatchedPool&>(*graph_->edge_pools()[pool_]));
    return pool.add(width_ > 0 ? measurements_.data() + edge * static_cast<std::size_t>(width_) : nullptr,
                    information, slots);
  });
}

FreshEdge::FreshEdge(const Graph& graph, EdgeRef edge) {
  if (graph.contains(edge)) pool_ = dynamic_cast<const BatchedPool*>(graph.edge_pools()[edge.pool].get());
  if (pool_ != nullptr) pool_->begin_fresh();
}

FreshEdge::~FreshEdge() {
  if (pool_ != nullptr) pool_->end_fresh();
}

FreshEdges::FreshEdges(const Graph& graph) {
  for (const auto& pool : graph.edge_pools()) {
    if (const auto* batched = dynamic_cast<const BatchedPool*>(pool.get())) pools_.push_back(batched);
  }
  for (const BatchedPool* pool : pools_) pool->begin_fresh();
}

FreshEdges::~FreshEdges() {
  for (const BatchedPool* pool : pools_) pool->end_fresh();
}

void forget_results(const Graph& graph) {
  for (const auto& pool : graph.edge_pools()) {
    if (const auto* batched = dynamic_cast<const BatchedPool*>(pool.get())) batched->forget();
  }
}

void for_each_error_function(const Graph& graph, detail::FunctionRef<void(py::object&)> f) {
  for (const auto& pool : graph.edge_pools()) {
    if (auto* batched = dynamic_cast<BatchedPool*>(pool.get())) f(batched->edge());
  }
}

py::list costs_of_functions(const Graph& graph) {
  py::list costs;
  for (const auto& pool : graph.edge_pools()) {
    const auto* batched = dynamic_cast<const BatchedPool*>(pool.get());
    if (batched == nullptr) continue;
    const EdgeFunction::Cost cost = batched->function().cost();
    costs.append(py::make_tuple(batched->function().name(),
                                std::string(to_string(batched->jacobian_source())), cost.calls, cost.edges,
                                cost.seconds));
  }
  return costs;
}

}  // namespace boxplus::python
