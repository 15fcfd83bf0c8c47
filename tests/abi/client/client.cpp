// SPDX-License-Identifier: BSD-3-Clause
// A client with custom types. Their layout depends on the alignment that Eigen uses. Templates of the library
// store and change objects of these types.
#include <Eigen/Geometry>
#include <cmath>
#include <cstdio>
#include <type_traits>
#include <vector>

#include "boxplus/base/error.h"
#include "boxplus/base/parallel.h"
#include "boxplus/covariance/covariance.h"
#include "boxplus/manifold/convert_to.h"
#include "boxplus/optimize/optimizer.h"

/// A vertex type whose layout depends on the alignment that Eigen uses.
struct Mount {
  int id;
  Eigen::Vector4d offset;
  bool active;
};

template <>
struct boxplus::Manifold<Mount> {
  static constexpr int kDim = 4;
  static Mount oplus(const Mount& x, const double* delta) {
    return {x.id, x.offset + Eigen::Map<const Eigen::Vector4d>(delta), x.active};
  }
  static void ominus(const Mount& y, const Mount& x, double* delta) {
    Eigen::Map<Eigen::Vector4d>{delta} = y.offset - x.offset;
  }
};

namespace {

struct Camera {
  int id;
  Eigen::Isometry3d T_world_camera;
  bool active;
};

struct Plane {
  int id;
  Eigen::Vector4d coefficients;
  bool active;
};

#if EIGEN_MAX_ALIGN_BYTES == 16
static_assert(sizeof(Camera) == 160 && sizeof(Plane) == 64);
#endif

/// Runs four tasks on the threads of the library. Each task fills one vector with Things, and the calling
/// thread frees the vectors. Returns true if all Things have the values that the tasks wrote.
template <class Thing, class Make>
bool fill_in_parallel(Make make) {
  std::vector<std::vector<Thing>> things(4);
  boxplus::detail::parallel_tasks(4, [&](int task) {
    for (int i = 0; i < 100; ++i) things[static_cast<std::size_t>(task)].push_back(make(i));
  });
  for (const auto& chunk : things) {
    for (int i = 0; i < 100; ++i) {
      if (chunk[static_cast<std::size_t>(i)].id != i || !chunk[static_cast<std::size_t>(i)].active)
        return false;
    }
  }
  return true;
}

bool vectors_of_eigen_structs_survive() {
  const auto camera = [](int id) { return Camera{id, Eigen::Isometry3d::Identity(), true}; };
  const auto plane = [](int id) { return Plane{id, Eigen::Vector4d::Constant(id), true}; };
  return fill_in_parallel<Camera>(camera) && fill_in_parallel<Plane>(plane);
}

bool dynamic_matrices_survive() {
  std::vector<Eigen::MatrixXd> matrices(4);
  boxplus::detail::parallel_tasks(4, [&](int i) { matrices[static_cast<std::size_t>(i)].setIdentity(7, 7); });
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(7, 7);
  for (const auto& matrix : matrices) sum += matrix;
  return sum.trace() == 28;
}

/// The optimizer of the library finds the estimates of vertices with aligned members.
bool graphs_of_eigen_structs_are_optimized() {
  boxplus::Graph graph;
  std::vector<boxplus::VertexHandle<Mount>> mounts;
  for (int i = 0; i < 50; ++i) {
    mounts.push_back(graph.add_vertex(Mount{i, Eigen::Vector4d::Zero(), true}));
    const Eigen::Vector4d target = Eigen::Vector4d::Constant(i);
    graph.add_edge([target](const Mount& x) { return boxplus::Vector<double, 4>(x.offset - target); },
                   mounts.back());
  }
  if (!boxplus::optimize(graph, {.threads = 2}).converged()) return false;
  for (const auto& mount : mounts) {
    const Mount& x = graph.estimate(mount);
    if (!x.active || (x.offset - Eigen::Vector4d::Constant(x.id)).norm() > 1e-6) return false;
  }
  return true;
}

/// Converts an isometry to a measurement, and the optimized estimate back to an isometry. Checks this
/// isometry and the covariance of the estimate.
bool conversions_survive() {
  const Eigen::Isometry3d measured = Eigen::Translation3d(1, 2, 3) * Eigen::Quaterniond(0.6, 0, 0.8, 0);
  boxplus::Graph graph;
  const auto pose = graph.add_vertex(boxplus::SE3RotationVector());
  graph.add_edge(
      [z = boxplus::convert_to<boxplus::SE3>(measured)](const auto& x) {
        const auto seen = x.inverse_times(z.translation());
        const auto turn = (x.quaternion().conjugate() * z.quaternion());
        return boxplus::Vector<std::decay_t<decltype(turn.x)>, 6>{seen[0], seen[1], seen[2],
                                                                  turn.x,  turn.y,  turn.z};
      },
      4.0, pose);
  if (!boxplus::optimize(graph, {.threads = 2}).converged()) return false;
  const auto found = boxplus::convert_to<Eigen::Isometry3d>(graph.estimate(pose));
  const Eigen::MatrixXd sigma = boxplus::covariance(graph, {pose}).of(pose);
  return found.isApprox(measured, 1e-6) && std::abs(sigma(0, 0) - 0.25) < 1e-6;
}

bool exceptions_arrive() {
  try {
    boxplus::detail::parallel_tasks(2, [](int) { throw boxplus::InvalidArgument("expected"); });
  } catch (const boxplus::InvalidArgument&) {
    return true;
  }
  return false;
}

}  // namespace

// Add a check here if clients and the library exchange objects in a new way.
int main() {
  const bool good = vectors_of_eigen_structs_survive() && dynamic_matrices_survive() &&
                    graphs_of_eigen_structs_are_optimized() && conversions_survive() && exceptions_arrive();
  std::puts(good ? "good" : "bad");
  return good ? 0 : 1;
}
