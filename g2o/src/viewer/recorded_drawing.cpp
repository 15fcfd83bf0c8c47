// SPDX-License-Identifier: BSD-3-Clause
#include "viewer/recorded_drawing.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>

#include "boxplus/graph/type_name.h"
#include "g2o/core/factory.h"
#include "g2o/core/hyper_graph_action.h"
#include "types/sketch.h"

namespace g2o {
namespace internal {
namespace {

using boxplus::EdgeRole;
using boxplus::viewer::Positions;
using boxplus::viewer::Structure;

/// As #rrggbb. The usual colors of poses, points and edges are left to the page.
std::string text_of(const Color& color) {
  for (const Color& usual : {kPoseColor, kPointColor, kMotionColor, kObservationColor}) {
    if (color.red == usual.red && color.green == usual.green && color.blue == usual.blue) return {};
  }
  const auto byte = [](double part) {
    return static_cast<unsigned>(std::lround(255 * std::clamp(part, 0.0, 1.0)));
  };
  std::array<char, 8> text{};
  std::snprintf(text.data(), text.size(), "#%02x%02x%02x", byte(color.red), byte(color.green),
                byte(color.blue));
  return text.data();
}

/// The tag of the element's type or, if it has none, the name of its class.
std::string name_of(const HyperGraph::HyperGraphElement& element) {
  const std::string& tag = Factory::instance()->tag(&element);
  return tag.empty() ? boxplus::detail::demangle(typeid(element).name()) : tag;
}

}  // namespace

RecordedDrawing::RecordedDrawing(OptimizableGraph& graph) : pose_dimension_(graph.maxDimension()) {
  HyperGraphElementAction* draw = HyperGraphActionLibrary::instance()->actionByName("draw");
  if (draw == nullptr) return;
  DrawAction::Parameters parameters;
  parameters.drawing = this;
  std::vector<HyperGraph::Vertex*> vertices;
  for (const auto& [id, vertex] : graph.vertices()) vertices.push_back(vertex);
  std::sort(vertices.begin(), vertices.end(), [](const auto* a, const auto* b) { return a->id() < b->id(); });
  for (HyperGraph::Vertex* vertex : vertices) {
    begin(*vertex);
    (*draw)(vertex, &parameters);
  }
  std::vector<OptimizableGraph::Edge*> edges;
  for (HyperGraph::Edge* edge : graph.edges()) edges.push_back(static_cast<OptimizableGraph::Edge*>(edge));
  std::sort(edges.begin(), edges.end(),
            [](const auto* a, const auto* b) { return a->internalId() < b->internalId(); });
  for (OptimizableGraph::Edge* edge : edges) {
    begin(*edge);
    const std::size_t before = drawn_;
    (*draw)(edge, &parameters);
    if (drawn_ == before) connect(*edge);
  }
}

/// Draws an edge whose type has no action as lines from its first vertex to the others.
void RecordedDrawing::connect(const OptimizableGraph::Edge& edge) {
  constexpr Color kGray{0.5, 0.5, 0.5, 1};
  const auto first = edge.vertices().empty() ? known_.end() : known_.find(edge.vertex(0));
  if (first == known_.end()) return;
  for (std::size_t i = 1; i < edge.vertices().size(); ++i) {
    const auto other = known_.find(edge.vertex(i));
    if (other != known_.end()) line(first->second.at, other->second.at, kGray, 1);
  }
}

void RecordedDrawing::begin(const HyperGraph::HyperGraphElement& element) {
  name_ = name_of(element);
  vertex_ = dynamic_cast<const OptimizableGraph::Vertex*>(&element);
  edge_ = dynamic_cast<const OptimizableGraph::Edge*>(&element);
  role_ = edge_ != nullptr ? role_of(*edge_) : EdgeRole::kOther;
}

/// The role of an edge between poses follows from the ids, as in g2o.
EdgeRole RecordedDrawing::role_of(const OptimizableGraph::Edge& edge) const {
  if (edge.vertices().size() < 2 || edge.numUndefinedVertices() > 0) return EdgeRole::kOther;
  int smallest = pose_dimension_;
  for (const HyperGraph::Vertex* vertex : edge.vertices())
    smallest = std::min(smallest, static_cast<const OptimizableGraph::Vertex*>(vertex)->dimension());
  if (smallest < pose_dimension_) return EdgeRole::kObservation;
  const bool consecutive = std::abs(edge.vertex(0)->id() - edge.vertex(1)->id()) == 1;
  return consecutive ? EdgeRole::kOdometry : EdgeRole::kLoopClosure;
}

RecordedDrawing::Place RecordedDrawing::add(Kind kind, const Isometry3& at, const Color& color) {
  ++drawn_;
  const auto k = static_cast<std::size_t>(kind);
  const std::string text = kind == Kind::kCorner ? "" : text_of(color);
  const GroupKey key{kind == Kind::kCorner ? "" : name_, text};
  const auto [entry, is_new] = group_of_[k].try_emplace(key, groups_[k].size());
  if (is_new) groups_[k].push_back({std::get<0>(key), text, {}});
  std::vector<Shape>& shapes = groups_[k][entry->second].shapes;
  shapes.push_back({at, vertex_ != nullptr && kind != Kind::kCorner && vertex_->fixed()});
  const Place place{kind, entry->second, shapes.size() - 1};
  if (vertex_ != nullptr && kind != Kind::kCorner)
    known_.try_emplace(vertex_, Known{at.translation(), place});
  return place;
}

void RecordedDrawing::point(const Vector3& at, const Color& color, double /*diameter*/) {
  Isometry3 pose = Isometry3::Identity();
  pose.translation() = at;
  add(Kind::kPoint, pose, color);
}

void RecordedDrawing::pose(const Isometry3& pose, const Color& color, double /*length*/, double /*width*/) {
  add(Kind::kPose, pose, color);
}

RecordedDrawing::Place RecordedDrawing::place_of(const Vector3& corner) {
  if (edge_ != nullptr) {
    for (const HyperGraph::Vertex* vertex : edge_->vertices()) {
      const auto known = known_.find(vertex);
      if (known != known_.end() && known->second.at == corner) return known->second.place;
    }
  }
  Isometry3 at = Isometry3::Identity();
  at.translation() = corner;
  return add(Kind::kCorner, at, {});
}

void RecordedDrawing::polyline(const std::vector<Vector3>& corners, bool isClosed, const Color& color,
                               double /*width*/) {
  if (corners.size() < 2) return;
  ++drawn_;
  const LineKey key{name_, role_, text_of(color)};
  const auto [entry, is_new] = lines_of_.try_emplace(key, lines_.size());
  if (is_new) lines_.push_back({name_, std::get<2>(key), role_, {}});
  std::vector<Place> places;
  for (const Vector3& corner : corners) places.push_back(place_of(corner));
  auto& lines = lines_[entry->second].lines;
  for (std::size_t i = 1; i < places.size(); ++i) lines.push_back({places[i - 1], places[i]});
  if (isClosed) lines.push_back({places.back(), places.front()});
}

/// Calls f(shape) in the order of the numbers of the structure.
template <class F>
void RecordedDrawing::for_each_shape(F&& f) const {
  for (const std::vector<Group>& groups : groups_) {
    for (const Group& group : groups) {
      for (const Shape& shape : group.shapes) f(shape);
    }
  }
}

Structure RecordedDrawing::structure() const {
  using boxplus::viewer::Shape;
  constexpr std::array kShapes{Shape::kPose, Shape::kPoint, Shape::kCorner};
  Structure structure;
  std::array<std::vector<std::uint32_t>, 3> first;
  for (std::size_t k = 0; k < groups_.size(); ++k) {
    for (const Group& group : groups_[k]) {
      first[k].push_back(structure.count);
      const auto count = static_cast<std::uint32_t>(group.shapes.size());
      structure.vertices.push_back(
          {group.name, kShapes[k], 0, structure.count, std::vector<std::uint32_t>(count), group.color});
      structure.count += count;
    }
    if (k == 0) structure.oriented = structure.count;
  }
  const auto number = [&](const Place& place) {
    const auto k = static_cast<std::size_t>(place.kind);
    return first[k][place.group] + static_cast<std::uint32_t>(place.index);
  };
  for (const Lines& lines : lines_) {
    const auto begin = static_cast<std::uint32_t>(structure.lines.size() / 2);
    for (const auto& [from, to] : lines.lines) {
      if (structure.lines.size() / 2 == Structure::kMostLines) {
        ++structure.left_out;
        continue;
      }
      structure.lines.push_back(number(from));
      structure.lines.push_back(number(to));
    }
    structure.line_groups.push_back({lines.name, lines.role, 0, begin,
                                     static_cast<std::uint32_t>(structure.lines.size() / 2) - begin,
                                     lines.color});
  }
  bool is_flat = true;
  Vector3 sum = Vector3::Zero();
  std::size_t finite = 0;
  for_each_shape([&](const RecordedDrawing::Shape& shape) {
    structure.fixed.push_back(shape.is_fixed);
    const Vector3 at = shape.at.translation();
    if (!at.allFinite()) return;
    is_flat = is_flat && at.z() == 0;
    sum += at;
    ++finite;
  });
  structure.dimension = is_flat ? 2 : 3;
  if (finite > 0) sum /= static_cast<double>(finite);
  if (sum.allFinite()) structure.center = {sum.x(), sum.y(), sum.z()};
  return structure;
}

Positions RecordedDrawing::positions(const std::array<double, 3>& center) const {
  constexpr double kFarthest = 1e18;  // products of lengths must fit into a float
  constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
  Positions positions;
  for_each_shape([&](const Shape& shape) {
    const Vector3 at = shape.at.translation() - Vector3(center[0], center[1], center[2]);
    const bool is_drawn = at.allFinite() && at.cwiseAbs().maxCoeff() < kFarthest;
    for (int i = 0; i < 3; ++i) positions.points.push_back(is_drawn ? static_cast<float>(at[i]) : kNone);
  });
  for (const Group& group : groups_[static_cast<std::size_t>(Kind::kPose)]) {
    for (const Shape& shape : group.shapes) {
      const Eigen::Quaternionf q = Eigen::Quaterniond(shape.at.linear()).cast<float>();
      positions.orientations.insert(positions.orientations.end(), {q.x(), q.y(), q.z(), q.w()});
    }
  }
  return positions;
}

}  // namespace internal
}  // namespace g2o
