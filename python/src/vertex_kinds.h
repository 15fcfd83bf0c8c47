// SPDX-License-Identifier: BSD-3-Clause
// A table of the vertex types that Python knows. To add one, write Value<T> (values.h) and a row in
// vertex_kind_table.cpp, and its class in bind_manifold.cpp or in a file of its own.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <typeindex>
#include <vector>

#include "boxplus/graph/graph.h"
#include "convert.h"

namespace boxplus::python {

struct VertexKind {
  std::string_view name;    ///< of the Python class: "SE2"
  std::string_view layout;  ///< of a row of numbers: "x y theta"
  int size;                 ///< the numbers of a row
  int dim;                  ///< of the tangent space
  bool is_tuple;            ///< an estimate is a tuple, and `name` is a tuple of classes
  std::type_index pool;     ///< the type of the pool of its vertices
  bool (*is)(py::handle estimate);
  VertexRef (*add)(Graph&, py::handle estimate, std::optional<Id> id, bool is_parameter);
  /// Throws ValueError if the numbers are no estimate.
  void (*check_row)(const double* row, RowName name);
  VertexRef (*add_row)(Graph&, const double* row, std::optional<Id> id);
  py::object (*estimate)(const Graph&, VertexRef);
  void (*set_estimate)(Graph&, VertexRef, py::handle estimate);
  void (*get_row)(const Graph&, VertexRef, double* row);
  void (*set_row)(Graph&, VertexRef, const double* row);
  /// The row of x ⊞ 0, for the vertex x in a slot of a pool of this kind: quaternions have unit length.
  void (*read)(const detail::VertexPool&, std::uint32_t slot, double* row);
  /// The row of x ⊞ δ, for a row of x.
  void (*step)(const double* row, const double* delta, double* out);
  /// ∂ row(x ⊞ δ) / ∂δ at δ = 0: size × dim numbers, row by row.
  void (*step_derivative)(const double* row, double* out);
  py::object (*object_of_row)(const double* row);
};

/// The most numbers of a row, and of a vector.
inline constexpr std::size_t kMostNumbers = 16, kMostNumbersOfVector = 12;

std::span<const VertexKind> vertex_kinds();
/// A part of vertex_kinds(): cameras.
std::vector<VertexKind> camera_vertex_kinds();
std::vector<VertexKind> product_vertex_kinds();
/// "an SE2, an SE3, …"
std::string vertex_kind_names();
/// Throws TypeError if the estimate is of no kind.
const VertexKind& kind_of_estimate(py::handle estimate);
/// Throws TypeError if `type` is not the Python class of a kind.
const VertexKind& kind_of_class(py::handle type, std::string_view name);
/// Throws InvalidArgument if the vertex does not exist, and TypeError if Python does not know its type.
const VertexKind& kind_of_vertex(const Graph& graph, VertexRef vertex);
/// The pool of a kind, or nullptr if the graph has none.
const detail::VertexPool* pool_of_kind(const Graph& graph, const VertexKind& kind);
std::uint32_t pool_index_of_kind(const Graph& graph, const VertexKind& kind);

}  // namespace boxplus::python
