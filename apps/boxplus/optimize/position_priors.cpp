// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/position_priors.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <Eigen/SVD>
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>
#include <string_view>
#include <vector>

#include "base/align_points.h"
#include "boxplus/base/error.h"
#include "boxplus/io/sparse_model.h"
#include "boxplus/manifold/s2.h"
#include "boxplus/manifold/se3.h"
#include "boxplus/types/inertial/direction_observation.h"
#include "boxplus/types/position_prior.h"
#include "command_line/message.h"
#include "files/graph_input.h"

namespace boxplus::app {
namespace {

/// The priors on one image.
struct Row {
  std::string image;
  std::optional<Vector3> position, gravity;  ///< gravity has length 1
  Vector3 sigma = Vector3::Ones();
  double gravity_sigma = 0.02;
  std::int64_t line = 0;
};

/// The fields of one line, each with the column at which it begins.
struct Field {
  std::string_view text;
  std::int64_t column;
};

std::vector<Field> fields_of(std::string_view line) {
  std::vector<Field> fields;
  for (std::size_t begin = 0;;) {
    const std::size_t end = std::min(line.find(',', begin), line.size());
    std::string_view text = line.substr(begin, end - begin);
    const std::size_t blanks = std::min(text.find_first_not_of(" \t\""), text.size());
    text.remove_prefix(blanks);
    while (!text.empty() && std::string_view(" \t\r\"").find(text.back()) != std::string_view::npos)
      text.remove_suffix(1);
    fields.push_back({text, static_cast<std::int64_t>(begin + blanks + 1)});
    if (end == line.size()) return fields;
    begin = end + 1;
  }
}

class PriorsFile {
 public:
  PriorsFile(std::string_view text, std::string name) : name_(std::move(name)) {
    while (!text.empty()) {
      ++line_;
      const std::size_t end = std::min(text.find('\n'), text.size());
      read(text.substr(0, end));
      text.remove_prefix(std::min(end + 1, text.size()));
    }
    if (columns_.empty()) fail({{}, 1}, "expected a row with the names of columns, got an empty file");
  }
  const std::vector<Row>& rows() const { return rows_; }

 private:
  void read(std::string_view line) {
    const std::vector<Field> fields = fields_of(line);
    if (fields.size() == 1 && fields[0].text.empty()) return;
    if (columns_.empty()) return read_names(fields);
    if (fields.size() != columns_.size()) {
      fail(fields.back(),
           fmt::format("expected {} fields, as in the first row, got {}", columns_.size(), fields.size()));
    }
    fields_ = &fields;
    Row row;
    row.line = line_;
    row.image = fields[columns_.at("image")].text;
    row.position = vector("x", "y", "z");
    row.gravity = vector("gx", "gy", "gz");
    if (row.gravity) {
      const double length = row.gravity->norm();
      if (!(length > 0)) fail(fields[columns_.at("gx")], "expected a direction, got zeros");
      *row.gravity /= length;
    }
    constexpr std::array kSigmas{"sigma_x", "sigma_y", "sigma_z"};
    for (int i = 0; i < 3; ++i) row.sigma[i] = sigma(kSigmas[static_cast<std::size_t>(i)], sigma("sigma", 1));
    row.gravity_sigma = sigma("gravity_sigma", row.gravity_sigma);
    rows_.push_back(std::move(row));
  }

  void read_names(const std::vector<Field>& fields) {
    constexpr std::array kNames{"image",   "x",       "y",  "z",  "sigma", "sigma_x",
                                "sigma_y", "sigma_z", "gx", "gy", "gz",    "gravity_sigma"};
    for (std::size_t k = 0; k < fields.size(); ++k) {
      if (std::find(kNames.begin(), kNames.end(), fields[k].text) == kNames.end()) {
        fail(fields[k], fmt::format("expected one of the columns {}, got '{}'", fmt::join(kNames, ", "),
                                    escaped(fields[k].text)));
      }
      if (!columns_.try_emplace(std::string(fields[k].text), k).second)
        fail(fields[k], fmt::format("expected each column once, got '{}' again", fields[k].text));
    }
    const auto require_all = [&](std::initializer_list<const char*> names) {
      for (const char* name : names) {
        if (!columns_.contains(name)) fail(fields[0], fmt::format("expected a column '{}'", name));
      }
    };
    require_all({"image"});
    if (!columns_.contains("gx")) require_all({"x"});
    if (columns_.contains("x")) require_all({"y", "z"});
    if (columns_.contains("gx")) require_all({"gy", "gz"});
  }

