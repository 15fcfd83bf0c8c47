// SPDX-License-Identifier: BSD-3-Clause
// Edges whose error function is written in Python.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "convert.h"
#include "graph_object.h"

namespace boxplus::python {

class BatchedPool;

/// Whether Graph.add_edge() takes `edge` as an error function: a callable that is no class and no Edge.
bool is_function(py::handle edge);
/// Whether Graph.add_edges() takes `edge` as an error function for many edges: an object with a method
/// error(), or what is_function() accepts.
bool is_batched_function(py::handle edge);

/// Adds edges to the pool of a function, which is created if there is none. The types of the vertices are
/// those of the first edge. `measurements`: an array with a row per edge, or None. The edges may be
/// constraints. Calls the function, to find the number of rows of its error. Throws TypeError and ValueError
/// that name the argument.
class FunctionEdges {
 public:
  FunctionEdges(Graph& graph, const py::object& edge, std::span<const VertexRef> first,
                const py::object& measurements, bool is_constraint);
  int rows() const { return rows_; }
  EdgeRef add(std::size_t edge, const Information& information, std::span<const VertexRef> vertices);

 private:
  Graph* graph_;
  std::uint32_t pool_;
  int rows_ = 0, width_ = 0;
  Numbers measurements_;
};

/// While it exists, the error of this edge, if it is a function of Python, is computed anew and for this edge
/// only.
class FreshEdge {
 public:
  FreshEdge(const Graph& graph, EdgeRef edge);
  ~FreshEdge();
  FreshEdge(const FreshEdge&) = delete;
  FreshEdge& operator=(const FreshEdge&) = delete;

 private:
  const BatchedPool* pool_ = nullptr;  // of the edge; null if it is no function of Python
};

/// Likewise for all edges of a graph: a function is only called for the edges that are asked for, a few at a
/// time. For runs that need few of the edges.
class FreshEdges {
 public:
  explicit FreshEdges(const Graph& graph);
  ~FreshEdges();
  FreshEdges(const FreshEdges&) = delete;
  FreshEdges& operator=(const FreshEdges&) = delete;

 private:
  std::vector<const BatchedPool*> pools_;
};

/// What the functions of the pools of a graph have cost so far: a list of (name, jacobians, calls, edges,
/// seconds).
py::list costs_of_functions(const Graph& graph);

}  // namespace boxplus::python
