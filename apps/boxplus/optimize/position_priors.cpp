// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/position_priors.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <Eigen/SVD>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <random>
#include <vector>

#include "base/align_points.h"
#include "boxplus/base/error.h"
#include "boxplus/io/sparse_model.h"
#include "boxplus/manifold/s2.h"
#include "boxplus/manifold/se3.h"
#include "boxplus/types/inertial/direction_observation.h"
#include "boxplus/types/offset_position_prior.h"
#include "boxplus/types/position_prior.h"
#include "files/graph_input.h"
#include "io/model/pose_places.h"
#include "optimize/priors_file.h"

namespace boxplus::app {
namespace {

/// A typed view of a pool, or nullptr.
template <class T>
const detail::TypedVertexPool<T>* pool_of(const Graph& graph, VertexRef vertex) {
  return dynamic_cast<const detail::TypedVertexPool<T>*>(graph.vertex_pools()[vertex.pool].get());
}

/// The vertices of the pose of an image: T_world_camera, or T_world_rig and T_rig_camera.
struct ImagePose {
  VertexHandle<SE3> pose;
  std::optional<VertexHandle<SE3>> offset;

  SE3 of(const Graph& graph) const {
    return offset ? graph.estimate(pose) * graph.estimate(*offset) : graph.estimate(pose);
  }
};

/// The poses of images, by their names.
class Images {
 public:
  explicit Images(const GraphFile& file) : graph_(file.graph) {
    const std::vector<PosePlace> places = pose_places(*file.model);
    for (std::size_t k = 0; k < places.size(); ++k) places_.emplace(file.model->images[k].name, places[k]);
  }
  std::optional<ImagePose> find(const std::string& name) const {
    const auto at = places_.find(name);
    if (at == places_.end()) return std::nullopt;
    const auto [id, offset] = std::pair(at->second.vertex, at->second.offset);
    const std::optional<VertexRef> vertex = graph_.find_vertex(id);
    if (!vertex || pool_of<SE3>(graph_, *vertex) == nullptr) return std::nullopt;
    ImagePose found{graph_.vertex<SE3>(id), std::nullopt};
    if (offset) found.offset = graph_.parameter<SE3>(*offset);
    return found;
  }

 private:
  const Graph& graph_;
  std::map<std::string, PosePlace> places_;
};

struct Similarity {
  double scale = 1;
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Vector3 translation = Vector3::Zero();

