// SPDX-License-Identifier: BSD-3-Clause
// Converts poses from other libraries, and uses a pose type whose tangent has full angles. (The tangent of
// SE3 has half angles.)
#include <boxplus/boxplus.h>
#include <boxplus/manifold/convert_to.h>

#include <Eigen/Geometry>
#include <cmath>
#include <cstdio>
#include <vector>

using namespace boxplus;

int main() {
  // [measurement]
  // The output of another program: a measured motion, and its standard deviations in meters and radians.
  const Eigen::Isometry3d measured =
      Eigen::Translation3d(1, 2, 0.5) * Eigen::AngleAxisd(0.8, Eigen::Vector3d::UnitZ());
  const double sigma_t = 0.05, sigma_r = 0.02;
  // [/measurement]

  // [rotation_vector]
  // SE3RotationVector represents the same poses as SE3. Its tangent is (Δt, ω), with ω in radians.
  Graph graph;
  const auto a = graph.add_vertex(SE3RotationVector());
  const auto b = graph.add_vertex(SE3RotationVector());
  graph.fix(a);
  const double meters = 1 / (sigma_t * sigma_t), radians = 1 / (sigma_r * sigma_r);
  const auto Omega = Information::diagonal(std::vector{meters, meters, meters, radians, radians, radians});
  graph.add_edge(Between(convert_to<SE3RotationVector>(measured)), Omega, a, b);
  // [/rotation_vector]
  const bool converged = optimize(graph).converged();

  // [back]
  const auto found = convert_to<Eigen::Isometry3d>(graph.estimate(b));
  const Eigen::MatrixXd sigma = covariance(graph, {b}).of(b);
  // [/back]
  std::printf("rotation vectors: sigma of the rotation %.3f\n", std::sqrt(sigma(5, 5)));

  // [half_angles]
  // The tangent of SE3 has half angles, as in .g2o files. So the same information needs 4 / σ² for the
  // rotation.
  Graph halves;
  const auto c = halves.add_vertex(SE3());
  const auto Omega_halves =
      Information::diagonal(std::vector{meters, meters, meters, 4 * radians, 4 * radians, 4 * radians});
  halves.add_edge(Prior(convert_to<SE3>(measured)), Omega_halves, c);
  // [/half_angles]
  const bool halves_converged = optimize(halves).converged();
  const Eigen::MatrixXd sigma_halves = covariance(halves, {c}).of(c);
  std::printf("half angles:      sigma of the rotation %.3f\n", std::sqrt(sigma_halves(5, 5)));

  const bool is_found = found.isApprox(measured, 1e-9) && std::abs(std::sqrt(sigma(5, 5)) - sigma_r) < 1e-9;
  return converged && halves_converged && is_found &&
                 std::abs(std::sqrt(sigma_halves(5, 5)) - sigma_r / 2) < 1e-9
             ? 0
             : 1;
}
