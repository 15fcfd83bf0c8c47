// SPDX-License-Identifier: BSD-3-Clause
// Point-to-plane ICP: one pose, and many measurements of one row that all share it. The problem is stored in
// plain arrays, from which every contestant builds its own objects.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace boxplus::bench {

/// Point p of the body lies on the plane through q with the unit normal n: e = nᵀ (T p − q).
struct Match {
  std::array<double, 3> p, q, n;
};

struct IcpProblem {
  std::array<double, 7> start;  ///< x y z qx qy qz qw
  std::vector<Match> matches;
};

/// `count` points on the walls of a room, seen from a pose at some distance from the start, with noise.
IcpProblem make_icp_problem(std::size_t count);

/// One run: CPU seconds of the median iteration without the first, and chi2 after the last.
struct IcpRun {
  double iteration_s = 0, chi2 = 0;
};

inline constexpr int kIcpIterations = 6;

/// The CPU seconds that this thread has used.
double thread_seconds();

/// The median of the times between the marks, without the first, which includes planning and fresh memory.
double median_iteration(const std::vector<double>& marks);

}  // namespace boxplus::bench
