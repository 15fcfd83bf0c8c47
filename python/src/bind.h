// SPDX-License-Identifier: BSD-3-Clause
// The parts of the module. Each function adds the classes and functions of one subject.
#pragma once

#include <pybind11/pybind11.h>

#include <memory>

#include "collected.h"
#include "graph_object.h"

namespace boxplus::python {

/// The class Graph, to which several subjects add methods.
using GraphClass = py::class_<GraphObject, std::shared_ptr<GraphObject>>;

void bind_error(py::module_& module);
void bind_manifold(py::module_& module);
void bind_landmarks(py::module_& module);
void bind_camera(py::module_& module);
void bind_kernel(py::module_& module);
void bind_information(py::module_& module);
void bind_edge(py::module_& module);
void bind_options(py::module_& module);
void bind_report(py::module_& module);
GraphClass bind_graph(py::module_& module);
void bind_edges(GraphClass& graph);
void bind_bulk(GraphClass& graph);
void bind_file(py::module_& module, GraphClass& graph);
void bind_optimizer(py::module_& module);
void bind_covariance(py::module_& module);
void bind_certificate(py::module_& module);
void bind_diagnose(py::module_& module);
void bind_outliers(py::module_& module);
void bind_smoother(py::module_& module);
void bind_viewer(py::module_& module);
/// Call it last: no use of the classes in a module or class may end the process.
void make_classes_safe(py::handle scope);

}  // namespace boxplus::python
