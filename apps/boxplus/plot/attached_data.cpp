// SPDX-License-Identifier: BSD-3-Clause
#include "plot/attached_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <unordered_map>
#include <variant>

#include "boxplus/base/error.h"
#include "boxplus/io/data.h"
#include "command_line/message.h"
#include "plot/ellipses.h"

namespace boxplus::app {
namespace {

/// The frame of a vertex that data is attached to.
struct Place {
  detail::Frame frame;
  double time = 0;  ///< the time of a pose, in [0, 1]
};

std::unordered_map<Id, Place> places_of(const Graph& graph) {
  std::unordered_map<Id, Place> places;
  std::size_t poses = 0;
  for (const VertexRef& vertex : graph.all_vertices()) {
    Place place;
    if (!graph.vertex_pools()[vertex.pool]->get_frame(vertex.slot, place.frame)) continue;
    place.time = static_cast<double>(poses);
    poses += place.frame.has_rotation;
    places.emplace(graph.id(vertex), place);
  }
  for (auto& [id, place] : places) place.time /= static_cast<double>(std::max<std::size_t>(2, poses) - 1);
  return places;
}

/// The rotation of a frame as a matrix; the identity if the vertex is a point.
Eigen::MatrixXd rotation_of(const detail::Frame& frame) {
  if (!frame.has_rotation) return Eigen::MatrixXd::Identity(frame.dimension, frame.dimension);
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  return Eigen::Map<const RowMajor>(frame.rotation.data(), frame.dimension, frame.dimension);
}

class DataPainter {
 public:
  DataPainter(Scene& scene, const Graph& graph, const View& view)
      : scene_(scene), view_(view), places_(places_of(graph)) {}

  void add(Id vertex, const Data& data) {
    const auto found = places_.find(vertex);
    if (found == places_.end()) return;
    place_ = &found->second;
    rotation_ = rotation_of(place_->frame);
    std::visit([this](const auto& each) { add(each); }, data);
  }

 private:
  void add(const RobotLaser& laser) { add_scan(laser.end_points_of_robot()); }
  void add(const RawLaser& laser) { add_scan(laser.end_points()); }

  void add_scan(const std::vector<Vector<double, 2>>& end_points) {
    ++scene_.scans;
    for (const Vector<double, 2>& point : end_points) {
      const Spot spot = spot_of({point[0], point[1], 0});
      if (enclose(spot)) scene_.scan_points.push_back(spot);
    }
  }

  void add(const VertexTag& tag) {
    const Spot spot = spot_of(tag.position);
    if (enclose(spot)) scene_.labels.push_back({spot, escaped(tag.name)});
  }

  void add(const VertexEllipse& ellipse) {
    const int dimension = place_->frame.dimension;
    Eigen::MatrixXd of_body = Eigen::MatrixXd::Zero(dimension, dimension);
    of_body.topLeftCorner<2, 2>() = ellipse.covariance.topLeftCorner<2, 2>();
    scene_.has_ellipses = true;
    scene_.ellipses.push_back(
        ellipse_of(place_->frame, rotation_ * of_body * rotation_.transpose(), view_, place_->time));
    const Spot center = spot_of({});
    for (const Vector<double, 2>& point : ellipse.matching_vertices) {
      const Spot spot = spot_of({point[0], point[1], 0});
      if (enclose(spot)) scene_.matches.push_back({center, spot});
    }
  }

  /// The place in the picture of a point in the frame of the vertex. Points of the plane have no height.
  Spot spot_of(const std::array<double, 3>& point) const {
    const int dimension = place_->frame.dimension;
    std::array<double, 3> in_world = place_->frame.translation;
    for (int row = 0; row < dimension; ++row) {
      for (int column = 0; column < dimension; ++column)
        in_world[row] += rotation_(row, column) * point[column];
    }
    return project(in_world, dimension, view_);
  }

  /// Enlarges the scene. Returns false if the spot is too far away to be drawn.
  bool enclose(const Spot& spot) {
    constexpr double kFarthest = 1e100;  // small enough that no sum or square of lengths overflows
    if (!(std::abs(spot[0]) + std::abs(spot[1]) + std::abs(spot[2]) < kFarthest)) return false;
    for (std::size_t i = 0; i < 3; ++i) {
      scene_.low[i] = std::min(scene_.low[i], spot[i]);
      scene_.high[i] = std::max(scene_.high[i], spot[i]);
    }
    return true;
  }

  Scene& scene_;
  const View& view_;
  std::unordered_map<Id, Place> places_;
  const Place* place_ = nullptr;
  Eigen::MatrixXd rotation_;
};

/// Returns no value if the line is no data, or is malformed and `lenient` is true.
std::optional<Data> data_of(const GraphFile::KeptLine& line, const std::string& name, bool lenient) {
  try {
    return parse_data(line, name);
  } catch (const InputError& error) {
    if (!lenient) throw;
    print_message(fmt::format("skipped: {}", error.what()));
    return {};
  }
}

}  // namespace

void add_data(Scene& scene, const GraphFile& file, const View& view, const std::string& name, bool lenient) {
  const auto is_of_vertex = [](const GraphFile::KeptLine& line) {
    return line.place == GraphFile::KeptLine::Place::kAfterVertex && !data_tag_of(line.text).empty();
  };
  if (std::none_of(file.kept.begin(), file.kept.end(), is_of_vertex)) return;
  DataPainter painter(scene, file.graph, view);
  for (const GraphFile::KeptLine& line : file.kept) {
    if (!is_of_vertex(line)) continue;
    if (const std::optional<Data> data = data_of(line, name, lenient)) painter.add(line.after, *data);
  }
  enclose_ellipses(scene);
}

}  // namespace boxplus::app
