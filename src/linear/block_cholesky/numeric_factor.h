// SPDX-License-Identifier: BSD-3-Clause
// The numerical multifrontal factorization (Duff and Reid 1983; Liu 1992).
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "boxplus/linear/linear_solver.h"
#include "linear/block_cholesky/symbolic_factor.h"
#include "linear/lost_pivot.h"

namespace boxplus {

/// The few pivots that lost the most digits, sorted by ratio, then by scalar.
class Suspects {
 public:
  struct Suspect {
    std::uint32_t scalar;  // in the elimination order
    double ratio;          // the pivot divided by its limit in minimum_pivot()
  };
  void clear() { count_ = 0; }
  void add(Suspect suspect);
  void add(const Suspects& others) {
    for (std::size_t i = 0; i < others.count_; ++i) add(others.list_[i]);
  }
  std::span<Suspect> list() { return std::span(list_).first(count_); }

 private:
  std::array<Suspect, 4> list_{};
  std::size_t count_ = 0;
};

/// The values of a factor, and memory for right-hand sides. Scalar is double or float.
template <class Scalar>
class NumericFactor {
 public:
  void allocate(const SymbolicFactor& symbolic, std::uint32_t scalars, int right_hand_sides);
  void release() { *this = NumericFactor(); }
  bool allocated() const { return memory_ != nullptr; }
  /// The panels, followed by the update matrices.
  Scalar* arena() const { return memory_.get(); }
  /// kLostPivotOf<Scalar> times the diagonal of A + λD, in the elimination order.
  Scalar* minimum_pivot() const { return minimum_pivot_; }
  /// The right-hand sides. For each scalar, the values of all right-hand sides are contiguous.
  Scalar* x() const { return x_; }
  /// Scratch memory. Its size suffices either for one column of the largest front per right-hand side, or for
  /// one column of all fronts together.
  Scalar* work() const { return work_; }

  Suspects suspects;
  std::vector<Suspects> suspects_of_thread;  // one per thread
  std::vector<LinearStatus> status_of_thread;

 private:
  std::unique_ptr<Scalar[]> memory_;
  Scalar *minimum_pivot_ = nullptr, *x_ = nullptr, *work_ = nullptr;
};

struct FrontsResult {
  LinearStatus status = LinearStatus::kOk;  // or kNotPositiveDefinite, or kStopped
  std::uint32_t lost_pivot = 0;  // the first lost pivot in the elimination order, if not positive definite
};

/// Factorizes A + λD into the panels. Reads only the lower triangle of `values`. Checks `stop` before every
/// front, and within large fronts.
template <class Scalar>
FrontsResult factorize_fronts(const SymbolicFactor& symbolic, const BlockStructure& structure,
                              const double* values, const Damping& damping, const StopToken& stop,
                              NumericFactor<Scalar>& factor);

}  // namespace boxplus