  /// The three fields, or nothing if there are no such columns, or if the fields are empty.
  std::optional<Vector3> vector(const char* x, const char* y, const char* z) const {
    if (!columns_.contains(x) || (*fields_)[columns_.at(x)].text.empty()) return std::nullopt;
    return Vector3(number(x), number(y), number(z));
  }
  double sigma(const char* name, double otherwise) const {
    if (!columns_.contains(name) || (*fields_)[columns_.at(name)].text.empty()) return otherwise;
    const double value = number(name);
    if (!(value > 0))
      fail((*fields_)[columns_.at(name)], fmt::format("expected {} above 0, got {}", name, value));
    return value;
  }
  double number(const char* name) const {
    const Field& field = (*fields_)[columns_.at(name)];
    double value = 0;
    const char* const end = field.text.data() + field.text.size();
    const auto [stop, error] = std::from_chars(field.text.data(), end, value);
    if (error != std::errc() || stop != end || !std::isfinite(value))
      fail(field, fmt::format("expected {}, got '{}'", name, escaped(field.text)));
    return value;
  }
  [[noreturn]] void fail(const Field& field, const std::string& message) const {
    throw InputError(name_, line_, field.column, message);
  }

  std::string name_;
  std::int64_t line_ = 0;
  std::map<std::string, std::size_t, std::less<>> columns_;
  const std::vector<Field>* fields_ = nullptr;
  std::vector<Row> rows_;
};

/// A typed view of a pool, or nullptr.
template <class T>
const detail::TypedVertexPool<T>* pool_of(const Graph& graph, VertexRef vertex) {
  return dynamic_cast<const detail::TypedVertexPool<T>*>(graph.vertex_pools()[vertex.pool].get());
}

/// The poses of images, by their names or ids.
class Images {
 public:
  explicit Images(const GraphFile& file) : graph_(file.graph) {
    if (!file.model) return;
    for (const SparseModel::Image& image : file.model->images) ids_.emplace(image.name, image.id);
  }
  std::optional<VertexHandle<SE3>> find(const std::string& name) const {
    Id id = 0;
    if (const auto at = ids_.find(name); at != ids_.end()) {
      id = at->second;
    } else {
      const auto [stop, error] = std::from_chars(name.data(), name.data() + name.size(), id);
      if (!ids_.empty() || error != std::errc() || stop != name.data() + name.size()) return std::nullopt;
    }
    const std::optional<VertexRef> vertex = graph_.find_vertex(id);
    if (!vertex || pool_of<SE3>(graph_, *vertex) == nullptr) return std::nullopt;
    return graph_.vertex<SE3>(id);
  }

