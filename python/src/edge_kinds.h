// SPDX-License-Identifier: BSD-3-Clause
// A table of the edge types that Python knows. A family is a Python class, such as Between; it has a kind for
// each list of vertex types. To add a kind, write a row in edge_kinds.cpp.
#pragma once

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
};

struct EdgeKind {
  std::string_view family;             ///< the name of the Python class: "Between"
  std::string vertices;                ///< "SE2, SE2"
  std::vector<std::type_index> pools;  ///< the types of the pools of its vertices
  std::type_index pool;                ///< the type of the pool of its edges
  std::string_view layout;             ///< of the row of a measurement: "x y theta"
  int size;                            ///< the numbers of this row
  int rows;                            ///< of the error
  EdgeRef (*add)(Graph&, py::handle measurement, const Information&, const VertexRef* vertices);
  EdgeRef (*add_row)(Graph&, const double* row, RowName name, const Information&, const VertexRef* vertices);
  py::object (*measurement)(const Graph&, EdgeRef);
  void (*set_measurement)(Graph&, EdgeRef, py::handle measurement);
};

struct EdgeFamily {
  const char* name;
  const char* doc;
};

std::span<const EdgeFamily> edge_families();
std::span<const EdgeKind> edge_kinds();
/// A part of edge_kinds(): those of cameras.
std::vector<EdgeKind> camera_edge_kinds();
/// The name of the class of an edge, or of the class itself if `edge` is one. Throws TypeError if it is not
/// of a family.
std::string family_of(py::handle edge);
/// The kind of a family for these vertices. Throws TypeError if there is none, and InvalidArgument if a
/// vertex does not exist.
const EdgeKind& kind_for(const std::string& family, const Graph& graph, std::span<const VertexRef> vertices);
/// Throws InvalidArgument if the edge does not exist, and TypeError if Python does not know its type.
const EdgeKind& kind_of_edge(const Graph& graph, EdgeRef edge);

}  // namespace boxplus::python
