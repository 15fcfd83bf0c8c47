// SPDX-License-Identifier: BSD-3-Clause
// The class Options of Python.
#pragma once

#include <pybind11/pybind11.h>

#include <atomic>
#include <memory>
#include <variant>
#include <vector>

#include "boxplus/graph/graph.h"
#include "boxplus/options/options.h"

namespace boxplus::python {

namespace py = pybind11;

/// A flag that stops runs. Any thread may set it.
struct StopFlag {
  std::atomic<bool> is_set = false;
};

struct OptionsObject {
  Options options;  ///< without vertices, callback and stop
  std::vector<std::variant<VertexRef, Id>> vertices = {};
  py::object callback = py::none();  ///< called with an IterationRecord
  std::shared_ptr<StopFlag> stop = nullptr;

  /// The options of a run, but for the callback. Throws InvalidArgument if an id is none of this graph.
  Options for_graph(const Graph& graph) const;
  template <class Function>
  void for_each_reference(const Function& f) {
    f(callback);
  }
};

/// A copy of `options` (an Options or None), changed by keyword arguments. Throws TypeError for a name that
/// is not an option, and TypeError or ValueError for an unsuitable value.
OptionsObject options_with(py::handle options, const py::kwargs& changes);

}  // namespace boxplus::python
