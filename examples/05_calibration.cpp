// SPDX-License-Identifier: BSD-3-Clause
// Calibration: estimates the pose at which a laser scanner is mounted on a robot, while the robot drives.
// Each measurement of the scanner is an edge with three vertices.
//
// The odometry measures the motion of the robot; the scan matcher measures the motion of the scanner. The two
// measurements agree only if the pose of the scanner on the robot is right. An edge may connect any number of
// vertices, of any types.
#include <boxplus/boxplus.h>

#include <cstdio>

using namespace boxplus;

// [hyper_edge]
/// The measured motion of a scanner while the robot drives from pose a to pose b. The scanner is mounted on
/// the robot at pose `mount`.
struct ScanMatch {
  SE2 measurement;

  template <class Pose>
  auto error(const Pose& a, const Pose& b, const Pose& mount) const {
    const Pose motion = (a * mount).inverse_times(b * mount);
    return measurement.inverse_times(motion).vector();
  }
};
// [/hyper_edge]

int main() {
  const SE2 true_mount(0.25, -0.1, 0.3);

  Graph graph;
  const auto mount = graph.add_vertex(SE2(0, 0, 0));  // the initial guess of an unknown pose
  auto last = graph.add_vertex(SE2(0, 0, 0));
  graph.fix(last);
  for (int step = 0; step < 20; ++step) {
    const SE2 motion(0.5, 0, step % 7 < 3 ? 0.4 : -0.2);  // only turns make the scanner's position observable
    const auto next = graph.add_vertex(graph.estimate(last) * motion);
    graph.add_edge(Between(motion), 100.0, last, next);
    graph.add_edge(ScanMatch{true_mount.inverse() * motion * true_mount}, 400.0, last, next, mount);
    last = next;
  }

  const Report report = optimize(graph);
  const SE2& found = graph.estimate(mount);
  std::printf("the scanner is mounted at (%.3f, %.3f) m, turned by %.3f rad\n", found.x(), found.y(),
              found.theta());
  return report.converged() && (found.vector() - true_mount.vector()).norm() < 1e-6 ? 0 : 1;
}
