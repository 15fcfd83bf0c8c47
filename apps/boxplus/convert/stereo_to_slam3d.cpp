// SPDX-License-Identifier: BSD-3-Clause
#include "convert/stereo_to_slam3d.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "boxplus/types/ba.h"
#include "boxplus/types/slam3d.h"
#include "convert/replace_vertices.h"

namespace boxplus::app {
namespace {

using MountedCamera = Product<SE3, PinholeCamera>;

class StereoToSlam3d {
 public:
  explicit StereoToSlam3d(GraphFile& file) : graph_(file.graph), replacement_(file) {}

  void run() {
    if (!replacement_.is_needed())
      throw InvalidArgument("--to slam3d: expected stereo cameras (VERTEX_CAM), got none");
    replacement_.add_vertices([](const StereoPose& camera) { return camera.pose; });
    replacement_.replace_edges(
        "--to slam3d: expected EDGE_PROJECT_P2SC, EDGE_PROJECT_P2MC and EDGE_CAM as edges of VERTEX_CAM",
        [this](EdgeRef edge) { return replace(edge); });
  }

 private:
  std::optional<EdgeRef> replace(EdgeRef edge) {
    if (is_edge<PointImage<3>, Vector3, StereoPose>(graph_, edge)) return replace_stereo(edge);
    if (is_edge<PointImage<2>, Vector3, StereoPose>(graph_, edge)) return replace_mono(edge);
    if (!is_edge<CameraBetween, StereoPose, StereoPose>(graph_, edge)) return std::nullopt;
    const std::vector<VertexRef> cameras = graph_.vertices(edge);
    const SE3 motion = graph_.measurement(EdgeHandle<CameraBetween>{edge}).measurement;
    return graph_.add_edge(Between(motion), omega(edge), replacement_.new_vertex(cameras[0]),
                           replacement_.new_vertex(cameras[1]));
  }

  EdgeRef replace_stereo(EdgeRef edge) {
    const std::vector<VertexRef> ends = graph_.vertices(edge);  // the point, the camera
    const StereoIntrinsics& intrinsics = intrinsics_of(ends[1]);
    const double bf = intrinsics.parameters[0] * intrinsics.baseline;
    const Vector3 z = graph_.measurement(EdgeHandle<PointImage<3>>{edge}).measurement;
    const double inverse_depth = (z[0] - z[2]) / bf;
    if (!std::isfinite(inverse_depth)) {
      throw InvalidArgument(fmt::format(
          "--to slam3d: expected cameras with fx · baseline ≠ 0, got {} · {} for an EDGE_PROJECT_P2SC",
          intrinsics.parameters[0], intrinsics.baseline));
    }
    Eigen::Matrix3d J = Eigen::Matrix3d::Identity();
    J(2, 0) = 1;
    J(2, 2) = -bf;
    return add_disparity(Vector3(z[0], z[1], inverse_depth), J.transpose() * omega(edge) * J, ends);
  }

  EdgeRef replace_mono(EdgeRef edge) {
    const Vector2 z = graph_.measurement(EdgeHandle<PointImage<2>>{edge}).measurement;
    Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
    information.topLeftCorner<2, 2>() = omega(edge);
    return add_disparity(Vector3(z[0], z[1], 0), information, graph_.vertices(edge));
  }

  EdgeRef add_disparity(const Vector3& z, Eigen::Matrix3d information, const std::vector<VertexRef>& ends) {
    information = (0.5 * (information + information.transpose())).eval();  // exactly symmetric
    return graph_.add_edge(DisparityImage(z), information, replacement_.new_vertex(ends[1]),
                           graph_.typed<Vector3>(ends[0]), parameter_of(intrinsics_of(ends[1])));
  }

  const StereoIntrinsics& intrinsics_of(VertexRef camera) const {
    return graph_.estimate(graph_.typed<StereoPose>(camera)).intrinsics;
  }
  Eigen::MatrixXd omega(EdgeRef edge) const { return graph_.information(edge).matrix(); }

  /// The parameter with these fx, fy, cx and cy.
  VertexHandle<MountedCamera> parameter_of(const StereoIntrinsics& intrinsics) {
    const Vector<double, 4>& p = intrinsics.parameters;
    const std::array key{p[0], p[1], p[2], p[3]};
    auto found = parameters_.find(key);
    if (found == parameters_.end()) {
      const MountedCamera camera(SE3(), PinholeCamera(p[0], p[1], p[2], p[3]));
      found = parameters_.emplace(key, graph_.add_parameter(camera)).first;
    }
    return found->second;
  }

  Graph& graph_;
  VertexReplacement<StereoPose, SE3> replacement_;
  std::map<std::array<double, 4>, VertexHandle<MountedCamera>> parameters_;
};

}  // namespace

void stereo_to_slam3d(GraphFile& file) {
  StereoToSlam3d(file).run();
}

}  // namespace boxplus::app
