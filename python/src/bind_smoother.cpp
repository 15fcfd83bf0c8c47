// SPDX-License-Identifier: BSD-3-Clause
// Smoother and marginalize(): graphs that grow and change while they are optimized. An update releases
// Python's lock (GIL).
#include <pybind11/stl.h>

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bind.h"
#include "boxplus/incremental/marginalize.h"
#include "boxplus/incremental/smoother.h"
#include "convert.h"
#include "enumerators.h"
#include "function_edges.h"
#include "members.h"
#include "option_class.h"
#include "options_object.h"
#include "viewers_of_run.h"

namespace boxplus::python {
namespace {

constexpr std::tuple kDistance{Member{"length", &TangentDistance::length},
                               Member{"angle", &TangentDistance::angle},
                               Member{"other", &TangentDistance::other}};
constexpr std::tuple kOptions{Member{"relinearize", &SmootherOptions::relinearize},
                              Member{"noticeable", &SmootherOptions::noticeable},
                              Member{"max_iterations", &SmootherOptions::max_iterations},
                              Member{"max_flops", &SmootherOptions::max_flops},
                              Member{"time_limit_s", &SmootherOptions::time_limit_s},
                              Member{"numeric_jacobians", &SmootherOptions::numeric_jacobians},
                              Member{"sets_outliers_aside", &SmootherOptions::sets_outliers_aside},
                              Member{"false_alarm", &SmootherOptions::false_alarm},
                              Member{"lag_s", &SmootherOptions::lag_s}};
static_assert(member_count<SmootherOptions>() == std::tuple_size_v<decltype(kOptions)> + 2,
              "kOptions does not have all members of SmootherOptions but lag and stop");
constexpr std::tuple kReport{Member{"reason", &SmootherReport::reason},
                             Member{"message", &SmootherReport::message},
                             Member{"iterations", &SmootherReport::iterations},
                             Member{"vertices", &SmootherReport::vertices},
                             Member{"edges", &SmootherReport::edges},
                             Member{"relinearized", &SmootherReport::relinearized},
                             Member{"ordered", &SmootherReport::ordered},
                             Member{"refactored", &SmootherReport::refactored},
                             Member{"refactored_share", &SmootherReport::refactored_share},
                             Member{"set_aside", &SmootherReport::set_aside},
                             Member{"taken_back", &SmootherReport::taken_back},
                             Member{"marginalized", &SmootherReport::marginalized},
                             Member{"moved", &SmootherReport::moved},
                             Member{"flops", &SmootherReport::flops},
                             Member{"started_over", &SmootherReport::started_over},
                             Member{"time_s", &SmootherReport::time_s},
                             Member{"held", &SmootherReport::held},
                             Member{"held_directions", &SmootherReport::held_directions}};
constexpr std::tuple kHeld{Member{"vertex", &detail::GaugeVertex::vertex},
                           Member{"id", &detail::GaugeVertex::id}};
constexpr std::tuple kPreview{Member{"chi2", &EdgePreview::chi2},
                              Member{"chi2_increase", &EdgePreview::chi2_increase},
                              Member{"rows", &EdgePreview::rows}, Member{"steps", &EdgePreview::steps}};

/// The class SmootherOptions of Python.
struct SmootherOptionsObject {
  SmootherOptions options;  ///< without stop
  std::shared_ptr<StopFlag> stop = nullptr;

  SmootherOptions native() const {
    SmootherOptions result = options;
    result.stop = stop ? &stop->is_set : nullptr;
    return result;
  }
};

/// The names of all options.
std::vector<std::string> names() {
  std::vector<std::string> result;
  std::apply([&](const auto&... member) { (result.emplace_back(member.name), ...); }, kOptions);
  result.insert(result.end(), {"lag", "stop"});
  return result;
}

SmootherOptionsObject options_of(py::handle options, const py::kwargs& changes) {
  if (!options.is_none() && !py::isinstance<SmootherOptionsObject>(options))
    throw_type_error("options", "a SmootherOptions or None", options);
  SmootherOptionsObject result =
      options.is_none() ? SmootherOptionsObject{} : options.cast<const SmootherOptionsObject&>();
  set_options(py::cast(&result, py::return_value_policy::reference), changes, names());
  return result;
}

constexpr std::size_t kNoLag = std::numeric_limits<std::size_t>::max();

std::optional<std::size_t> lag(const SmootherOptionsObject& self) {
  return self.options.lag == kNoLag ? std::nullopt : std::optional(self.options.lag);
}

void set_lag(SmootherOptionsObject& self, const py::object& value) {
  if (value.is_none())
    self.options.lag = kNoLag;
  else
    read_option(value, "SmootherOptions.lag", self.options.lag);
}

/// A Smoother and its graph.
class SmootherObject {
 public:
  SmootherObject(GraphObject& graph, py::handle options, const py::kwargs& changes)
      : graph_(py::cast(graph, py::return_value_policy::reference)),
        options_(options_of(options, changes)),
        smoother_(std::make_shared<Smoother>(graph.write(), options_.native())) {}
  ~SmootherObject() { graph().destroy(std::move(smoother_)); }
  SmootherObject(const SmootherObject&) = delete;
  SmootherObject& operator=(const SmootherObject&) = delete;

