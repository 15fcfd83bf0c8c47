// SPDX-License-Identifier: BSD-3-Clause
// Point-to-plane ICP: one pose, and many measurements of this pose with one row each. The problem consists of
// plain arrays, so that boxplus, Ceres and the handwritten loop can build their own objects from it.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace boxplus::bench {

/// A measurement: the point p in the body frame lies on the plane through q with the unit normal n. For the
/// pose T, the error is e = nᵀ (T p − q).
struct Match {
  std::array<double, 3> p, q, n;
};

struct IcpProblem {
  std::array<double, 7> start;  ///< the initial pose: x y z qx qy qz qw
  std::vector<Match> matches;
};

/// Makes a problem with `count` noisy points on the walls of a room. The true pose differs from
/// IcpProblem::start.
IcpProblem make_icp_problem(std::size_t count);

/// The median CPU seconds of an iteration, and the final chi2.
struct IcpRun {
  double iteration_s = 0, chi2 = 0;
};

inline constexpr int kIcpIterations = 6;

/// Returns the CPU seconds that this thread has used.
double thread_seconds();

/// `marks` are the CPU times at the ends of the iterations. Returns the median time between two marks. The
/// time between the first two is not counted, because the first iterations also touch new memory.
double median_iteration(const std::vector<double>& marks);

}  // namespace boxplus::bench
