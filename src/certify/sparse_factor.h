// SPDX-License-Identifier: BSD-3-Clause
// A Cholesky factorization in double.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "boxplus/linear/make_linear_solver.h"

namespace boxplus::certificate {

/// What a computation may use.
struct Resources {
  int threads = 1;  ///< at least 1
  StopToken stop = {};
};

class SparseFactor {
 public:
  /// `structure` and `values` must outlive this object. All functions throw Stopped if the token is raised.
  SparseFactor(const BlockStructure& structure, std::span<const double> values, int columns,
               const Resources& resources, std::span<const std::uint32_t> order = {});

  /// Factorizes A + damping. Returns false if it is not positive definite.
  bool factorize(const Damping& damping = {});
  /// Overwrites `x` with the solutions for as many right-hand sides as it has columns.
  void solve(std::vector<double>& x);
  std::span<const std::uint32_t> order() const { return solver_->elimination_order(); }

 private:
  void check(LinearStatus status) const;

  const BlockStructure& structure_;
  AssembledSystem system_;
  StopToken stop_;
  std::unique_ptr<LinearSolver> solver_;
};

}  // namespace boxplus::certificate
