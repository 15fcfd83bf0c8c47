// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/graph/edge_pool.h"

#include <algorithm>
#include <string>
#include <utility>

#include "boxplus/base/error.h"
#include "boxplus/graph/error_function.h"
#include "boxplus/graph/make_room.h"

namespace boxplus {

std::string_view to_string(JacobianSource source) {
  switch (source) {
    case JacobianSource::kAnalytic:
      return "analytic";
    case JacobianSource::kAutomatic:
      return "automatic";
    default:
      return "numeric";
  }
}

void edge::throw_row_count(int expected, int actual) {
  throw InvalidArgument("an error function returned " + std::to_string(actual) + " rows, expected the " +
                        std::to_string(expected) + " it had when its edge was added");
}

EdgePool::EdgePool(std::vector<std::uint32_t> vertex_pools, bool run_time_arity)
    : vertex_pools_(std::move(vertex_pools)),
      uniform_arity_(run_time_arity ? -1 : static_cast<int>(vertex_pools_.size())) {
  if (run_time_arity) vertex_start_.push_back(0);
}

void EdgePool::chi2(std::span<const std::uint32_t> edges, double* out) const {
  thread_local std::vector<double> errors_scratch;
  constexpr std::size_t kBatch = 256;
  for (std::size_t first = 0; first < edges.size(); first += kBatch) {
    const auto batch = edges.subspan(first, std::min(kBatch, edges.size() - first));
    std::size_t rows = 0;
    for (std::uint32_t edge : batch) rows += static_cast<std::size_t>(shape(edge).rows);
    if (errors_scratch.size() < rows) errors_scratch.resize(rows);
    errors(batch, errors_scratch.data());
    const double* e = errors_scratch.data();
    for (std::uint32_t edge : batch) {
      const InformationView omega = information(edge);
      *out++ = omega.squared_norm(e);
      e += omega.rows;
    }
  }
}

void EdgePool::reserve_slots(std::size_t edges) {
  const double growth = slots() == 0 ? 1 : static_cast<double>(edges) / slots();
  if (growth <= 1) return;
  vertex_slots_.reserve(static_cast<std::size_t>(growth * static_cast<double>(vertex_slots_.size())));
  flags_.reserve(edges);
  generations_.reserve(edges);
  if (uniform_arity_ < 0) vertex_start_.reserve(edges + 1);
  information_.reserve(growth);
}

/// Where in free_ an edge of this arity lies, or its size. Of the slots of other arities that may lie on top
/// only a few are looked at.
std::size_t EdgePool::find_free(std::size_t arity) const {
  constexpr std::size_t kLook = 16;
  for (std::size_t k = 1; k <= std::min(kLook, free_.size()); ++k) {
    const std::size_t at = free_.size() - k;
    if (static_cast<std::size_t>(this->arity(free_[at])) == arity) return at;
  }
  return free_.size();
}

std::uint32_t EdgePool::next_slot(std::size_t arity) const {
  const std::size_t at = find_free(arity);
  return at < free_.size() ? free_[at] : slots();
}

std::uint32_t EdgePool::acquire_slot(std::span<const std::uint32_t> vertex_slots,
                                     const Information& information, int rows) {
  const std::size_t at = find_free(vertex_slots.size());
  if (at == free_.size()) {
    append_slot(vertex_slots, information, rows);
    return slots() - 1;
  }
  const std::uint32_t edge = free_[at];
  information_.set(edge, information, rows);
  free_.erase(free_.begin() + static_cast<std::ptrdiff_t>(at));
  std::copy(vertex_slots.begin(), vertex_slots.end(),
            vertex_slots_.begin() + static_cast<std::ptrdiff_t>(vertex_start(edge)));
  flags_[edge] = kAlive | kEnabled;
  if (!levels_.empty()) levels_[edge] = 0;
  return edge;
}

void EdgePool::append_slot(std::span<const std::uint32_t> vertex_slots, const Information& information,
                           int rows) {
  make_room(vertex_slots_, vertex_slots.size());
  make_room(flags_);
  make_room(generations_);
  if (uniform_arity_ < 0) make_room(vertex_start_);
  if (!levels_.empty()) make_room(levels_);
  if (!kernels_.empty()) make_room(kernels_);
  information_.append(information, rows);
  vertex_slots_.insert(vertex_slots_.end(), vertex_slots.begin(), vertex_slots.end());
  if (uniform_arity_ < 0) vertex_start_.push_back(static_cast<std::uint32_t>(vertex_slots_.size()));
  flags_.push_back(kAlive | kEnabled);
  generations_.push_back(first_generation_);
  if (!levels_.empty()) levels_.push_back(0);
  if (!kernels_.empty()) kernels_.emplace_back();
}

void EdgePool::remove(std::uint32_t edge) {
  free_.push_back(edge);
  flags_[edge] = 0;
  ++generations_[edge];
  if (!kernels_.empty()) kernels_[edge].reset();
}

void EdgePool::set_kernel(std::uint32_t edge, std::shared_ptr<const RobustKernel> kernel) {
  if (kernels_.empty()) {
    if (!kernel) return;
    kernels_.resize(flags_.size());
  }
  kernels_[edge] = std::move(kernel);
}

}  // namespace boxplus
