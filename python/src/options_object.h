// SPDX-License-Identifier: BSD-3-Clause
// The class Options of Python.
#pragma once

#include <pybind11/pybind11.h>

#include <atomic>
#include <memory>

#include "boxplus/optimize/options.h"

namespace boxplus::python {

namespace py = pybind11;

/// A flag that stops runs. Any thread may set it.
struct StopFlag {
  std::atomic<bool> is_set = false;
};

struct OptionsObject {
  Options options;                   ///< without callback and stop
  py::object callback = py::none();  ///< called with an IterationRecord
  std::shared_ptr<StopFlag> stop = nullptr;
};

/// A copy of `options` (an Options or None), changed by keyword arguments. Throws TypeError for a name that
/// is not an option, and TypeError or ValueError for an unsuitable value.
OptionsObject options_with(py::handle options, const py::kwargs& changes);

}  // namespace boxplus::python
