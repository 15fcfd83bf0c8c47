// SPDX-License-Identifier: BSD-3-Clause
// The extension module boxplus._boxplus. The package boxplus (python/boxplus/__init__.py) exports its names.
#include "bind.h"

PYBIND11_MODULE(_boxplus, module) {
  using namespace boxplus::python;
  const py::object name = module.attr("__name__");
  module.attr("__name__") = "boxplus";  // so that classes, messages and pickles name the package
  bind_error(module);
  bind_manifold(module);
  bind_landmarks(module);
  bind_camera(module);
  bind_kernel(module);
  bind_information(module);
  bind_edge(module);
  bind_options(module);
  bind_report(module);
  GraphClass graph = bind_graph(module);
  bind_edges(graph);
  bind_bulk(graph);
  bind_file(module, graph);
  bind_optimizer(module);
  bind_covariance(module);
  bind_certificate(module);
  bind_diagnose(module);
  bind_outliers(module);
  bind_smoother(module);
  bind_viewer(module);
  make_classes_safe(module);
  module.attr("__version__") = BOXPLUS_VERSION;
  module.attr("__name__") = name;
}