 private:
  const Graph& graph_;
  std::map<std::string, Id> ids_;
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
  const Row* row;
  VertexHandle<SE3> pose;
};

const Vector3 kDown(0, 0, -1);

/// Positions of images in the model, turned by a rotation, and the measured ones.
struct Positions {
  Positions(const Graph& graph, const std::vector<Match>& matches, const Eigen::Matrix3d& rotation) {
    for (const auto& [row, pose] : matches) {
      if (!row->position) continue;
      for (Eigen::MatrixXd* points : {&from, &to}) points->conservativeResize(3, points->cols() + 1);
      from.rightCols(1) = rotation * graph.estimate(pose).translation();
      to.rightCols(1) = *row->position;
    }
  }
  /// The extents along the principal axes of a set of points, the largest one first.
  static Eigen::VectorXd extents(const Eigen::MatrixXd& points) {
    return Eigen::JacobiSVD<Eigen::MatrixXd>(points.colwise() - points.rowwise().mean()).singularValues();
  }
  Eigen::MatrixXd from{3, 0}, to{3, 0};
};

/// The similarity that brings the positions of the model closest to the measured ones, if these determine it.
std::optional<Similarity> from_positions(const Graph& graph, const std::vector<Match>& matches) {
  const Positions positions(graph, matches, Eigen::Matrix3d::Identity());
  constexpr int kLeast = 3;
  constexpr double kFlat = 1e-3;  // the second extent, relative to the first
  if (positions.to.cols() < kLeast) return std::nullopt;
  for (const Eigen::MatrixXd* points : {&positions.from, &positions.to}) {
    const Eigen::VectorXd extents = Positions::extents(*points);
    if (!(extents[1] > kFlat * extents[0])) return std::nullopt;
  }
  const PointAlignment found = align_points(positions.from, positions.to, true);
  return Similarity{found.scale, found.rotation, found.translation};
}

/// The rotation that turns the mean direction of gravity downward, and then, if there are two positions, the
/// motion around the vertical that brings the positions closest to the measured ones.
std::optional<Similarity> from_directions(const Graph& graph, const std::vector<Match>& matches) {
  Vector3 sum = Vector3::Zero();
  for (const auto& [row, pose] : matches) {
    if (row->gravity) sum += graph.estimate(pose).rotation() * *row->gravity;
  }
  if (!(sum.norm() > 0)) return std::nullopt;
  Similarity motion{1, Eigen::Quaterniond::FromTwoVectors(sum, kDown).toRotationMatrix(), Vector3::Zero()};
  const Positions positions(graph, matches, motion.rotation);
  const Eigen::MatrixXd from = positions.from.topRows(2), to = positions.to.topRows(2);
  if (to.cols() < 2 || !(Positions::extents(from)[0] > 0 && Positions::extents(to)[0] > 0)) return motion;
  const PointAlignment turn = align_points(from, to, true);
  Eigen::Matrix3d around = Eigen::Matrix3d::Identity();
  around.topLeftCorner<2, 2>() = turn.rotation;
  motion = {turn.scale, around * motion.rotation, Vector3::Zero()};
  motion.translation.head<2>() = turn.translation;
  motion.translation[2] = (positions.to.row(2) - turn.scale * positions.from.row(2)).mean();
  return motion;
}

}  // namespace

PositionPriors add_position_priors(GraphFile& file, const std::string& path) {
  const std::string text = read_text(path);
  const PriorsFile priors(text, input_name(path));
  const Images images(file);
  PositionPriors facts;
  std::vector<Match> matches;
  for (const Row& row : priors.rows()) {
    if (const auto pose = images.find(row.image)) {
      matches.push_back({&row, *pose});
    } else {
      ++facts.others;
    }
  }
  Graph& graph = file.graph;
  std::optional<Similarity> motion = from_positions(graph, matches);
  if (!motion) motion = from_directions(graph, matches);
  if (!motion) {
    throw InvalidArgument(fmt::format(
        "--position-priors: expected positions of three images of the graph that are not on a line, or a "
        "direction of gravity; {} of {} rows name images of the graph",
        matches.size(), priors.rows().size()));
  }
  move(graph, *motion);
  facts.scale = motion->scale;
  std::optional<VertexHandle<S2>> down;
  for (const auto& [row, pose] : matches) {
    if (row->position) {
      const std::array<double, 3> weights{1 / (row->sigma[0] * row->sigma[0]),
                                          1 / (row->sigma[1] * row->sigma[1]),
                                          1 / (row->sigma[2] * row->sigma[2])};
      graph.add_edge(PositionPrior(*row->position), Information::diagonal(weights), pose);
      ++facts.positions;
    }
    if (row->gravity) {
      if (!down) down = graph.add_parameter(S2(kDown));
      graph.add_edge(DirectionObservation(S2(*row->gravity)),
                     Information(1 / (row->gravity_sigma * row->gravity_sigma)), pose, *down);
      ++facts.directions;
    }
  }
  return facts;
}

}  // namespace boxplus::app
