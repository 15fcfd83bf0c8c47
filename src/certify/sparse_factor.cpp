// SPDX-License-Identifier: BSD-3-Clause
#include "certify/sparse_factor.h"

namespace boxplus::certificate {

SparseFactor::SparseFactor(const BlockStructure& structure, std::span<const double> values, int columns,
                           const Resources& resources, std::span<const std::uint32_t> order)
    : structure_(structure), system_(structure, values), stop_(resources.stop) {
  LinearSolverOptions options;
  options.block_cholesky.precision = Precision::kDouble;
  solver_ = make_linear_solver(LinearSolverKind::kBlockCholesky, options);
  AnalyzeHints hints;
  hints.right_hand_sides = columns;
  hints.threads = resources.threads;
  hints.order = order;
  solver_->analyze(structure, hints, stop_);
}

void SparseFactor::check(LinearStatus status) const {
  if (status == LinearStatus::kStopped) throw Stopped(stop_.flag_raised());
}

bool SparseFactor::factorize(const Damping& damping) {
  const LinearStatus status = solver_->factorize(system_, damping, {.stop = stop_}).status;
  check(status);
  return status == LinearStatus::kOk;
}

void SparseFactor::solve(std::vector<double>& x) {
  const int columns = static_cast<int>(x.size() / structure_.scalars());
  check(solver_->solve(x.data(), columns, x.data(), {.stop = stop_}).status);
}

}  // namespace boxplus::certificate
