// SPDX-License-Identifier: BSD-3-Clause
// A table of the edge types that Python knows. A family is a Python class, such as Between; it has a kind for
// each list of vertex types. To add a kind, write a row in edge_kind_table.cpp.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <typeindex>
#include <vector>

#include "boxplus/graph/graph.h"
#include "convert.h"

namespace boxplus::python {

/// An edge that is not in a graph: its family is its Python class.
struct EdgeValue {
  py::object measurement;

  template <class Function>
  void for_each_reference(const Function& f) {
    f(measurement);
  }
};

/// An edge with known intrinsic parameters.
struct CameraEdgeValue : EdgeValue {
  py::object camera;

  template <class Function>
  void for_each_reference(const Function& f) {
    EdgeValue::for_each_reference(f);
    f(camera);
  }
};

/// An edge that becomes a constraint: an error function of Python, an EdgeValue or the class of one.
struct ConstraintValue {
  py::object edge;

  template <class Function>
  void for_each_reference(const Function& f) {
    f(edge);
  }
};

/// The place of a new edge: a graph or, if `pool` is given, a pool of its type that is not in a graph.
struct EdgePlace {
  Graph* graph;
  const VertexRef* vertices;
  detail::EdgePool* pool = nullptr;
  std::span<const std::uint32_t> slots = {};  ///< of the vertices
};

struct EdgeKind {
  std::string_view family;             ///< the name of the Python class: "Between"
  std::string vertices;                ///< "SE2, SE2"
  std::vector<std::type_index> pools;  ///< the types of the pools of its vertices
  std::type_index pool;                ///< the type of the pool of its edges
  std::string_view layout;             ///< of the row of a measurement: "x y theta"
  int size;                            ///< the numbers of this row
  int rows;                            ///< of the error
  EdgeRef (*add)(const EdgePlace&, py::handle measurement, py::handle camera, const Information&);
  EdgeRef (*add_row)(const EdgePlace&, const double* row, RowName name, py::handle camera,
                     const Information&);
  /// Of an edge in a pool of this kind.
  py::object (*measurement)(const detail::EdgePool&, std::uint32_t slot);
  void (*set_measurement)(Graph&, EdgeRef, py::handle measurement);
  void (*set_measurement_in_pool)(detail::EdgePool&, std::uint32_t slot, py::handle measurement);
  /// A pool for edges of vertices of a graph, which is not in the graph.
  std::unique_ptr<detail::EdgePool> (*empty_pool)(const Graph&, const VertexRef* vertices);
  bool (*is_camera)(py::handle) = nullptr;  ///< whether the edge takes this camera; null if it has none
  std::string_view camera_name = {};
};

struct EdgeFamily {
  const char* name;
  const char* doc;
  bool has_camera = false;
};

std::span<const EdgeFamily> edge_families();
std::span<const EdgeKind> edge_kinds();
/// A part of edge_kinds(): those of cameras.
std::vector<EdgeKind> camera_edge_kinds();
std::vector<EdgeKind> known_camera_edge_kinds();
/// The name of the class of an edge, or of the class itself if `edge` is one. Throws TypeError if it is not
/// of a family.
std::string family_of(py::handle edge);
/// The camera of an edge, or None.
py::object camera_of(py::handle edge);
/// The kind of a family for these vertices and this camera, which is None for most families. Throws TypeError
/// if there is none, and InvalidArgument if a vertex does not exist.
const EdgeKind& kind_for(const std::string& family, const Graph& graph, std::span<const VertexRef> vertices,
                         py::handle camera);
/// Throws InvalidArgument if the edge does not exist, and TypeError if Python does not know its type.
const EdgeKind& kind_of_edge(const Graph& graph, EdgeRef edge);

}  // namespace boxplus::python
