// SPDX-License-Identifier: BSD-3-Clause
#include "batched_pool.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <optional>
#include <utility>

#include "boxplus/base/error.h"
#include "boxplus/graph/make_room.h"
#include "constraint_pool.h"

namespace boxplus::python {
namespace {

/// Releases Python's lock (GIL) if this thread holds it.
class WithoutLock {
 public:
  WithoutLock() {
    if (PyGILState_Check() != 0) released_.emplace();
  }

 private:
  std::optional<py::gil_scoped_release> released_;
};

/// Whether this thread is calling an error function.
thread_local bool is_calling = false;

struct Calling {
  Calling() { is_calling = true; }
  ~Calling() { is_calling = false; }
  Calling(const Calling&) = delete;
  Calling& operator=(const Calling&) = delete;
};

py::object copy_of(const py::object& object) {
  const py::gil_scoped_acquire lock;
  return object;
}

std::size_t size_of(const VertexKind& kind) {
  return static_cast<std::size_t>(kind.size);
}

}  // namespace

BatchedPool::BatchedPool(py::object edge, std::shared_ptr<EdgeFunction> function,
                         std::vector<std::uint32_t> indices, std::vector<const detail::VertexPool*> pools,
                         int rows, int width, bool is_constraint)
    : EdgePool(std::move(indices), 0),
      edge_(std::move(edge)),
      function_(std::move(function)),
      pools_(std::move(pools)),
      rows_(rows),
      width_(width),
      is_constraint_(is_constraint) {}

BatchedPool::BatchedPool(const BatchedPool& other, std::vector<const detail::VertexPool*> pools)
    : EdgePool(other),
      edge_(copy_of(other.edge_)),
      function_(other.function_),
      pools_(std::move(pools)),
      rows_(other.rows_),
      width_(other.width_),
      is_constraint_(other.is_constraint_),
      measurements_(other.measurements_),
      shifts_(other.shifts_) {}

BatchedPool::~BatchedPool() {
  const py::gil_scoped_acquire lock;
  edge_ = py::object();
}

std::uint32_t BatchedPool::add(const double* measurement, const Information& information,
                               std::span<const std::uint32_t> slots) {
  const auto width = static_cast<std::size_t>(width_);
  measurements_.reserve((std::size_t{this->slots()} + 1) * width);
  if (is_constraint_) detail::make_room(shifts_);
  const std::uint32_t slot = acquire_slot(slots, {}, information, rows_);
  measurements_.resize(std::size_t{this->slots()} * width);
  std::copy_n(measurement, width_, measurements_.data() + slot * width);
  if (is_constraint_) {
    shifts_.resize(this->slots());
    shifts_[slot].clear();
  }
  cache_ = numeric_ = {};
  return slot;
}

std::unique_ptr<detail::EdgePool> BatchedPool::clone(
    std::span<const std::unique_ptr<detail::VertexPool>> vertex_pools) const {
  std::vector<const detail::VertexPool*> pools;
  for (std::size_t i = 0; i < pools_.size(); ++i)
    pools.push_back(vertex_pools[argument_pool(static_cast<int>(i))].get());
  return std::unique_ptr<EdgePool>(new BatchedPool(*this, std::move(pools)));
}

int BatchedPool::cols() const {
  int cols = 0;
  for (const VertexKind* kind : function_->kinds()) cols += kind->dim;
  return cols;
}

detail::EdgeShape BatchedPool::shape(std::uint32_t /*edge*/) const {
  return {static_cast<int>(pools_.size()), rows_, cols()};
}

void BatchedPool::reserve(std::size_t edges) {
  reserve_slots(edges);
  measurements_.reserve(edges * static_cast<std::size_t>(width_));
  if (is_constraint_) shifts_.reserve(edges);
}

void BatchedPool::errors(std::span<const std::uint32_t> edges, double* out) const {
  const auto rows = static_cast<std::size_t>(rows_);
  with_results(edges, Want::kErrors, [&](const Cache& cache, const auto& index) {
    for (std::size_t k = 0; k < edges.size(); ++k)
      std::copy_n(cache.errors.data() + index(k) * rows, rows, out + k * rows);
  });
  if (is_constraint_) add_shifts(shifts_, edges, rows_, out);
}

void BatchedPool::linearize(std::span<const std::uint32_t> edges, detail::EdgeTile& tile,
                            bool force_numeric) const {
  const auto rows = static_cast<std::size_t>(rows_);
  tile.count = static_cast<int>(edges.size());
  tile.rows = rows_;
  tile.cols = cols();
  tile.in_lanes = false;
  const Want want = force_numeric ? Want::kNumericJacobians : Want::kJacobians;
  with_results(edges, want, [&](const Cache& cache, const auto& index) {
    double* error = tile.error;
    double* jacobian = tile.jacobian;
    for (std::size_t k = 0; k < edges.size(); ++k) {
      error = std::copy_n(cache.errors.data() + index(k) * rows, rows, error);
      jacobian = std::copy_n(cache.jacobians.data() + index(k) * block(), block(), jacobian);
    }
  });
  if (is_constraint_) add_shifts(shifts_, edges, rows_, tile.error);
}

bool BatchedPool::has(const Cache& cache, std::span<const std::uint32_t> edges, Want want) const {
  if (cache.errors.size() < std::size_t{slots()} * static_cast<std::size_t>(rows_)) return false;
  if (want != Want::kErrors && cache.jacobians.empty()) return false;
  std::array<double, kMostNumbers> row;
  for (std::size_t i = 0; i < pools_.size(); ++i) {
    const VertexKind& kind = *function_->kinds()[i];
    const std::size_t size = size_of(kind);
    const double* known = cache.estimates[i].data();
    for (const std::uint32_t edge : edges) {
      kind.read(*pools_[i], vertex_slots(edge)[i], row.data());
      if (std::memcmp(row.data(), known + edge * size, size * sizeof(double)) != 0) return false;
    }
  }
  return true;
}

template <class Use>
void BatchedPool::with_results(std::span<const std::uint32_t> edges, Want want, const Use& use) const {
  if (edges.empty()) return;
  if (is_calling)
    throw InvalidArgument(function_->name() + ": an error function must not read the errors of a graph");
  if (fresh_ > 0) {
    const Cache fresh = evaluate(edges, want);
    return use(fresh, [](std::size_t k) { return k; });
  }
  const Cache& cache = want == Want::kNumericJacobians ? numeric_ : cache_;
  for (;;) {
    {
      const std::shared_lock lock(mutex_);
      if (has(cache, edges, want)) return use(cache, [&](std::size_t k) { return std::size_t{edges[k]}; });
    }
    refresh(edges, want);
  }
}

void BatchedPool::forget() const {
  const std::unique_lock lock(mutex_);
  cache_ = numeric_ = {};
}

void BatchedPool::refresh(std::span<const std::uint32_t> edges, Want want) const {
  const WithoutLock without_lock;
  const std::lock_guard one_at_a_time(calling_);
  Cache& cache = want == Want::kNumericJacobians ? numeric_ : cache_;
  {
    const std::shared_lock lock(mutex_);
    if (has(cache, edges, want)) return;  // another thread was here before
  }
  std::vector<std::uint32_t> alive;
  for (std::uint32_t edge = 0; edge < slots(); ++edge) {
    if (EdgePool::alive(edge)) alive.push_back(edge);
  }
  const Cache packed = evaluate(alive, want);
  Cache fresh;
  const auto scatter = [&](const std::vector<double>& from, std::size_t size, std::vector<double>& to) {
    to.resize(std::size_t{slots()} * size);
    for (std::size_t k = 0; k < alive.size(); ++k)
      std::copy_n(from.data() + k * size, size, to.data() + alive[k] * size);
  };
  for (std::size_t i = 0; i < pools_.size(); ++i)
    scatter(packed.estimates[i], size_of(*function_->kinds()[i]), fresh.estimates.emplace_back());
  scatter(packed.errors, static_cast<std::size_t>(rows_), fresh.errors);
  if (want != Want::kErrors) scatter(packed.jacobians, block(), fresh.jacobians);
  const std::unique_lock lock(mutex_);
  cache = std::move(fresh);
}

/// Calls the function for the listed edges. The result is indexed by the position in this list.
BatchedPool::Cache BatchedPool::evaluate(std::span<const std::uint32_t> edges, Want want) const {
  const py::gil_scoped_acquire lock;
  const Calling calling;
  const auto count = static_cast<py::ssize_t>(edges.size());
  Batch batch;
  Cache cache;
  for (std::size_t i = 0; i < pools_.size(); ++i) {
    const VertexKind& kind = *function_->kinds()[i];
    Numbers& rows = batch.estimates.emplace_back(std::vector<py::ssize_t>{count, kind.size});
    double* row = rows.mutable_data();
    for (const std::uint32_t edge : edges) {
      kind.read(*pools_[i], vertex_slots(edge)[i], row);
      row += kind.size;
    }
    cache.estimates.emplace_back(rows.data(), rows.data() + rows.size());
  }
  if (width_ > 0) {
    batch.has_measurements = true;
    batch.measurements = Numbers(std::vector<py::ssize_t>{count, width_});
    double* row = batch.measurements.mutable_data();
    for (const std::uint32_t edge : edges)
      row = std::copy_n(measurements_.data() + edge * static_cast<std::size_t>(width_), width_, row);
  }
  BatchResult result = (*function_)(edge_, batch, rows_, want);
  cache.errors = std::move(result.errors);
  cache.jacobians = std::move(result.jacobians);
  return cache;
}

}  // namespace boxplus::python
