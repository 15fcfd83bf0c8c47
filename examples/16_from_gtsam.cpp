// SPDX-License-Identifier: BSD-3-Clause
// A program for GTSAM, rewritten for boxplus: keys, factors, noise models, a robust loss, marginal
// covariances.
#include <boxplus/boxplus.h>
#include <boxplus/robust/huber.h>

#include <Eigen/LU>
#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

using namespace boxplus;

// [noise]
/// Replaces noiseModel::Diagonal::Sigmas. Ω contains the inverse variances.
template <std::size_t N>
Information sigmas(std::array<double, N> values) {
  for (double& value : values) value = 1 / (value * value);
  return Information::diagonal(values);
}

/// Replaces noiseModel::Gaussian::Covariance: converts the covariance of a Pose3 to Ω of an SE3. The tangent
/// of Pose3 is (ω, t) with ω in radians. The tangent of SE3 is (t, ω/2).
Matrix<double, 6, 6> omega_of_se3(const Matrix<double, 6, 6>& covariance_of_pose3) {
  const Matrix<double, 6, 6> omega = covariance_of_pose3.inverse();
  Matrix<double, 6, 6> D = Matrix<double, 6, 6>::Zero();  // (ω, t) = D (t, ω/2)
  D.topRightCorner<3, 3>() = 2 * Matrix<double, 3, 3>::Identity();
  D.bottomLeftCorner<3, 3>().setIdentity();
  return D.transpose() * omega * D;
}
// [/noise]

/// For errors of a few millimeters and milliradians, the chi2 of SE3 equals the chi2 of Pose3 to first order.
bool weighs_as_in_gtsam() {
  const Vector3 omega(0.002, -0.003, 0.001), t(0.004, 0.001, -0.002);
  const SE3 error(t, SE3::Quaternion{omega[0] / 2, omega[1] / 2, omega[2] / 2, 1});
  Matrix<double, 6, 6> root = Matrix<double, 6, 6>::Identity();
  for (int i = 0; i < 6; ++i) root(i, (i + 2) % 6) += 0.3 * i;
  const Matrix<double, 6, 6> covariance = root.transpose() * root;
  Vector<double, 6> logarithm;
  logarithm << omega, t;
  const double expected = logarithm.dot(covariance.inverse() * logarithm);

  Graph graph;
  const auto pose = graph.add_vertex(error);
  const auto edge = graph.add_edge(Prior(SE3()), omega_of_se3(covariance), pose);
  std::printf("Pose3: chi2 is %.3f times the chi2 of GTSAM\n", graph.chi2(edge) / expected);
  return std::abs(graph.chi2(edge) / expected - 1) < 0.01;
}

int main() {
  // [graph]
  Graph graph;  // NonlinearFactorGraph and Values in one
  const auto odometry_noise = sigmas<3>({0.2, 0.2, 0.1});
  std::vector<VertexHandle<SE2>> x;
  for (Id key = 1; key <= 5; ++key)
    x.push_back(
        graph.add_vertex(SE2(1.8 * static_cast<double>(key), 0.3, 0), key));  // Values::insert(key, …)

  graph.add_edge(Prior(SE2(0, 0, 0)), sigmas<3>({0.3, 0.3, 0.1}), x[0]);  // PriorFactor<Pose2>
  for (std::size_t i = 1; i < x.size(); ++i)
    graph.add_edge(Between(SE2(2, 0, i == 1 ? 0 : kPi / 2)), odometry_noise, x[i - 1],
                   x[i]);  // BetweenFactor
  const auto closure = graph.add_edge(Between(SE2(2, 0, kPi / 2)), odometry_noise, x[4], x[1]);
  graph.set_kernel(closure, Huber(1.345));  // noiseModel::Robust with mEstimator::Huber(1.345)

  Options options;
  options.start = Start::kAutomatic;               // because the initial estimates are poor
  const Report report = optimize(graph, options);  // LevenbergMarquardtOptimizer(graph, initial).optimize()
  const SE2 last = graph.estimate(graph.vertex<SE2>(5));  // result.at<Pose2>(5)
  // [/graph]
  std::printf("%s: chi2 %.3f; x5 is at (%.2f, %.2f)\n", report.converged() ? "converged" : "stopped",
              report.chi2_final, last.x(), last.y());

  // [marginals]
  const Covariance marginals = covariance(graph, {x[1]});  // Marginals(graph, result).marginalCovariance(2)
  const Eigen::Matrix3d of_x2 = marginals.of(x[1]);        // in the frame of x2, as in GTSAM
  // [/marginals]
  std::printf("standard deviations of x2: %.2f m forward, %.2f rad\n", std::sqrt(of_x2(0, 0)),
              std::sqrt(of_x2(2, 2)));
  const bool is_found = report.converged() && std::abs(last.x() - 2) < 1e-6 && std::abs(last.y() - 2) < 1e-6;
  return is_found && weighs_as_in_gtsam() ? 0 : 1;
}
