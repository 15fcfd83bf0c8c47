// SPDX-License-Identifier: BSD-3-Clause
// What a run that has released Python's lock (GIL) does with Python: it calls the callback and looks for
// signals.
#pragma once

#include <exception>
#include <utility>

#include "boxplus/optimize/report.h"
#include "graph_object.h"

namespace boxplus::python {

/// The callback of a run. Exceptions of Python (of the callback, or KeyboardInterrupt) end the run; the
/// estimates are the best that were found. rethrow() throws them again.
class Observer {
 public:
  Observer(GraphObject::Run& run, py::object callback) : run_(&run), callback_(std::move(callback)) {}

  bool has_callback() const { return !callback_.is_none(); }
  /// Called after each iteration. Returns whether the run goes on.
  bool operator()(const IterationRecord& record) {
    const py::gil_scoped_acquire lock;
    run_->set_in_callback(true);
    const bool go_on = guarded([&] {
      const py::object answer = callback_.is_none() ? py::none() : callback_(record);
      return answer.is_none() || py::bool_(answer);
    });
    run_->set_in_callback(false);
    return go_on;
  }
  /// Calls the handlers of signals that have arrived, while the run goes on. Returns whether it may go on.
  bool check_signals() {
    const py::gil_scoped_acquire lock;
    return guarded([] { return true; });
  }
  bool has_raised() const { return raised_ != nullptr; }
  void rethrow() {
    if (raised_) std::rethrow_exception(std::exchange(raised_, nullptr));
  }

 private:
  /// The result of a function that is called after the handlers of signals, or false if one of them throws.
  template <class Function>
  bool guarded(const Function& function) {
    try {
      if (PyErr_CheckSignals() != 0) throw py::error_already_set();
      return function();
    } catch (...) {
      raised_ = std::current_exception();
      return false;
    }
  }

  GraphObject::Run* run_;
  py::object callback_;
  std::exception_ptr raised_;
};

}  // namespace boxplus::python
