// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/cholmod_peer.h"

#include <algorithm>
#include <stdexcept>

namespace boxplus::bench {
namespace {

constexpr int kUpperTriangle = 1;

/// Allocates a symmetric n × n matrix whose upper triangle has `nonzeros` entries. `type` is CHOLMOD_REAL or
/// CHOLMOD_PATTERN.
cholmod_sparse* allocate_upper(std::uint32_t n, std::size_t nonzeros, int type, cholmod_common& common) {
  return cholmod_allocate_sparse(n, n, nonzeros, /*sorted=*/1, /*packed=*/1, kUpperTriangle, type, &common);
}

}  // namespace

std::string CholmodSettings::name() const {
  const std::string order = ordering == Ordering::kAmd ? "AMD" : "METIS";
  return order + (on_blocks ? " on blocks" : "") + (supernodal ? ", supernodal" : ", simplicial");
}

const std::array<CholmodSettings, 8>& all_cholmod_settings() {
  using enum CholmodSettings::Ordering;
  static constexpr std::array<CholmodSettings, 8> kAll{{{kAmd, false, true},
                                                        {kAmd, false, false},
                                                        {kAmd, true, true},
                                                        {kAmd, true, false},
                                                        {kMetis, false, true},
                                                        {kMetis, false, false},
                                                        {kMetis, true, true},
                                                        {kMetis, true, false}}};
  return kAll;
}

CholmodPeer::CholmodPeer(const BlockStructure& structure, std::span<const double> values,
                         const CholmodSettings& settings)
    : settings_(settings), offset_(structure.offset) {
  cholmod_start(&common_);
  common_.print = 0;
  common_.supernodal = settings.supernodal ? CHOLMOD_SUPERNODAL : CHOLMOD_SIMPLICIAL;
  common_.nmethods = 1;
  const int ordering = settings.ordering == CholmodSettings::Ordering::kAmd ? CHOLMOD_AMD : CHOLMOD_METIS;
  common_.method[0].ordering = settings.on_blocks ? CHOLMOD_GIVEN : ordering;
  common_.postorder = 1;
  fill(structure, values);
  fill_block_pattern(structure);
  b_ = cholmod_allocate_dense(structure.scalars(), 1, structure.scalars(), CHOLMOD_REAL, &common_);
  check("set up");
}

CholmodPeer::~CholmodPeer() {
  for (cholmod_dense** dense : {&b_, &x_, &y_, &e_}) cholmod_free_dense(dense, &common_);
  cholmod_free_factor(&factor_, &common_);
  cholmod_free_sparse(&block_pattern_, &common_);
  cholmod_free_sparse(&matrix_, &common_);
  cholmod_finish(&common_);
}

void CholmodPeer::check(const char* step) const {
  if (common_.status == CHOLMOD_OK) return;
  throw std::runtime_error("CHOLMOD, " + settings_.name() + ": status " + std::to_string(common_.status) +
                           " after " + step);
}

/// Copies the lower triangle of blocks to the upper triangle of matrix_, which is stored by columns. Row i of
/// the lower triangle becomes column i of the upper triangle, so the blocks of each row are collected first.
void CholmodPeer::fill(const BlockStructure& structure, std::span<const double> values) {
  const std::uint32_t n = structure.scalars();
  std::vector<std::vector<std::pair<std::uint32_t, std::uint32_t>>> blocks_of_row(structure.blocks());
  std::size_t nonzeros = 0;
  for (std::uint32_t j = 0; j < structure.blocks(); ++j) {
    for (std::uint32_t k = structure.column_start[j]; k < structure.column_start[j + 1]; ++k) {
      const std::uint32_t i = structure.row[k], dim = structure.dim(i);
      blocks_of_row[i].emplace_back(j, k);
      nonzeros += i == j ? dim * (dim + 1) / 2 : dim * structure.dim(j);
    }
  }
  matrix_ = allocate_upper(n, nonzeros, CHOLMOD_REAL, common_);
  auto *start = static_cast<int*>(matrix_->p), *row = static_cast<int*>(matrix_->i);
  auto* value = static_cast<double*>(matrix_->x);
  int next = 0;
  for (std::uint32_t i = 0; i < structure.blocks(); ++i) {
    for (std::uint32_t r = 0; r < structure.dim(i); ++r) {
      start[structure.offset[i] + r] = next;
      for (const auto& [j, k] : blocks_of_row[i]) {
        const std::uint32_t columns = i == j ? r + 1 : structure.dim(j);
        for (std::uint32_t c = 0; c < columns; ++c, ++next) {
          row[next] = static_cast<int>(structure.offset[j] + c);
          value[next] = values[structure.value_start[k] + c * structure.dim(i) + r];
        }
      }
    }
  }
  start[n] = next;
}

void CholmodPeer::fill_block_pattern(const BlockStructure& structure) {
  const std::uint32_t n = structure.blocks();
  cholmod_sparse* lower = allocate_upper(n, structure.nonzero_blocks(), CHOLMOD_PATTERN, common_);
  lower->stype = -kUpperTriangle;
  std::copy(structure.column_start.begin(), structure.column_start.end(), static_cast<int*>(lower->p));
  std::copy(structure.row.begin(), structure.row.end(), static_cast<int*>(lower->i));
  block_pattern_ = cholmod_transpose(lower, 0, &common_);
  cholmod_free_sparse(&lower, &common_);
}

/// Orders the blocks, and returns the resulting order of the scalars.
std::vector<int> CholmodPeer::order_blocks() {
  std::vector<int> blocks(block_pattern_->ncol), scalars;
  if (settings_.ordering == CholmodSettings::Ordering::kAmd) {
    cholmod_amd(block_pattern_, nullptr, 0, blocks.data(), &common_);
  } else {
    cholmod_metis(block_pattern_, nullptr, 0, /*postorder=*/0, blocks.data(), &common_);
  }
  scalars.reserve(matrix_->ncol);
  for (const int block : blocks) {
    const auto k = static_cast<std::size_t>(block);
    for (std::uint32_t i = offset_[k]; i < offset_[k + 1]; ++i) scalars.push_back(static_cast<int>(i));
  }
  return scalars;
}

void CholmodPeer::forget() {
  cholmod_free_factor(&factor_, &common_);
}

void CholmodPeer::analyze() {
  forget();
  if (settings_.on_blocks) {
    std::vector<int> order = order_blocks();
    factor_ = cholmod_analyze_p(matrix_, order.data(), nullptr, 0, &common_);
  } else {
    factor_ = cholmod_analyze(matrix_, &common_);
  }
  check("analysis");
}

void CholmodPeer::factorize() {
  cholmod_factorize(matrix_, factor_, &common_);
  check("factorization");
}

std::span<const double> CholmodPeer::solve(std::span<const double> b) {
  std::copy(b.begin(), b.end(), static_cast<double*>(b_->x));
  cholmod_solve2(CHOLMOD_A, factor_, b_, nullptr, &x_, nullptr, &y_, &e_, &common_);
  check("solution");
  return {static_cast<const double*>(x_->x), b.size()};
}

}  // namespace boxplus::bench