  Vector3 operator*(const Vector3& point) const { return scale * (rotation * point) + translation; }
  SE3 operator*(const SE3& pose) const {
    return SE3(*this * Vector3(pose.translation()),
               (Eigen::Quaterniond(rotation) * Eigen::Quaterniond(pose.rotation())).normalized());
  }
};

/// Moves all poses and points, and scales the poses of sensors on rigs.
void move(Graph& graph, const Similarity& motion) {
  std::vector<VertexRef> all = graph.all_vertices();
  for (const VertexRef& vertex : all) {
    const Id id = graph.id(vertex);
    if (pool_of<SE3>(graph, vertex) != nullptr) {
      const auto pose = graph.vertex<SE3>(id);
      graph.set_estimate(pose, motion * graph.estimate(pose));
    } else if (pool_of<Vector3>(graph, vertex) != nullptr) {
      const auto point = graph.vertex<Vector3>(id);
      graph.set_estimate(point, motion * graph.estimate(point));
    } else {
      throw InvalidArgument("--position-priors: expected a graph of poses and points in space");
    }
  }
  for (const VertexRef& parameter : graph.all_parameters()) {
    if (pool_of<SE3>(graph, parameter) == nullptr) continue;
    const auto sensor = graph.parameter<SE3>(graph.id(parameter));
    const SE3 pose = graph.estimate(sensor);
    graph.set_estimate(sensor, SE3(motion.scale * Vector3(pose.translation()), pose.quaternion()));
  }
}

struct Match {
  const ImagePriors* row;
  ImagePose pose;
};

const Vector3 kDown(0, 0, -1);

/// Positions of images in the model, turned by a rotation, and the measured ones.
struct Positions {
  Positions() = default;
  Positions(const Graph& graph, const std::vector<Match>& matches, const Eigen::Matrix3d& rotation) {
    for (const auto& [row, pose] : matches) {
      if (row->position) add(rotation * pose.of(graph).translation(), *row->position);
    }
  }
  void add(const Vector3& in_model, const Vector3& measured) {
    for (Eigen::MatrixXd* points : {&from, &to}) points->conservativeResize(3, points->cols() + 1);
    from.rightCols(1) = in_model;
    to.rightCols(1) = measured;
  }
  /// Whether they are at least three, and not on a line.
  bool determine_similarity() const {
    constexpr int kLeast = 3;
    constexpr double kFlat = 1e-3;  // the second extent, relative to the first
    if (to.cols() < kLeast) return false;
    const Eigen::VectorXd model = extents(from), world = extents(to);
    return model[1] > kFlat * model[0] && world[1] > kFlat * world[0];
  }
  /// The extents along the principal axes of a set of points, the largest one first.
  static Eigen::VectorXd extents(const Eigen::MatrixXd& points) {
    return Eigen::JacobiSVD<Eigen::MatrixXd>(points.colwise() - points.rowwise().mean()).singularValues();
  }
  Eigen::MatrixXd from{3, 0}, to{3, 0};
};

/// How far the positions of the model are from the measured ones after a motion.
struct Distances {
  Distances(const Positions& positions, const PointAlignment& motion) {
    const Eigen::MatrixXd moved =
        (motion.scale * motion.rotation * positions.from).colwise() + motion.translation;
    all = (moved - positions.to).colwise().norm();
    std::vector<double> sorted(all.begin(), all.end());
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
    std::nth_element(sorted.begin(), middle, sorted.end());
    median = *middle;
  }
  Eigen::VectorXd all;
  double median = 0;
};

/// The motion with the smallest median distance, of those that bring three positions together.
std::optional<PointAlignment> align_triples(const Positions& positions) {
  constexpr int kMostTriples = 500;
  std::mt19937 random(0);  // the same triples in every run
  std::uniform_int_distribution<Eigen::Index> any(0, positions.to.cols() - 1);
  std::optional<PointAlignment> best;
  double best_median = std::numeric_limits<double>::infinity();
  for (int k = 0; k < kMostTriples; ++k) {
    const std::array<Eigen::Index, 3> triple{any(random), any(random), any(random)};
    Positions three;
    for (const Eigen::Index i : triple) three.add(positions.from.col(i), positions.to.col(i));
    if (!three.determine_similarity()) continue;
    const PointAlignment motion = align_points(three.from, three.to, true);
    const double median = Distances(positions, motion).median;
    if (median < best_median) best_median = median, best = motion;
  }
  return best;
}

/// The similarity that brings the positions of the model closest to the measured ones, if these determine it.
/// Positions that are much farther away than most do not count.
std::optional<Similarity> from_positions(const Graph& graph, const std::vector<Match>& matches,
                                         PositionPriors& facts) {
  const Positions positions(graph, matches, Eigen::Matrix3d::Identity());
  if (!positions.determine_similarity()) return std::nullopt;
  PointAlignment found = align_triples(positions).value_or(align_points(positions.from, positions.to, true));
  constexpr int kRounds = 10;
  constexpr double kFar = 3;  // times the median distance
  constexpr double kRounding = 1e-9;
  const double least = kRounding * Positions::extents(positions.to)[0];
  for (int round = 0; round < kRounds; ++round) {
    const Distances distances(positions, found);
    Positions near;
    for (Eigen::Index k = 0; k < distances.all.size(); ++k) {
      if (distances.all[k] <= std::max(kFar * distances.median, least))
        near.add(positions.from.col(k), positions.to.col(k));
    }
    if (!near.determine_similarity()) break;
    facts.far = static_cast<std::size_t>(positions.to.cols() - near.to.cols());
    found = align_points(near.from, near.to, true);
  }
  return Similarity{found.scale, found.rotation, found.translation};
}

/// The rotation that turns the mean direction of gravity downward, and then, if there are two positions, the
/// motion around the vertical that brings the positions closest to the measured ones.
std::optional<Similarity> from_directions(const Graph& graph, const std::vector<Match>& matches) {
  Vector3 sum = Vector3::Zero();
  for (const auto& [row, pose] : matches) {
    if (row->gravity) sum += pose.of(graph).rotation() * *row->gravity;
  }
  if (!(sum.norm() > 0)) return std::nullopt;
  Similarity motion{1, Eigen::Quaterniond::FromTwoVectors(sum, kDown).toRotationMatrix(), Vector3::Zero()};
  const Positions positions(graph, matches, motion.rotation);
  const Eigen::MatrixXd from = positions.from.topRows(2), to = positions.to.topRows(2);
  if (to.cols() < 2) return motion;
  const double before = Positions::extents(positions.from).norm();
  const double after = Positions::extents(positions.to).norm();
  if (!(before > 0 && after > 0)) return motion;
  // The scale follows from the distances in space, because positions above each other do not determine it in
  // the plane.
  const double scale = after / before;
  const PointAlignment turn = align_points(scale * from, to, false);
  Eigen::Matrix3d around = Eigen::Matrix3d::Identity();
  around.topLeftCorner<2, 2>() = turn.rotation;
  motion = {scale, around * motion.rotation, Vector3::Zero()};
  motion.translation.head<2>() = turn.translation;
  motion.translation[2] = (positions.to.row(2) - scale * positions.from.row(2)).mean();
  return motion;
}

void add_edges(Graph& graph, const std::vector<Match>& matches, PositionPriors& facts) {
  std::optional<VertexHandle<S2>> down;
  std::map<VertexRef, VertexHandle<Vector3>> arms;  // of the offsets of sensors
  for (const auto& [row, image] : matches) {
    if (row->position) {
      const Vector3 weights = row->sigma.cwiseAbs2().cwiseInverse();
      const Information information = Information::diagonal({weights.data(), 3});
      if (image.offset) {
        auto arm = arms.find(*image.offset);
        if (arm == arms.end()) {
          const Vector3 place = graph.estimate(*image.offset).translation();
          arm = arms.emplace(*image.offset, graph.add_parameter(place)).first;
        }
        graph.add_edge(OffsetPositionPrior(*row->position), information, image.pose, arm->second);
      } else {
        graph.add_edge(PositionPrior(*row->position), information, image.pose);
      }
      ++facts.positions;
    }
    if (row->gravity) {
      if (!down) down = graph.add_parameter(S2(kDown));
      const DirectionObservation observation{S2(*row->gravity)};
      const Information information(1 / (row->gravity_sigma * row->gravity_sigma));
      if (image.offset) {
        graph.add_edge(observation, information, image.pose, *down, *image.offset);
      } else {
        graph.add_edge(observation, information, image.pose, *down);
      }
      ++facts.directions;
    }
  }
}

}  // namespace

PositionPriors add_position_priors(GraphFile& file, const std::string& path) {
  if (!file.model) throw InvalidArgument("--position-priors: expected a COLMAP model");
  const std::vector<ImagePriors> rows = parse_priors(read_text(path), input_name(path));
  const Images images(file);
  PositionPriors facts;
  std::vector<Match> matches;
  for (const ImagePriors& row : rows) {
    if (const auto pose = images.find(row.image)) {
      matches.push_back({&row, *pose});
    } else {
      ++facts.others;
    }
  }
  Graph& graph = file.graph;
  std::optional<Similarity> motion = from_positions(graph, matches, facts);
  if (!motion) motion = from_directions(graph, matches);
  if (!motion) {
    throw InvalidArgument(fmt::format(
        "--position-priors: expected positions of three images of the graph that are not on a line, or a "
        "direction of gravity; {} of {} rows name images of the graph",
        matches.size(), rows.size()));
  }
  move(graph, *motion);
  facts.scale = motion->scale;
  add_edges(graph, matches, facts);
  return facts;
}

}  // namespace boxplus::app
