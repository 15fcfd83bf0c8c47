// SPDX-License-Identifier: BSD-3-Clause
// The diagonal of H, and the diagonal matrix that a step adds to H.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "boxplus/system/system.h"

namespace boxplus {

/// A step adds λD to H, where D is the identity or the scale, plus a fraction of the scale against gauge
/// freedom, plus an entry for each unknown that is held.
class StepDiagonal {
 public:
  void resize(std::uint32_t scalars);
  /// Forgets the largest entries of earlier runs.
  void begin_run();

  /// Sets an entry of the diagonal of H. Different threads may set different entries.
  void set(std::uint32_t scalar, double entry);
  /// To be called after all entries have been set.
  void find_floor();
  /// The lower limit of the scale. It is rounded down to a power of 8, so that it seldom differs from the
  /// limit of the previous linearization.
  double floor() const { return floor_; }

  std::span<const double> diagonal() const { return diagonal_; }
  /// An entry is at least a small fraction of the largest entry of the diagonal since begin_run(): otherwise,
  /// a Jacobian that vanishes on the way would end a run far from a minimum (Moré, "The Levenberg-Marquardt
  /// algorithm: implementation and theory", 1978, §6).
  std::span<const double> scale() const { return scale_; }

  /// Whether λD is a multiple of the identity.
  static bool is_uniform(const StepDamping& damping) {
    return damping.scale == Options::DampingScale::kIdentity || damping.lambda == 0;
  }
  /// Computes the entries [first, last) of the matrix to add, without those of held unknowns. `gauge` is the
  /// fraction of the scale to add.
  void fill(const StepDamping& damping, double gauge, double floor, std::uint32_t first, std::uint32_t last);
  /// Adds `times` the diagonal entry of H to an entry of the matrix.
  void hold(std::uint32_t scalar, double times);
  /// Whether the first `count` entries of the matrix differ between the floors a and b.
  bool depends_on_floor(const StepDamping& damping, double gauge, double a, double b,
                        std::uint32_t count) const;
  /// The matrix, as fill() and hold() made it.
  const double* added() const { return added_.data(); }

 private:
  std::vector<double> diagonal_, scale_, added_;
  std::vector<double> largest_;  // since begin_run()
  double floor_ = 0;
};

}  // namespace boxplus
