// SPDX-License-Identifier: BSD-3-Clause
#include "shared_solver.h"

#include <algorithm>
#include <string>

#include "boxplus/base/error.h"

namespace boxplus::mpi {

SharedSolver::SharedSolver(std::shared_ptr<LinearSolver> inner, Communicator& communicator,
                           const KeptVertices& kept, int threads)
    : inner_(std::move(inner)), communicator_(&communicator), kept_(&kept), threads_(threads) {
  if (inner_->needs() == Needs::kOperator)
    throw InvalidArgument("expected a linear solver that takes a matrix, got '" +
                          std::string(inner_->name()) + "', which takes an operator");
}

/// Finds the place of each vertex of this process in the inner system.
void SharedSolver::find_places() {
  const std::span<const KeptVertices::Local> local = kept_->local();
  vertices_.clear();
  places_.clear();
  if (is_divided()) {
    for (const KeptVertices::Local& vertex : local) vertices_.push_back(vertex.vertex);
    std::ranges::sort(vertices_);
  }
  std::vector<std::uint32_t> first(1, 0);  // scalar of each of vertices_
  for (const std::uint32_t vertex : vertices_) first.push_back(first.back() + kept_->dims()[vertex]);
  for (const KeptVertices::Local& vertex : local) {
    const auto found = std::ranges::lower_bound(vertices_, vertex.vertex) - vertices_.begin();
    places_.push_back(is_divided() ? Place{static_cast<std::uint32_t>(found), first[found]}
                                   : Place{vertex.vertex, vertex.all_first});
  }
}

/// Calls f, which calls the inner solver.
template <class F>
auto SharedSolver::call_inner(F&& f) {
  return is_divided() ? communicator_->while_others_wait(f) : f();
}

/// Calls f(scalar of the local system, scalar of the inner system, whether this process owns it).
template <class F>
void SharedSolver::for_each_scalar(F&& f) const {
  for (std::size_t k = 0; k < places_.size(); ++k) {
    const KeptVertices::Local& vertex = kept_->local()[k];
    for (std::uint32_t i = 0; i < vertex.dim; ++i)
      f(vertex.first - first_local_ + i, places_[k].first + i, vertex.own);
  }
}

std::vector<std::vector<SharedSolver::PartOfBlock>> SharedSolver::vertices_of_blocks(
    const BlockStructure& structure) const {
  std::vector<std::vector<PartOfBlock>> result(structure.blocks());
  std::uint32_t block = 0;
  for (std::size_t k = 0; k < places_.size(); ++k) {
    const KeptVertices::Local& vertex = kept_->local()[k];
    const std::uint32_t scalar = vertex.first - first_local_;
    while (structure.offset[block + 1] <= scalar) ++block;
    result[block].push_back({scalar - structure.offset[block], vertex.dim, places_[k].block});
  }
  return result;
}

void SharedSolver::analyze(const BlockStructure& structure, const AnalyzeHints& /*hints*/,
                           const StopToken& stop) {
  const std::span<const KeptVertices::Local> local = kept_->local();
  first_local_ = local.empty() ? 0 : local.front().first;
  find_places();
  const auto vertices = vertices_of_blocks(structure);
  // Calls f(block, row, column) for each pair of vertices with values in the lower triangle.
  const auto for_each_pair = [&](auto&& f) {
    for (std::uint32_t column = 0; column < structure.blocks(); ++column) {
      for (std::uint32_t k = structure.column_start[column]; k < structure.column_start[column + 1]; ++k) {
        for (const PartOfBlock& c : vertices[column]) {
          for (const PartOfBlock& r : vertices[structure.row[k]]) {
            if (structure.row[k] != column || r.first >= c.first) f(k, r, c);
          }
        }
      }
    }
  };
  std::vector<std::uint64_t> pairs;
  for_each_pair([&](std::uint32_t, const PartOfBlock& r, const PartOfBlock& c) {
    const auto [low, high] = std::minmax(r.block, c.block);
    if (low != high) pairs.push_back((std::uint64_t{high} << 32) + low);
  });
  if (!is_divided()) pairs = communicator_->gather(pairs);
  std::ranges::sort(pairs);
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  std::vector<BlockCoordinate> lower;
  lower.reserve(pairs.size());
  for (const std::uint64_t pair : pairs)
    lower.push_back({static_cast<std::uint32_t>(pair >> 32), static_cast<std::uint32_t>(pair)});
  pairs = {};
  std::vector<std::uint32_t> dims = is_divided() ? std::vector<std::uint32_t>() : kept_->dims();
  for (const std::uint32_t vertex : vertices_) dims.push_back(kept_->dims()[vertex]);
  structure_ = make_block_structure(dims, lower, stop);
  values_.resize(std::size_t{structure_.nonzero_values()} + structure_.scalars());
  vector_.resize(structure_.scalars());
  parts_.clear();
  for_each_pair([&](std::uint32_t k, const PartOfBlock& r, const PartOfBlock& c) {
    const std::uint32_t stride = structure.dim(structure.row[k]);
    const bool transposed = r.block < c.block;
    const auto [low, high] = std::minmax(r.block, c.block);
    parts_.push_back({structure.value_start[k] + c.first * stride + r.first,
                      structure_.value_start[structure_.find(high, low)], static_cast<std::uint16_t>(r.dim),
                      static_cast<std::uint16_t>(c.dim), static_cast<std::uint16_t>(stride), transposed});
  });
  const DividedSystem divided{kept_->dims(), vertices_};
  (void)communicator_->any(false);  // the inner solver begins in all processes, unless one has failed
  call_inner([&] {
    inner_->analyze(structure_, {.threads = threads_, .divided = is_divided() ? &divided : nullptr}, stop);
  });
}

/// Whether all processes go on. Collective.
bool SharedSolver::agree(LinearStatus status) {
  worst_ = static_cast<LinearStatus>(static_cast<int>(communicator_->max(static_cast<int>(status))));
  if (worst_ != LinearStatus::kOk) stage_ = Stage::kFailed;
  return worst_ == LinearStatus::kOk;
}

/// Makes the result of the process that knows the failed block that of all.
void SharedSolver::find_failed_vertex(std::uint32_t failed_block) {
  double vertex = -1;
  if (failed_block < structure_.blocks()) vertex = is_divided() ? vertices_[failed_block] : failed_block;
  vertex = communicator_->max(vertex);
  if (vertex >= 0) failed_vertex_ = static_cast<std::uint32_t>(vertex);
}

/// Adds the values of this process to values_.
void SharedSolver::add_parts(std::span<const double> values) {
  for (const Part& part : parts_) {
    const double* from = values.data() + part.from;
    double* to = values_.data() + part.to;
    for (std::uint32_t c = 0; c < part.columns; ++c, from += part.stride) {
      for (std::uint32_t r = 0; r < part.rows; ++r)
        to[part.transposed ? r * part.columns + c : c * part.rows + r] += from[r];
    }
  }
}

FactorResult SharedSolver::factorize(const BlockSystem& system, const Damping& damping,
                                     const SolveControl& control) {
  if (stage_ == Stage::kFailed) return {worst_};  // a second try of this process alone
  if (!agree(LinearStatus::kOk)) return {worst_};
  std::ranges::fill(values_, 0.0);
  add_parts(system.values());
  double* const diagonal = values_.data() + structure_.nonzero_values();
  for_each_scalar([&](std::uint32_t i, std::uint32_t inner, bool own) {
    if (own) diagonal[inner] = damping(i);
  });
  if (!is_divided()) communicator_->add_up(values_);
  const AssembledSystem sum(structure_, {values_.data(), structure_.nonzero_values()});
  SolveControl own_control = control;
  own_control.right_hand_side = nullptr;
  const FactorResult result = call_inner([&] {
    return inner_->factorize(sum, {1.0, diagonal}, own_control);
  });
  if (!agree(result.status)) {
    find_failed_vertex(result.failed_block);
    return {worst_};
  }
  stage_ = Stage::kFactorized;
  return {};
}

SolveResult SharedSolver::solve(const double* b, int columns, double* x, const SolveControl& control) {
  if (!agree(LinearStatus::kOk)) return {worst_};
  SolveResult total{.exact = true};
  std::uint32_t size = 0;  // of the system of this process
  for (const KeptVertices::Local& vertex : kept_->local()) size += vertex.dim;
  for (int c = 0; c < columns; ++c, b += size, x += size) {
    std::ranges::fill(vector_, 0.0);
    for_each_scalar([&](std::uint32_t i, std::uint32_t inner, bool) { vector_[inner] = b[i]; });
    if (!is_divided()) communicator_->add_up(vector_);
    const SolveResult result =
        call_inner([&] { return inner_->solve(vector_.data(), 1, vector_.data(), control); });
    for_each_scalar([&](std::uint32_t i, std::uint32_t inner, bool) { x[i] = vector_[inner]; });
    total.status = std::max(total.status, result.status);
    total.iterations += result.iterations;
    total.exact = total.exact && result.exact;
  }
  const bool usable = total.status == LinearStatus::kNotConverged;
  if (!agree(usable ? LinearStatus::kOk : total.status)) return {worst_};
  stage_ = Stage::kSolved;
  return total;
}

LinearStatus SharedSolver::end(LinearStatus status) {
  if (stage_ != Stage::kFailed) (void)agree(status);
  return worst_;
}

}  // namespace boxplus::mpi