  SmootherReport run(SmootherReport (Smoother::*function)()) {
    GraphObject::Run run(graph());
    const SmootherOptionsObject options = options_;  // keeps the flag
    const FreshEdges fresh(run.graph());
    smoother_->set_options(options.native());
    const ViewersOfRun viewers(graph());
    const py::gil_scoped_release release;
    const SmootherReport report = (smoother_.get()->*function)();
    viewers.follow();
    return report;
  }
  void set_time(py::handle vertex, py::handle seconds) {
    smoother_->set_time(vertex_of(graph().read(), vertex, "vertex"), read_number(seconds, "seconds"));
  }
  Numbers covariance(py::handle vertices) const {
    return to_array(smoother_->covariance(vertices_of(graph().read(), vertices, "vertices")));
  }
  EdgePreview preview(const EdgeRef& edge) const {
    const Graph& native = graph().read();
    const GraphObject::Reading reading(graph());
    const FreshEdge fresh(native, edge);
    return smoother_->preview(edge);
  }
  std::vector<EdgeRef> set_aside() const {
    std::ignore = graph().read();  // throws during a run
    return smoother_->set_aside();
  }
  const SmootherOptionsObject& options() const { return options_; }
  void set_options(py::handle options, const py::kwargs& changes) { options_ = options_of(options, changes); }
  template <class Function>
  void for_each_reference(const Function& f) {
    f(graph_);
  }

 private:
  GraphObject& graph() const { return graph_.cast<GraphObject&>(); }

  const py::object graph_;
  SmootherOptionsObject options_;
  std::shared_ptr<Smoother> smoother_;
};

std::optional<EdgeRef> marginalize_vertices(GraphObject& graph, py::handle vertices) {
  const std::vector<VertexRef> refs = vertices_of(graph.read(), vertices, "vertices");
  GraphObject::Run run(graph);
  const py::gil_scoped_release release;
  return marginalize(run.graph(), refs);
}

void bind_smoother_options(py::module_& module) {
  bind_struct<TangentDistance>(module, "TangentDistance", kDistance)
      .def(py::init([](double length, double angle, double other) {
             return TangentDistance{length, angle, other};
           }),
           py::arg("length") = 0.0, py::arg("angle") = 0.0, py::arg("other") = 0.0)
      .def(
          "__eq__",
          [](const TangentDistance& a, const TangentDistance& b) {
            return a.length == b.length && a.angle == b.angle && a.other == b.other;
          },
          py::is_operator());
  py::class_<SmootherOptionsObject> type(
      module, "SmootherOptions",
      "The options of a Smoother; boxplus/incremental/smoother_options.h explains each of them.");
  type.def(py::init([](const py::kwargs& changes) { return options_of(py::none(), changes); }));
  const auto bind = [&]<class Any>(const Member<SmootherOptions, Any>& member) {
    const auto set = [pointer = member.pointer, name = std::string("SmootherOptions.") + member.name](
                         SmootherOptionsObject& self, const py::object& value) {
      if constexpr (std::is_same_v<Any, TangentDistance>) {
        if (!py::isinstance<TangentDistance>(value)) throw_type_error(name, "a TangentDistance", value);
        self.options.*pointer = value.cast<TangentDistance>();
      } else {
        read_option(value, name, self.options.*pointer);
      }
    };
    type.def_property(
        member.name,
        [pointer = member.pointer](const SmootherOptionsObject& self) { return self.options.*pointer; }, set);
  };
  std::apply([&](const auto&... member) { (bind(member), ...); }, kOptions);
  type.def_property("lag", &lag, &set_lag, "The number of poses that remain; None without a lag.")
      .def_readwrite("stop", &SmootherOptionsObject::stop)
      .def("__copy__", [](const SmootherOptionsObject& self) { return self; })
      .def("__repr__", [](const py::object& self) { return options_text(self, names()); });
}

}  // namespace

void bind_smoother(py::module_& module) {
  bind_smoother_options(module);
  bind_struct<detail::GaugeVertex>(module, "GaugeVertex", kHeld);
  bind_enum<SmootherReport::Reason>(bind_struct<SmootherReport>(module, "SmootherReport", kReport)
                                        .def("converged", &SmootherReport::converged));
  bind_struct<EdgePreview>(module, "EdgePreview", kPreview);
  py::class_<SmootherObject>(
      module, "Smoother",
      "Smoother(graph, options=None, **options): keeps a graph at its optimum while it changes. The time of "
      "an update depends on what the edits change, not on the size of the graph. A graph has at most one.",
      collected<SmootherObject>())
      .def(py::init<GraphObject&, py::handle, const py::kwargs&>(), py::arg("graph").none(false),
           py::arg("options") = py::none())
      .def(
          "update", [](SmootherObject& self) { return self.run(&Smoother::update); },
          "After any edits of the graph: brings its estimates to the optimum. If an error function raises an "
          "exception, the estimates are as before, and the next update begins anew.")
      .def(
          "finish", [](SmootherObject& self) { return self.run(&Smoother::finish); },
          "Like update(), but to the last digits, as optimize() does.")
      .def("set_time", &SmootherObject::set_time, py::arg("vertex"), py::arg("seconds"),
           "Sets the time of a vertex, for the options lag and lag_s.")
      .def("covariance", &SmootherObject::covariance, py::arg("vertices"),
           "The joint covariance of a few vertices as of the last update, in their order. Fixed and held "
           "vertices have zeros.")
      .def("preview", &SmootherObject::preview, py::arg("edge"),
           "What a disabled edge would cost and change. boxplus/incremental/smoother.h explains it.")
      .def("set_aside", &SmootherObject::set_aside, "All loop closures that are set aside.")
      .def_property_readonly("options", &SmootherObject::options, py::return_value_policy::copy)
      .def("set_options", &SmootherObject::set_options, py::arg("options") = py::none());

  module.def("marginalize", &marginalize_vertices, py::arg("graph").none(false), py::arg("vertices"),
             "Removes vertices with their edges, but keeps what they say about their neighbors, as a dense "
             "prior. Returns the EdgeRef of the prior, or None. The graph must be at its optimum.");
  module.def(
      "to_string", [](SmootherReport::Reason reason) { return std::string(to_string(reason)); },
      py::arg("value"));
}

}  // namespace boxplus::python
