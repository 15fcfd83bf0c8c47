// SPDX-License-Identifier: BSD-3-Clause
// A program for Ceres, rewritten for boxplus: residuals, a loss function, constant parameter blocks, and the
// information matrix of a relative pose.
#include <boxplus/boxplus.h>
#include <boxplus/robust/redescending.h>

#include <cmath>
#include <cstdio>

using namespace boxplus;

// [residual]
/// y = exp(m x + c). In Ceres, this is the functor of an AutoDiffCostFunction<ExponentialResidual, 1, 1, 1>.
struct ExponentialResidual {
  double x, y;

  template <class M, class C>
  auto error(const M& m, const C& c) const {
    using std::exp;
    return exp(m * x + c) - y;  // returned instead of written to residual[0]
  }
};
// [/residual]

/// Samples of y = exp(0.3 x + 0.1) with noise. Every sixth sample is an outlier, too large by 4.
double sample(double x, int i) {
  return std::exp(0.3 * x + 0.1) + 0.2 * std::sin(37.0 * i) + (i % 6 == 2 ? 4 : 0);
}

// [omega]
/// Converts an information matrix for Ceres' example pose_graph_3d to the information matrix of Between(z).
/// The residual of the example is
///   [R_aᵀ(p_b − p_a) − t_z; 2 vec(q_z q_ab*)] = A e,  A = [R_z 0; 0 −2 R_z].
/// Here e is the error of Between(z): the translation t and the vector part q_v of the quaternion of z⁻¹ a⁻¹
/// b. e is in the frame at the end of z, and q_v is half of the rotation vector if the rotation is small.
Matrix<double, 6, 6> omega_of_between(const SE3& z, const Matrix<double, 6, 6>& omega) {
  Matrix<double, 6, 6> A = Matrix<double, 6, 6>::Zero();
  A.topLeftCorner<3, 3>() = z.rotation();
  A.bottomRightCorner<3, 3>() = -2 * z.rotation();
  return A.transpose() * omega * A;
}
// [/omega]

/// The residual of pose_graph_3d, as the documentation of Ceres defines it.
Vector<double, 6> ceres_residual(const SE3& z, const SE3& a, const SE3& b) {
  const SE3 motion = a.inverse_times(b);
  const SE3::Quaternion q = z.quaternion() * motion.quaternion().conjugate();
  Vector<double, 6> residual;
  residual << motion.translation() - z.translation(), 2 * q.x, 2 * q.y, 2 * q.z;
  return residual;
}

bool weighs_as_in_ceres() {
  const SE3 a(Vector3(1, 2, 3), SE3::Quaternion{0.1, 0.2, 0.3, 0.9}),
      z(Vector3(2, 0, 1), SE3::Quaternion{0.4, -0.1, 0.2, 0.8}),
      error(Vector3(0.3, -0.1, 0.2), SE3::Quaternion{0.05, 0.1, -0.02, 1});
  const SE3 b = a * z * error;
  Matrix<double, 6, 6> root = Matrix<double, 6, 6>::Identity();
  for (int i = 0; i < 6; ++i) root(i, (i + 2) % 6) += 0.3 * i;
  const Matrix<double, 6, 6> omega = root.transpose() * root;

  Graph graph;
  const auto from = graph.add_vertex(a), to = graph.add_vertex(b);
  const auto edge = graph.add_edge(Between(z), omega_of_between(z, omega), from, to);
  const Vector<double, 6> residual = ceres_residual(z, a, b);
  const double expected = residual.dot(omega * residual);
  std::printf("relative pose: chi2 %.6f; in Ceres, 2 * cost = %.6f\n", graph.chi2(edge), expected);
  return std::abs(graph.chi2(edge) - expected) < 1e-9 * expected;
}

int main() {
  // [problem]
  Graph graph;                           // ceres::Problem
  const auto m = graph.add_vertex(0.0);  // a parameter block, with its initial value
  const auto c = graph.add_vertex(0.0);
  const double sigma = 0.2;  // standard deviation of the noise; a Ceres program divides the residual by it
  for (int i = 0; i < 40; ++i) {
    const double x = 0.125 * i;
    const auto edge = graph.add_edge(ExponentialResidual{x, sample(x, i)}, 1 / (sigma * sigma), m, c);
    graph.set_kernel(edge, Cauchy(2.5));  // new CauchyLoss(2.5) for the residual divided by sigma
  }

  Options options;  // ceres::Solver::Options
  options.algorithm = AlgorithmKind::kLevenbergMarquardt;
  options.max_iterations = 50;
  const Report report = optimize(graph, options);  // ceres::Solve(); Report is the Summary
  std::printf("%s: m %.2f, c %.2f\n", report.converged() ? "converged" : "stopped", graph.estimate(m),
              graph.estimate(c));
  // [/problem]

  // [constant]
  graph.fix(c);  // SetParameterBlockConstant(); unfix() is SetParameterBlockVariable()
  graph.set_estimate(c, 0.1);
  const bool is_held = optimize(graph, options).converged();
  // [/constant]
  std::printf("with c = 0.1: m %.2f\n", graph.estimate(m));
  const bool is_found = report.converged() && is_held && std::abs(graph.estimate(m) - 0.3) < 0.02;
  return weighs_as_in_ceres() && is_found ? 0 : 1;
}
