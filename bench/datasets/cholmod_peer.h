// SPDX-License-Identifier: BSD-3-Clause
// CHOLMOD on the same matrix as our solver.
#pragma once

#include <cholmod.h>

#include <array>
#include <string>
#include <vector>

#include "boxplus/linear/block_system.h"

namespace boxplus::bench {

/// The configurations of CHOLMOD that are tried on every matrix.
struct CholmodSettings {
  enum class Ordering { kAmd, kMetis } ordering;
  bool on_blocks;   ///< order the graph of blocks, as g2o does, instead of that of scalars
  bool supernodal;  ///< otherwise simplicial: L D Lᵀ, column by column

  std::string name() const;
};
const std::array<CholmodSettings, 8>& all_cholmod_settings();

/// One matrix, stored as its upper triangle by columns, the fastest form according to CHOLMOD's manual.
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
  /// Each throws std::runtime_error if CHOLMOD reports a failure.
  void analyze();
  void factorize();
  /// Returns A⁻¹ b; the peer owns the vector.
  std::span<const double> solve(std::span<const double> b);
  /// Useful floating-point operations of a factorization L Lᵀ with the ordering.
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
