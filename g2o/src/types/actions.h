// SPDX-License-Identifier: BSD-3-Clause
// The actions "writeGnuplot" and "draw" of the ready-made types. Each library of types has a struct that
// describes what its elements look like:
//
//     struct Library {
//       static constexpr int kDimension = 2;                // coordinates per point in gnuplot files
//       static Sketch sketch(const Element&);               // one overload per type of element
//       static bool write(const Element&, std::ostream&);   // returns true if it wrote the element
//     };
//     G2O_REGISTER_TYPE_GROUP(…_actions)
//     const internal::RegisterActions<Library, Element, …> registered;
#pragma once

#include <algorithm>
#include <ostream>
#include <tuple>

#include "g2o/core/cache.h"
#include "g2o/core/hyper_graph_action.h"
#include "types/sketch.h"

namespace g2o {
namespace internal {

inline bool is_complete(const HyperGraph::HyperGraphElement& element) {
  const auto* e = dynamic_cast<const HyperGraph::Edge*>(&element);
  return e == nullptr || e->numUndefinedVertices() == 0;
}

/// Writes the values on one line.
template <class Vector>
void write_line(std::ostream& os, const Vector& numbers) {
  for (Eigen::Index i = 0; i < numbers.size(); ++i) os << (i > 0 ? " " : "") << numbers[i];
  os << '\n';
}

/// Writes an element for gnuplot. If Library::write() does not write the element, this action writes the
/// lines of its sketch. Each line of the sketch becomes two lines of coordinates and an empty line. Skips
/// edges that lack a vertex.
template <class Library, class T>
class GnuplotAction : public WriteGnuplotAction {
 public:
  GnuplotAction() : WriteGnuplotAction(typeid(T).name()) {}

  HyperGraphElementAction* operator()(HyperGraph::HyperGraphElement* element,
                                      HyperGraphElementAction::Parameters* parameters) override {
    return (*this)(static_cast<const HyperGraph::HyperGraphElement*>(element), parameters);
  }
  HyperGraphElementAction* operator()(const HyperGraph::HyperGraphElement* element,
                                      HyperGraphElementAction::Parameters* parameters) override {
    auto* typed = dynamic_cast<WriteGnuplotAction::Parameters*>(parameters);
    if (typeid(*element).name() != _typeName || typed == nullptr || typed->os == nullptr) return nullptr;
    if (!is_complete(*element)) return nullptr;
    write(dynamic_cast<const T&>(*element), *typed->os);
    return this;
  }

 private:
  static void write(const T& element, std::ostream& os) {
    if (Library::write(element, os)) return;
    for (const auto& [from, to] : Library::sketch(element).lines) {
      write_line(os, from.template head<Library::kDimension>());
      write_line(os, to.template head<Library::kDimension>());
      os << '\n';
    }
  }
};

template <class Library, class T>
class DrawElementAction : public DrawAction {
 public:
  DrawElementAction() : DrawAction(typeid(T).name()) {}

  HyperGraphElementAction* operator()(HyperGraph::HyperGraphElement* element,
                                      HyperGraphElementAction::Parameters* parameters) override {
    if ((*this)(static_cast<const HyperGraph::HyperGraphElement*>(element), parameters) == nullptr)
      return nullptr;
    if (auto* v = dynamic_cast<OptimizableGraph::Vertex*>(element))
      drawCache(v->cacheContainer(), parameters);
    if (auto* holder = dynamic_cast<HyperGraph::DataContainer*>(element))
      drawUserData(holder->userData(), parameters);
    return this;
  }
  HyperGraphElementAction* operator()(const HyperGraph::HyperGraphElement* element,
                                      HyperGraphElementAction::Parameters* parameters) override {
    if (typeid(*element).name() != _typeName || !refreshPropertyPtrs(parameters)) return nullptr;
    if (_show != nullptr && !_show->value()) return this;
    draw(Library::sketch(dynamic_cast<const T&>(*element)));
    return this;
  }

 private:
  void draw(const Sketch& sketch) {
    Drawing& drawing = *_previousParams->drawing;
    for (const auto& [from, to] : sketch.lines)
      drawing.line(from, to, sketch.color, property("LINE_WIDTH", 1));
    for (const auto& [middle, direction] : sketch.pieces) {
      const Vector3 half = property("LINE_LENGTH", sketch.piece_length) / 2 * direction;
      drawing.line(middle - half, middle + half, sketch.color, property("LINE_WIDTH", sketch.piece_width));
    }
    for (const Isometry3& pose : sketch.poses)
      drawing.pose(pose, sketch.color, property("TRIANGLE_X", .2F), property("TRIANGLE_Y", .05F));
    Color faint = sketch.color;
    faint.alpha = 0.4;
    for (const Isometry3& pose : sketch.ghosts)
      drawing.pose(pose, faint, property("GHOST_TRIANGLE_X", .2F), property("GHOST_TRIANGLE_Y", .05F));
    for (const Isometry3& pose : sketch.sensors)
      drawing.cube(pose, sketch.color, property("CUBE_SIDE", .05F), 1);
    for (const Isometry3& pose : sketch.cameras)
      draw_camera(pose, sketch.color, property("CAMERA_Z", .05F), property("CAMERA_SIDE", .05F));
    for (const Isometry3& plane : sketch.planes)
      draw_plane(plane, sketch.color, property("PLANE_WIDTH", sketch.plane_side),
                 property("PLANE_HEIGHT", sketch.plane_side));
    for (const Vector3& point : sketch.points) drawing.point(point, sketch.color, property("POINT_SIZE", 4));
  }

  /// Draws a pyramid from the center of projection to the image.
  void draw_camera(const Isometry3& pose, const Color& color, double depth, double side) {
    const double half = side / 2;
    const std::vector<Vector3> image{pose * Vector3(-half, -half, depth), pose * Vector3(half, -half, depth),
                                     pose * Vector3(half, half, depth), pose * Vector3(-half, half, depth)};
    Drawing& drawing = *_previousParams->drawing;
    drawing.polyline(image, true, color, property("LINE_WIDTH", 1));
    for (const Vector3& corner : image)
      drawing.line(pose.translation(), corner, color, property("LINE_WIDTH", 1));
  }

  /// Draws a rectangle and its normal.
  void draw_plane(const Isometry3& plane, const Color& color, double width, double height) {
    const double x = width / 2, y = height / 2;
    Drawing& drawing = *_previousParams->drawing;
    drawing.polyline({plane * Vector3(-x, -y, 0), plane * Vector3(x, -y, 0), plane * Vector3(x, y, 0),
                      plane * Vector3(-x, y, 0)},
                     true, color, property("LINE_WIDTH", 1));
    drawing.line(plane.translation(), plane * Vector3(0, 0, std::min(x, y) / 2), color,
                 property("LINE_WIDTH", 1));
  }
};

/// Both actions of each of the types are registered as long as this object exists.
template <class Library, class... T>
class RegisterActions {
 private:
  std::tuple<RegisterActionProxy<GnuplotAction<Library, T>>...> write_;
  std::tuple<RegisterActionProxy<DrawElementAction<Library, T>>...> draw_;
};

}  // namespace internal
}  // namespace g2o
