// SPDX-License-Identifier: BSD-3-Clause
// What the actions "draw" of a graph draw, as a structure and positions of the viewer.
#pragma once

#include <array>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "g2o/core/drawing.h"
#include "g2o/core/optimizable_graph.h"
#include "viewer/scene/positions.h"
#include "viewer/scene/structure.h"

namespace g2o {
namespace internal {

/// Shapes of the same element type and color become one group. Lines of an edge that end at a shape of one of
/// its vertices share this shape, so that the viewer knows what the edge connects. An edge whose type has no
/// action is a line between its vertices. Text is left out.
class RecordedDrawing final : public Drawing {
 public:
  /// Draws all elements of a graph with the actions of the library of actions.
  explicit RecordedDrawing(OptimizableGraph& graph);

  void polyline(const std::vector<Vector3>& corners, bool isClosed, const Color& color,
                double width) override;
  void point(const Vector3& at, const Color& color, double diameter) override;
  void pose(const Isometry3& pose, const Color& color, double length, double width) override;
  void text(const Vector3& /*at*/, const std::string& /*words*/, const Color& /*color*/,
            double /*height*/) override {}

  boxplus::viewer::Structure structure() const;
  /// Relative to `center`.
  boxplus::viewer::Positions positions(const std::array<double, 3>& center) const;

 private:
  /// The name of an element type, and a color.
  using GroupKey = std::tuple<std::string, std::string>;
  using LineKey = std::tuple<std::string, boxplus::EdgeRole, std::string>;
  enum class Kind : std::uint8_t { kPose, kPoint, kCorner };
  /// A shape before the groups are in their final order.
  struct Place {
    Kind kind = Kind::kCorner;
    std::size_t group = 0, index = 0;
  };
  struct Shape {
    Isometry3 at;
    bool is_fixed = false;
  };
  struct Group {
    std::string name, color;
    std::vector<Shape> shapes;
  };
  struct Lines {
    std::string name, color;
    boxplus::EdgeRole role;
    std::vector<std::array<Place, 2>> lines;
  };
  struct Known {
    Vector3 at;
    Place place;
  };

  void connect(const OptimizableGraph::Edge& edge);
  void begin(const HyperGraph::HyperGraphElement& element);
  Place add(Kind kind, const Isometry3& at, const Color& color);
  Place place_of(const Vector3& corner);
  boxplus::EdgeRole role_of(const OptimizableGraph::Edge& edge) const;
  template <class F>
  void for_each_shape(F&& f) const;

  int pose_dimension_ = 0;
  std::array<std::vector<Group>, 3> groups_;  // of each kind
  std::vector<Lines> lines_;
  std::array<std::map<GroupKey, std::size_t>, 3> group_of_;
  std::map<LineKey, std::size_t> lines_of_;
  // The first shape of each vertex.
  std::map<const HyperGraph::Vertex*, Known> known_;
  std::size_t drawn_ = 0;  ///< the number of shapes and polylines

  // Of the current element.
  std::string name_;
  boxplus::EdgeRole role_ = boxplus::EdgeRole::kOther;
  const OptimizableGraph::Vertex* vertex_ = nullptr;
  const OptimizableGraph::Edge* edge_ = nullptr;
};

}  // namespace internal
}  // namespace g2o
