// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/graph/edge_pool.h"

#include <algorithm>
#include <string>
#include <utility>

#include "boxplus/base/error.h"
#include "boxplus/base/thread_scratch.h"
#include "boxplus/graph/error_function.h"
#include "boxplus/graph/make_room.h"
#include "kernels/kernel_table.h"

namespace boxplus::detail {

std::string_view to_string(JacobianSource source) {
  switch (source) {
    case JacobianSource::kAnalytic:
      return "analytic";
    case JacobianSource::kAutomatic:
      return "exact";
    default:
      return "numeric";
  }
}

void throw_row_count(int expected, int actual) {
  throw InvalidArgument("an error function returned " + std::to_string(actual) + " rows; it returned " +
                        std::to_string(expected) + " when its edge was added");
}

EdgePool::EdgePool(std::vector<std::uint32_t> vertex_pools, int tails)
    : vertex_pools_(std::move(vertex_pools)),
      uniform_arity_(tails > 0 ? -1 : static_cast<int>(vertex_pools_.size())),
      tails_(tails) {
  if (tails > 0) vertex_start_.push_back(0);
}

/// vertex_pool() for edges that have more than one argument with a variable number of vertices (a tail).
std::uint32_t EdgePool::pool_in_tails(std::uint32_t edge, int i) const {
  const std::size_t singles = vertex_pools_.size() - static_cast<std::size_t>(tails_);
  auto rest = static_cast<std::size_t>(i);
  if (rest < singles) return vertex_pools_[rest];
  rest -= singles;
  std::size_t argument = singles;
  for (const std::uint32_t size : tail_sizes(edge)) {
    if (rest < size) break;
    rest -= size;
    ++argument;
  }
  return vertex_pools_[argument];
}

InformationKind EdgePool::informations(std::span<const std::uint32_t> edges, int rows, const double** omegas,
                                       double* full) const {
  const InformationKind kind = information(edges[0], rows).kind;
  bool is_mixed = false;
  for (std::size_t k = 0; k < edges.size(); ++k) {
    const InformationView omega = information(edges[k], rows);
    omegas[k] = omega.values;
    is_mixed |= omega.kind != kind;
  }
  if (!is_mixed) return kind;
  for (std::size_t k = 0; k < edges.size(); ++k) {
    const InformationView omega = information(edges[k], rows);
    omegas[k] = full;
    for (int i = 0; i < rows; ++i) {
      for (int j = i; j < rows; ++j) *full++ = omega(i, j);
    }
  }
  return InformationKind::kFull;
}

/// chi2() of at most EdgeTile::kCapacity edges, computed in SIMD lanes. Returns false if there are no kernels
/// for these edges.
bool EdgePool::chi2_in_lanes(std::span<const std::uint32_t> edges, double* out) const {
  constexpr int kMostRows = dense::kMostEdgeRows, kMostNumbers = kMostRows * (kMostRows + 1) / 2;
  double errors[EdgeTile::kCapacity * kMostRows], full[EdgeTile::kCapacity * kMostNumbers];
  const int rows = shape(edges[0]).rows;
  const dense::SquaredNorms squared_norms = dense::kernels().squared_norms_for(rows);
  if (squared_norms == nullptr || !errors_in_lanes(edges, errors)) return false;
  const double* omegas[EdgeTile::kCapacity];
  const InformationKind kind = informations(edges, rows, omegas, full);
  squared_norms(static_cast<int>(edges.size()), errors, static_cast<dense::EdgeNumbers::Kind>(kind), omegas,
                out);
  return true;
}

/// chi2() of at most EdgeTile::kCapacity edges that all have `rows` rows, at most kMostEdgeRows.
void EdgePool::chi2_of_tile(std::span<const std::uint32_t> edges, int rows, double* out) const {
  double error[EdgeTile::kCapacity * dense::kMostEdgeRows];
  errors(edges, error);
  const double* e = error;
  for (const std::uint32_t edge : edges) {
    *out++ = information(edge, rows).squared_norm(e);
    e += rows;
  }
}

/// chi2() of edges of any shapes.
void EdgePool::chi2_one_by_one(std::span<const std::uint32_t> edges, double* out) const {
  constexpr std::size_t kRoom = 512;
  double room[kRoom];
  const BorrowedScratch<std::vector<double>, struct LongError> more;
  for (const std::uint32_t edge : edges) {
    const int rows = shape(edge).rows;
    if (static_cast<std::size_t>(rows) > std::max(kRoom, more->size()))
      more->resize(static_cast<std::size_t>(rows));
    double* e = static_cast<std::size_t>(rows) > kRoom ? more->data() : room;
    errors(std::span(&edge, 1), e);
    *out++ = information(edge, rows).squared_norm(e);
  }
}

void EdgePool::chi2(std::span<const std::uint32_t> edges, double* out) const {
  if (edges.empty()) return;
  const int rows = uniform_shape() ? shape(edges[0]).rows : dense::kMostEdgeRows + 1;
  if (rows > dense::kMostEdgeRows) return chi2_one_by_one(edges, out);
  while (!edges.empty()) {
    const auto tile = edges.first(std::min<std::size_t>(edges.size(), EdgeTile::kCapacity));
    if (!chi2_in_lanes(tile, out)) chi2_of_tile(tile, rows, out);
    edges = edges.subspan(tile.size());
    out += tile.size();
  }
}

void EdgePool::reserve_slots(std::size_t edges) {
  const double growth = slots() == 0 ? 1 : static_cast<double>(edges) / slots();
  if (growth <= 1) return;
  boxplus::detail::reserve(vertex_slots_,
                           static_cast<std::size_t>(growth * static_cast<double>(vertex_slots_.size())));
  boxplus::detail::reserve(flags_, edges);
  boxplus::detail::reserve(generations_, edges);
  if (uniform_arity_ < 0) boxplus::detail::reserve(vertex_start_, edges + 1);
  information_.reserve(growth);
}

/// The position in free_ of a slot for edges of this arity, or free_.size() if there is no such slot. Looks
/// only at the last entries of free_, but at so many that a pool whose arities vary does not grow for ever.
std::size_t EdgePool::find_free(std::size_t arity) const {
  constexpr std::size_t kLook = 256;
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
                                     std::span<const std::uint32_t> tail_sizes,
                                     const Information& information, int rows) {
  const std::size_t at = find_free(vertex_slots.size());
  if (at == free_.size()) {
    append_slot(vertex_slots, tail_sizes, information, rows);
    return slots() - 1;
  }
  const std::uint32_t edge = free_[at];
  information_.set(edge, information, rows);
  free_.erase(free_.begin() + static_cast<std::ptrdiff_t>(at));
  std::copy(vertex_slots.begin(), vertex_slots.end(),
            vertex_slots_.begin() + static_cast<std::ptrdiff_t>(vertex_start(edge)));
  if (tails_ > 1) std::copy(tail_sizes.begin(), tail_sizes.end(), tail_sizes_.begin() + edge * tails_);
  flags_[edge] = kAlive | kEnabled;
  generations_[edge] = next_generation_++;
  if (!levels_.empty()) levels_[edge] = 0;
  return edge;
}

void EdgePool::append_slot(std::span<const std::uint32_t> vertex_slots,
                           std::span<const std::uint32_t> tail_sizes, const Information& information,
                           int rows) {
  make_room(vertex_slots_, vertex_slots.size());
  make_room(flags_);
  make_room(generations_);
  if (uniform_arity_ < 0) make_room(vertex_start_);
  if (tails_ > 1) make_room(tail_sizes_, tail_sizes.size());
  if (!levels_.empty()) make_room(levels_);
  if (!kernels_.empty()) make_room(kernels_);
  information_.append(information, rows);
  vertex_slots_.insert(vertex_slots_.end(), vertex_slots.begin(), vertex_slots.end());
  if (uniform_arity_ < 0) vertex_start_.push_back(static_cast<std::uint32_t>(vertex_slots_.size()));
  if (tails_ > 1) tail_sizes_.insert(tail_sizes_.end(), tail_sizes.begin(), tail_sizes.end());
  flags_.push_back(kAlive | kEnabled);
  generations_.push_back(next_generation_++);
  if (!levels_.empty()) levels_.push_back(0);
  if (!kernels_.empty()) kernels_.emplace_back();
}

void EdgePool::remove(std::uint32_t edge) {
  free_.push_back(edge);
  flags_[edge] = 0;
  if (!kernels_.empty()) kernels_[edge].reset();
}

void EdgePool::set_kernel(std::uint32_t edge, std::shared_ptr<const RobustKernel> kernel) {
  if (kernels_.empty()) {
    if (!kernel) return;
    kernels_.resize(flags_.size());
  }
  kernels_[edge] = std::move(kernel);
}

}  // namespace boxplus::detail
