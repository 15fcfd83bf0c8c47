// SPDX-License-Identifier: BSD-3-Clause
#include "io/bal/bal_from_model.h"

#include <fmt/format.h>

#include <unordered_map>

#include "boxplus/base/error.h"
#include "io/bal/bal_format.h"
#include "io/bal/bal_pose.h"
#include "io/model/axes.h"
#include "io/model/model_graph.h"
#include "io/written_errors.h"

namespace boxplus {
namespace {

/// A camera whose pixels are relative to the center, which is at (cx, cy).
struct CenteredCamera {
  BalCamera camera;
  double cx = 0, cy = 0;
  const SparseModel::Camera* in_model = nullptr;
};

CenteredCamera centered(const SparseModel::Camera& camera) {
  const std::vector<double>& k = camera.parameters;
  if (camera.model == "SIMPLE_PINHOLE") return {BalCamera(k[0], 0, 0), k[1], k[2]};
  if (camera.model == "PINHOLE" && k[0] == k[1]) return {BalCamera(k[0], 0, 0), k[2], k[3]};
  if (camera.model == "SIMPLE_RADIAL") return {BalCamera(k[0], k[3], 0), k[1], k[2]};
  if (camera.model == "RADIAL") return {BalCamera(k[0], k[3], k[4]), k[1], k[2]};
  throw InvalidArgument(
      fmt::format("cannot write BAL's .bal: camera {}: expected SIMPLE_PINHOLE, PINHOLE with fx = fy, "
                  "SIMPLE_RADIAL or RADIAL, got {}",
                  camera.id, camera.model));
}

}  // namespace

GraphFile bal_from_model(const SparseModel& model) {
  GraphFile file;
  std::unordered_map<std::uint32_t, CenteredCamera> cameras;
  for (const SparseModel::Camera& camera : model.cameras) {
    CenteredCamera& entry = cameras[camera.id] = centered(camera);
    entry.in_model = &camera;
  }
  std::vector<VertexHandle<BalVertex>> images;
  for (const SparseModel::Image& image : model.images) {
    images.push_back(
        file.graph.add_vertex(BalVertex(with_turned_axes(pose_of(image)), cameras.at(image.camera).camera)));
  }
  std::unordered_map<std::uint64_t, VertexHandle<Vector3>> points;
  for (const SparseModel::Point& point : model.points)
    points[point.id] = file.graph.add_vertex(Vector3(point.position.data()));
  for (std::size_t i = 0; i < images.size(); ++i) {
    const CenteredCamera& camera = cameras.at(model.images[i].camera);
    const SE3 pose = pose_of(model.images[i]);
    const BalVertex written(BalPose(with_turned_axes(pose)).T_world_camera(), camera.camera);
    for (const SparseModel::Feature& feature : model.images[i].features) {
      if (feature.point == SparseModel::Feature::kNoPoint) continue;
      const BalEdge edge(Vector2(feature.pixel[0] - camera.cx, camera.cy - feature.pixel[1]));
      const auto point = points.at(feature.point);
      const Vector3& estimate = file.graph.estimate(point);
      require_equal_error("BAL's .bal", {"image", model.images[i].id, static_cast<Id>(feature.point)},
                          error_of(*camera.in_model, pose, feature, estimate), edge.error(written, estimate));
      file.edges.push_back(file.graph.add_edge(edge, images[i], point));
    }
  }
  return file;
}

}  // namespace boxplus
