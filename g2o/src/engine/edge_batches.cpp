// SPDX-License-Identifier: BSD-3-Clause
#include "engine/edge_batches.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <typeinfo>
#include <utility>

#include "core/prefetch.h"
#include "engine/batch_division.h"
#include "engine/batch_part.h"
#include "engine/batch_targets.h"
#include "engine/part_threads.h"

namespace g2o {
namespace internal {
namespace {

void set_to_zero(double* values, std::size_t count, int slices) {
  const std::size_t size = count / static_cast<std::size_t>(slices) + 1;
  for_each_part(slices, [&](int slice) {
    const std::size_t begin = std::min(count, static_cast<std::size_t>(slice) * size);
    std::fill(values + begin, values + std::min(count, begin + size), 0.0);
  });
}

}  // namespace

EdgeBatches::EdgeBatches() = default;
EdgeBatches::~EdgeBatches() = default;

void EdgeBatches::take(const Edges& edges, int vertices, Edges& others) {
  stamp_ = 0;
  extra_values_ = extra_scalars_ = 0;
  parts_.clear();
  TakenEdges taken(vertices);
  const std::type_info* type = nullptr;
  const EdgeKind* kind = nullptr;
  for_each_ahead(edges, [&](Edge& edge) {
    if (&typeid(edge) != type) {
      type = &typeid(edge);
      kind = edge_kind(*type);
    }
    if (kind == nullptr || !taken.take(edge, *kind)) others.push_back(&edge);
  });
  if (taken.items.empty()) return;
  std::optional<BatchDivision> division;
  if (taken.items.size() >= kFewestEdgesForThreads) division.emplace(taken);
  for (int p = 0; p < (division ? BatchDivision::kParts : 1); ++p) {
    if (static_cast<std::size_t>(p) == tiles_.size()) tiles_.push_back(std::make_unique<EdgeTile>());
    parts_.push_back(std::make_unique<BatchPart>(*tiles_[p]));
    parts_.back()->batches = taken.batches;
  }
  for (const TakenEdges::Item& item : taken.items) {
    BatchPart& part = *parts_[division ? static_cast<std::size_t>(division->part_of(item)) : 0];
    EdgeBatch& batch = part.batches[item.batch];
    batch.edges.push_back(item.edge);
    batch.vertices.insert(batch.vertices.end(), taken.begin(item), taken.end(item));
  }
  for (const std::unique_ptr<BatchPart>& part : parts_) part->make_room();
  if (division) make_sums(*division, vertices);
}

/// Gives each part a sum for each vertex of its edges that belongs to another part.
void EdgeBatches::make_sums(const BatchDivision& division, int vertices) {
  std::vector<int> last_part(static_cast<std::size_t>(vertices), -1);
  for (int p = 0; p < static_cast<int>(parts_.size()); ++p) {
    BatchPart& part = *parts_[p];
    for (const EdgeBatch& batch : part.batches) {
      const std::size_t arity = batch.adder.positions.size();
      for (std::size_t k = 0; k < batch.vertices.size(); ++k) {
        const int h = batch.vertices[k];
        if (std::exchange(last_part[h], p) == p || division.part_of_vertex(h) == p) continue;
        const int dim = batch.kind->dims[batch.adder.positions[k % arity]];
        part.sums.push_back({h, dim, extra_values_, extra_scalars_, 0, 0});
        extra_values_ += static_cast<std::uint32_t>(dim * dim);
        extra_scalars_ += static_cast<std::uint32_t>(dim);
      }
    }
  }
}

void EdgeBatches::for_each(boxplus::detail::FunctionRef<void(Edge&)> f) const {
  for (const std::unique_ptr<BatchPart>& part : parts_) {
    for (const EdgeBatch& batch : part->batches) {
      for (Edge* edge : batch.edges) f(*edge);
    }
  }
}

bool EdgeBatches::lay_out(const HessianPlaces& places, std::uint64_t stamp) {
  stamp_ = 0;
  values_ = places.values();
  scalars_ = places.scalars();
  if (std::uint64_t{values_} + extra_values_ >= boxplus::dense::kTransposedTarget) return false;
  for (const std::unique_ptr<BatchPart>& part : parts_) {
    if (!lay_out_targets(places, *part)) return false;
  }
  stamp_ = stamp;
  return true;
}

/// Runs the task of each part on all threads, and adds up the results in the order of the parts.
BatchPass EdgeBatches::for_all_parts(boxplus::detail::FunctionRef<void(BatchPart&, BatchPass&)> task) {
  BatchPass total;
  if (parts_.size() == 1) {
    task(*parts_[0], total);
    return total;
  }
  std::array<BatchPass, BatchDivision::kParts> passes;
  for_each_part(static_cast<int>(parts_.size()), [&](int p) { task(*parts_[p], passes[p]); });
  for (const BatchPass& pass : passes) total.append(pass);
  return total;
}

BatchPass EdgeBatches::compute_errors() {
  return for_all_parts([](BatchPart& part, BatchPass& pass) { part.compute_errors(pass); });
}

void EdgeBatches::clear(double* values, double* gradient) const {
  set_to_zero(values, values_ + extra_values_, static_cast<int>(parts_.size()));
  std::fill_n(gradient, scalars_ + extra_scalars_, 0.0);
}

BatchPass EdgeBatches::linearize(double* values, double* gradient, bool with_errors) {
  BatchPass pass = for_all_parts(
      [&](BatchPart& part, BatchPass& found) { part.linearize(values, gradient, with_errors, found); });
  add_sums(values, gradient);
  return pass;
}

void EdgeBatches::add_sums(double* values, double* gradient) const {
  for (const std::unique_ptr<BatchPart>& part : parts_) {
    for (const BatchPart::Sum& sum : part->sums) {
      for (int k = 0; k < sum.dim * sum.dim; ++k)
        values[sum.to_value + static_cast<std::uint32_t>(k)] +=
            values[values_ + sum.from_value + static_cast<std::uint32_t>(k)];
      for (int k = 0; k < sum.dim; ++k)
        gradient[sum.to_scalar + static_cast<std::uint32_t>(k)] +=
            gradient[scalars_ + sum.from_scalar + static_cast<std::uint32_t>(k)];
    }
  }
}

}  // namespace internal
}  // namespace g2o
