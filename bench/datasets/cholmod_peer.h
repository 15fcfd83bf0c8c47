// SPDX-License-Identifier: BSD-3-Clause
// Runs CHOLMOD on the same matrix as boxplus.
#pragma once

#include <cholmod.h>

#include <array>
#include <string>
#include <vector>

#include "boxplus/linear/block_system.h"

namespace boxplus::bench {

/// One configuration of CHOLMOD. All configurations are tried on every matrix.
struct CholmodSettings {
  enum class Ordering { kAmd, kMetis } ordering;
  bool on_blocks;   ///< true: the ordering permutes whole blocks, as in g2o; false: single scalars
  bool supernodal;  ///< true: supernodal; false: simplicial (L D Lᵀ, column by column)

  std::string name() const;
};
const std::array<CholmodSettings, 8>& all_cholmod_settings();

/// Solves systems with one matrix by CHOLMOD. The upper triangle of the matrix is stored by columns, which is
/// the fastest form according to the manual of CHOLMOD.
class CholmodPeer {
 public:
  CholmodPeer(const BlockStructure& structure, std::span<const double> values,
              const CholmodSettings& settings);
  ~CholmodPeer();
  CholmodPeer(const CholmodPeer&) = delete;
  CholmodPeer& operator=(const CholmodPeer&) = delete;

  const CholmodSettings& settings() const { return settings_; }
  /// Frees the memory of the factor.
  void forget();
  /// analyze(), factorize() and solve() throw std::runtime_error if CHOLMOD reports a failure.
  void analyze();
  void factorize();
  /// Returns A⁻¹ b. The result is valid until the next call.
  std::span<const double> solve(std::span<const double> b);
  /// Returns the number of floating-point operations of a factorization L Lᵀ with this ordering, without the
  /// operations on the zeros that supernodes add.
  double flops() const { return common_.fl; }

 private:
  void fill(const BlockStructure& structure, std::span<const double> values);
  void fill_block_pattern(const BlockStructure& structure);
  std::vector<int> order_blocks();
  void check(const char* step) const;

  CholmodSettings settings_;
  std::vector<std::uint32_t> offset_;
  cholmod_common common_{};
  cholmod_sparse *matrix_ = nullptr, *block_pattern_ = nullptr;
  cholmod_factor* factor_ = nullptr;
  cholmod_dense *b_ = nullptr, *x_ = nullptr, *y_ = nullptr, *e_ = nullptr;
};

}  // namespace boxplus::bench
