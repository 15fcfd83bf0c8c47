// SPDX-License-Identifier: BSD-3-Clause
// How certain are the estimates? Computes covariances of poses and landmarks, and tests whether they are
// correct.
#include <boxplus/boxplus.h>
#include <boxplus/types/slam2d.h>

#include <Eigen/Dense>
#include <cmath>
#include <cstdio>
#include <random>
#include <vector>

using namespace boxplus;

/// A simulated drive along an arc. The robot sees a tree twice. The noise of each measurement has the
/// covariance Ω⁻¹ of its edge.
struct Drive {
  static constexpr int kSteps = 20;
  static constexpr double kStepSigma = 0.05, kTurnSigma = 0.02, kSightSigma = 0.1;  // m, rad, m
  const SE2 step = SE2(1, 0, 0.05);
  const Vector2 true_tree = Vector2(10, 5);

  Graph graph;
  bool converged = false;
  VertexHandle<SE2> robot;  // the last pose
  VertexHandle<Vector2> tree;
  SE2 true_robot;

  explicit Drive(unsigned seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    const auto noise = [&](double sigma) { return sigma * normal(random); };
    const double step_information = 1 / (kStepSigma * kStepSigma),
                 turn_information = 1 / (kTurnSigma * kTurnSigma);
    const double sight_information = 1 / (kSightSigma * kSightSigma);
    robot = graph.add_vertex(SE2());
    graph.fix(robot);  // the first pose: all other estimates are relative to it
    tree = graph.add_vertex(true_tree);
    for (int k = 1; k <= kSteps; ++k) {
      const SE2 measured = step * SE2(noise(kStepSigma), noise(kStepSigma), noise(kTurnSigma));
      const auto next = graph.add_vertex(graph.estimate(robot) * measured);
      graph.add_edge(Between(measured),
                     Information::diagonal(std::vector{step_information, step_information, turn_information}),
                     robot, next);
      robot = next;
      true_robot = true_robot * step;
      if (k != 6 && k != 15) continue;
      const Vector2 sight =
          true_robot.inverse_times(true_tree) + Vector2(noise(kSightSigma), noise(kSightSigma));
      graph.add_edge(PointObservation2(sight), sight_information, robot, tree);
    }
    converged = optimize(graph).converged();
  }
};

int main() {
  const Drive drive(1);
  const Graph& graph = drive.graph;
  const auto robot = drive.robot;
  const auto tree = drive.tree;
  // [covariance]
  const Covariance sigma = covariance(graph, {robot, tree});
  if (!sigma.ok()) {  // for example if a vertex is undetermined; the message names the vertex
    std::printf("%s\n", sigma.message().c_str());
    return 1;
  }
  const Eigen::Matrix3d of_robot = sigma.of(robot);      // x, y, heading in the frame of the robot
  const Eigen::Matrix2d of_tree = sigma.of(tree);        // x, y in the world frame
  const Eigen::MatrixXd across = sigma.of(robot, tree);  // 3 × 2: the cross-covariance
  const Eigen::MatrixXd joint = sigma.joint();           // 5 × 5: robot and tree, with the cross-covariance
  // [/covariance]
  std::printf("standard deviations of the robot: %.2f m forward, %.2f m sideways, %.1f degrees\n",
              std::sqrt(of_robot(0, 0)), std::sqrt(of_robot(1, 1)), std::sqrt(of_robot(2, 2)) * 180 / kPi);

  // [world]
  const Matrix<double, 2, 2> R =
      graph.estimate(robot).rotation();  // rotates vectors from the robot's frame to the world frame
  const Eigen::Matrix2d robot_in_world = R * of_robot.topLeftCorner<2, 2>() * R.transpose();
  // [/world]
  // [ellipse]
  // The ellipse that contains the tree with 95 % probability: its half-axes are √5.991 standard deviations.
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(of_tree);
  const Eigen::Vector2d half_axes = (5.991 * axes.eigenvalues()).cwiseSqrt();
  // [/ellipse]
  std::printf("the tree lies in an ellipse with half-axes %.2f m and %.2f m\n", half_axes[1], half_axes[0]);

  // [difference]
  // How certain is the position of the tree relative to the robot? The errors of the tree and of the robot
  // are similar, so they mostly cancel.
  Graph look = graph;  // handles of a graph are valid for its copies, too
  const auto edge = look.add_edge(PointObservation2(Vector2(0, 0)), robot, tree);
  Eigen::MatrixXd J(2, 5);
  J << look.jacobian(edge)[0], look.jacobian(edge)[1];
  const Eigen::Matrix2d seen_from_robot = J * joint * J.transpose();
  // [/difference]
  std::printf("variances (m²): tree %.3f, robot %.3f, the tree relative to the robot %.3f\n", of_tree.trace(),
              robot_in_world.trace(), seen_from_robot.trace());

  // Are the covariances correct? If they are, the truth is inside the 95 % ellipsoid in about 95 of 100
  // drives.
  constexpr int kDrives = 1000;
  int robots = 0, trees = 0;
  for (unsigned seed = 1; seed <= kDrives; ++seed) {
    const Drive other(seed);
    const Covariance of_other = covariance(other.graph, {other.robot, other.tree});
    double delta[3];
    Manifold<SE2>::ominus(other.true_robot, other.graph.estimate(other.robot), delta);
    const Eigen::Vector3d d(delta[0], delta[1], delta[2]);
    robots +=
        d.dot(of_other.of(other.robot).inverse() * d) < 7.815;  // 95 % quantile of chi2, 3 degrees of freedom
    const Eigen::Vector2d e = other.true_tree - other.graph.estimate(other.tree);
    trees += e.dot(of_other.of(other.tree).inverse() * e) < 5.991;
  }
  const double robot_share = 100.0 * robots / kDrives, tree_share = 100.0 * trees / kDrives;
  std::printf(
      "drives (of %d) with the truth inside the 95 %% bound: %.1f %% for the robot, %.1f %% for the tree\n",
      kDrives, robot_share, tree_share);
  const bool is_right = std::abs(robot_share - 95) < 2.5 && std::abs(tree_share - 95) < 2.5;
  const bool is_joint = joint.topRightCorner(3, 2) == across && seen_from_robot.trace() < of_tree.trace();
  return drive.converged && is_right && is_joint ? 0 : 1;
}
