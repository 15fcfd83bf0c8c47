// SPDX-License-Identifier: BSD-3-Clause
// An error function of Python for many edges at a time.
#pragma once

#include <pybind11/numpy.h>

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "boxplus/graph/jacobian_source.h"
#include "convert.h"
#include "vertex_kinds.h"

namespace boxplus::python {

/// The inputs of a batch: the estimates of the vertices of n edges, one array of rows per argument of the
/// error function, and the measurements (n rows), or nothing.
struct Batch {
  std::vector<Numbers> estimates;
  Numbers measurements;
  bool has_measurements = false;
};

/// The output for n edges.
struct BatchResult {
  int rows = 0;
  std::vector<double> errors;  ///< n × rows
  std::vector<double>
      jacobians;  ///< n blocks of rows × cols, column-major; empty if only errors were asked for
};

/// How to call a Python object with a method error(estimates…, measurements) and, optionally, jacobians(…),
/// both for many edges. The object is an argument, because each pool has a reference of its own to it.
class EdgeFunction {
 public:
  enum class Want { kErrors, kJacobians, kNumericJacobians };

  /// `kinds`: of the arguments.
  EdgeFunction(py::handle edge, std::vector<const VertexKind*> kinds);
  EdgeFunction(const EdgeFunction&) = delete;
  EdgeFunction& operator=(const EdgeFunction&) = delete;

  const std::vector<const VertexKind*>& kinds() const { return kinds_; }
  const std::string& name() const { return name_; }
  /// Where the Jacobians come from: numeric if an exact derivative failed.
  detail::JacobianSource source() const { return source_; }
  /// Calls the functions of Python. `rows` is the expected number of rows of the error, or 0 if it is not
  /// known. Exceptions of Python pass through; a result of the wrong shape is a ValueError.
  BatchResult operator()(py::handle edge, const Batch& batch, int rows, Want want);

  /// Whether this thread is in a call of such a function.
  static bool is_called() { return depth_ > 0; }

  struct Cost {
    std::int64_t calls = 0, edges = 0;
    double seconds = 0;
  };
  /// Of all calls so far.
  Cost cost() const { return {calls_, edges_, seconds_}; }

 private:
  inline static thread_local int depth_ = 0;

  std::vector<const VertexKind*> kinds_;
  std::string name_;
  std::atomic<detail::JacobianSource> source_;
  std::atomic<std::int64_t> calls_ = 0, edges_ = 0;
  std::atomic<double> seconds_ = 0;
};

}  // namespace boxplus::python
