// SPDX-License-Identifier: BSD-3-Clause
// Calibrates a robot from a drive: the sizes of its two driven wheels, their distance, and the pose at which
// a laser scanner is mounted. calibrate_drive() computes a start from the measurements alone; the graph then
// weights each measurement with its noise, and says how certain the result is.
#include <boxplus/boxplus.h>
#include <boxplus/types/slam2d.h>
#include <boxplus/types/slam2d/calibrate_drive.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>
#include <vector>

using namespace boxplus;

constexpr double kSlip = 0.01, kScanNoise = 0.002;  // standard deviations in m and rad
const DifferentialDrive kTrueDrive{1.04, 0.98, 0.42};
const SE2 kTrueMount(0.25, -0.1, 0.3);

/// What the encoders and the scan matcher measured while the robot drove at changing speeds.
std::vector<DriveMotion> simulated_drive() {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> speed(0, 1);
  std::normal_distribution<double> normal;
  const auto noise = [&](double sigma) {
    const double x = normal(random), y = normal(random), theta = normal(random);
    return SE2(sigma * x, sigma * y, sigma * theta);
  };
  std::vector<DriveMotion> drive;
  for (int step = 0; step < 300; ++step) {
    const double left = speed(random), right = speed(random);
    const WheelSpeeds wheels{left, right, 0.5};
    const SE2 motion = WheelOdometry(wheels).motion(kTrueDrive) * noise(kSlip);
    drive.push_back({wheels, kTrueMount.inverse() * motion * kTrueMount * noise(kScanNoise)});
  }
  return drive;
}

void print(const char* what, const DifferentialDrive& drive, const SE2& mount) {
  std::printf("%s: factors %.3f %.3f, baseline %.3f m; scanner at (%.3f, %.3f) m, turned by %.3f rad\n", what,
              drive.left_factor, drive.right_factor, drive.baseline, mount.x(), mount.y(), mount.theta());
}

int main() {
  const std::vector<DriveMotion> measured = simulated_drive();
  const auto start = calibrate_drive(measured);
  if (!start) return 1;  // a drive on a straight line does not determine all parameters
  print("start", start->drive, start->mount);

  Graph graph;
  const auto drive = graph.add_vertex(start->drive);
  const auto mount = graph.add_vertex(start->mount);
  auto last = graph.add_vertex(SE2());
  graph.fix(last);
  for (const auto& [wheels, scanner] : measured) {
    const WheelOdometry odometry(wheels);
    const auto next = graph.add_vertex(graph.estimate(last) * odometry.motion(start->drive));
    graph.add_edge(odometry, 1 / (kSlip * kSlip), last, next, drive);
    graph.add_edge(OffsetBetween<SE2>(scanner), 1 / (kScanNoise * kScanNoise), last, next, mount);
    last = next;
  }
  const Report report = optimize(graph);
  print("end", graph.estimate(drive), graph.estimate(mount));

  const Covariance certainty = covariance(graph, {drive, mount});
  const double baseline_sigma = std::sqrt(certainty.of(drive)(2, 2));
  std::printf("the baseline is certain to %.4f m; chi2 per degree of freedom is %.2f\n", baseline_sigma,
              report.chi2_per_degree());
  // The errors of all six parameters, in standard deviations.
  Vector<double, 6> errors;
  Manifold<DifferentialDrive>::ominus(graph.estimate(drive), kTrueDrive, errors.data());
  Manifold<SE2>::ominus(graph.estimate(mount), kTrueMount, errors.data() + 3);
  double worst = 0;
  for (int i = 0; i < 3; ++i) {
    worst = std::max(worst, std::abs(errors[i]) / std::sqrt(certainty.of(drive)(i, i)));
    worst = std::max(worst, std::abs(errors[i + 3]) / std::sqrt(certainty.of(mount)(i, i)));
  }
  std::printf("every parameter is within %.1f standard deviations of the truth\n", worst);
  return report.converged() && worst < 4 && std::abs(report.chi2_per_degree() - 1) < 0.2 ? 0 : 1;
}
