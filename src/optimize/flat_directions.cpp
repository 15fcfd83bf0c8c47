// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/flat_directions.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "system/whole_vector.h"

namespace boxplus {
namespace {

/// The greatest diagonal entry of H, as a fraction of the largest one, that is only a rounding error of
/// Jacobians that are zero.
constexpr double kFlat = 1e-20;

/// Whether all Jacobians of any scalar are zero.
bool has_flat_scalar(const RunSystem& system) {
  const double limit = kFlat * max_abs(system, system.diagonal());
  return any(system, std::ranges::any_of(system.diagonal(), [&](double entry) { return entry <= limit; }));
}

/// A step along all scalars whose Jacobians are zero. Its length differs between vertices, so that two
/// vertices at the same place move apart. It differs between the scalars of a vertex, so that a vertex does
/// not move along a diagonal: a direction that is held because its pivot vanished could otherwise be the
/// wrong one.
Displacement fill_step(const RunSystem& system, std::vector<double>& step) {
  constexpr double kLength = 1e-2, kGoldenRatio = 0.6180339887498949, kShrink = 0.25;
  const std::span<const double> diagonal = system.diagonal();
  const std::vector<std::uint32_t>& fixed = system.plan().fixed_scalars;
  const BlockStructure& structure = system.plan().structure;
  const double limit = kFlat * max_abs(system, diagonal);
  Displacement result;
  for (std::uint32_t block = 0; block < structure.blocks(); ++block) {
    double whole = 0, length = kLength * (0.5 + std::modf(kGoldenRatio * block, &whole));
    for (std::uint32_t i = structure.offset[block]; i < structure.offset[block + 1]; ++i) {
      if (!(diagonal[i] <= limit) || std::find(fixed.begin(), fixed.end(), i) != fixed.end()) continue;
      step[i] = length;
      length *= kShrink;
      ++result.directions;
    }
  }
  result.directions = static_cast<int>(system.sum(result.directions));
  return result;
}

/// Takes back the displacement of scalars that still have no Jacobians, because nothing measures them.
void take_back_unmeasured(RunSystem& system, std::vector<double>& step, Displacement& result) {
  if (!system.linearize()) return;
  const double limit = kFlat * max_abs(system, system.diagonal());
  int unmeasured = 0;
  for (std::size_t i = 0; i < step.size(); ++i) {
    const bool takes_back = step[i] != 0 && system.diagonal()[i] <= limit;
    step[i] = takes_back ? -step[i] : 0;
    unmeasured += takes_back;
  }
  unmeasured = static_cast<int>(system.sum(unmeasured));
  if (unmeasured == 0) return;
  const double chi2 = system.try_step(step);
  if (!(chi2 <= result.chi2 + kRounding * result.chi2)) return system.reject();
  system.accept();
  result = {chi2, result.directions - unmeasured};
}

}  // namespace

Displacement leave_flat_directions(RunSystem& system, double chi2) {
  const Displacement none{chi2, 0};
  if (!has_flat_scalar(system) || !system.linearize()) return none;
  std::vector<double> step(system.plan().scalars());
  Displacement result = fill_step(system, step);
  if (result.directions == 0) return none;
  for (int attempt = 0; attempt < 2; ++attempt) {
    result.chi2 = system.try_step(step);
    if (result.chi2 < chi2 - kRounding * chi2) {
      system.accept();
      take_back_unmeasured(system, step, result);
      return result;
    }
    const bool stopped = system.stopped();
    system.reject();
    if (stopped) return none;
    for (double& entry : step) entry = -entry;
  }
  return none;
}

}  // namespace boxplus
