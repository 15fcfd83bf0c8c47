// SPDX-License-Identifier: BSD-3-Clause
// Point-to-plane ICP: one pose, and many measurements of this pose with one row each. The problem is stored
// in plain arrays, from which every contestant builds its own objects.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace boxplus::bench {

/// A measurement: point p of the body lies on the plane through q with the unit normal n. The error is
/// e = nᵀ (T p − q).
struct Match {
  std::array<double, 3> p, q, n;
};

struct IcpProblem {
  std::array<double, 7> start;  ///< the initial pose: x y z qx qy qz qw
  std::vector<Match> matches;
};

/// Makes a problem with `count` noisy points on the walls of a room. The true pose is at some distance from
/// `start`.
IcpProblem make_icp_problem(std::size_t count);

/// The figures of one run: the median CPU seconds of an iteration, without the first, and the final chi2.
struct IcpRun {
  double iteration_s = 0, chi2 = 0;
};

inline constexpr int kIcpIterations = 6;

/// Returns the CPU seconds that this thread has used.
double thread_seconds();

/// Returns the median of the times between the marks, without the first time, which includes planning and
/// fresh memory.
double median_iteration(const std::vector<double>& marks);

}  // namespace boxplus::bench
