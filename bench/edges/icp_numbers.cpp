// SPDX-License-Identifier: BSD-3-Clause
#include "edges/icp_numbers.h"

#include <time.h>

#include <cmath>
#include <random>

#include "boxplus/manifold/se3.h"
#include "datasets/median.h"

namespace boxplus::bench {

IcpProblem make_icp_problem(std::size_t count) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::normal_distribution<double> noise(0, 0.01);
  const double delta[6] = {0.3, -0.2, 0.1, 0.05, -0.03, 0.08};
  const SE3 start(Vector3(1, 2, 0.5), detail::Quaternion<double>{0.1, -0.2, 0.3, 0.9});
  const SE3 truth = Manifold<SE3>::oplus(start, delta);
  IcpProblem problem;
  const auto vector = start.vector();
  for (std::size_t k = 0; k < 7; ++k) problem.start[k] = vector[static_cast<Eigen::Index>(k)];
  for (std::size_t k = 0; k < count; ++k) {
    Vector3 n(0, 0, 0), q(5 * uniform(random), 5 * uniform(random), 5 * uniform(random));
    const auto wall = static_cast<Eigen::Index>(k % 3);
    n[wall] = k % 2 == 0 ? 1 : -1;
    q[wall] = 5 * n[wall];
    const Vector3 p = truth.inverse_times(Vector3(q + noise(random) * n));
    problem.matches.push_back({{p[0], p[1], p[2]}, {q[0], q[1], q[2]}, {n[0], n[1], n[2]}});
  }
  return problem;
}

double thread_seconds() {
  timespec time;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

double median_iteration(const std::vector<double>& marks) {
  std::vector<double> seconds;
  for (std::size_t k = 2; k < marks.size(); ++k) seconds.push_back(marks[k] - marks[k - 1]);
  return seconds.empty() ? 0 : median(seconds);
}

}  // namespace boxplus::bench
