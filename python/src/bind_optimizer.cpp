// SPDX-License-Identifier: BSD-3-Clause
// optimize() and Optimizer. A run releases Python's lock (GIL), and takes it after each iteration to look for
// signals and to call the callback.
#include <pybind11/stl.h>

#include <memory>
#include <span>
#include <vector>

#include "bind.h"
#include "boxplus/optimize/optimizer.h"
#include "covariance_object.h"
#include "function_edges.h"
#include "observer.h"
#include "options_object.h"
#include "viewers_of_run.h"

namespace boxplus::python {
namespace {

Options native(const OptionsObject& object, const Graph& graph, Observer& observer) {
  Options options = object.for_graph(graph);
  options.callback = [&observer](const IterationRecord& record) { return observer(record); };
  return options;
}

/// The report, with what the error functions of Python have cost in this run.
py::object with_costs(const Report& report, const py::list& before, const Graph& graph) {
  py::object result = py::cast(report);
  result.attr("edge_functions") =
      py::module_::import("boxplus._batched").attr("costs_of_run")(before, costs_of_functions(graph));
  return result;
}

py::object optimize_graph(GraphObject& graph, py::handle options, const py::kwargs& changes) {
  const OptionsObject object = options_with(options, changes);
  const py::list costs = costs_of_functions(graph.read());
  GraphObject::Run run(graph);
  Observer observer(run, object.callback);
  const ViewersOfRun viewers(graph);
  Options native_options = native(object, run.graph(), observer);
  Report report;
  {
    const py::gil_scoped_release release;
    report = optimize(run.graph(), viewers.watch(std::move(native_options)));
    viewers.show(report);
  }
  observer.rethrow();
  return with_costs(report, costs, run.graph());
}

/// An Optimizer and its graph.
class OptimizerObject {
 public:
  OptimizerObject(GraphObject& graph, py::handle options, const py::kwargs& changes)
      : graph_(py::cast(graph, py::return_value_policy::reference)),
        options_(options_with(options, changes)),
        optimizer_(graph.write()) {}

  py::object run() {
    GraphObject& graph = this->graph();
    const py::list costs = costs_of_functions(graph.read());
    GraphObject::Run run(graph);
    const OptionsObject options = options_;
    Observer observer(run, options.callback);
    const ViewersOfRun viewers(graph);
    Options native_options = native(options, run.graph(), observer);
    Report report;
    {
      const py::gil_scoped_release release;
      optimizer_.set_options(viewers.watch(std::move(native_options)));
      report = optimizer_.run();
      viewers.show(report);
    }
    observer.rethrow();
    return with_costs(report, costs, run.graph());
  }
  /// Optimizer::covariance() or marginal_covariances(). It calls no callback, and ends before Ctrl-C is
  /// raised.
  using Query = Covariance (Optimizer::*)(std::span<const VertexRef>) const;
  CovarianceObject query(Query function, py::handle vertices) {
    GraphObject& graph = this->graph();
    const std::vector<VertexRef> refs = vertices_of(graph.read(), vertices, "vertices");
    const OptionsObject options = options_;
    const Options native = options.for_graph(graph.read());
    Covariance result = [&] {
      const GraphObject::Run run(graph);
      const py::gil_scoped_release release;
      optimizer_.set_options(native);
      return (optimizer_.*function)(refs);
    }();
    return {std::move(result), graph_};
  }
  const OptionsObject& options() const { return options_; }
  void set_options(py::handle options, const py::kwargs& changes) {
    options_ = options_with(options, changes);
  }
  template <class Function>
  void for_each_reference(const Function& f) {
    f(graph_);
    f(options_.callback);
  }

 private:
  GraphObject& graph() const { return graph_.cast<GraphObject&>(); }

  const py::object graph_;
  OptionsObject options_;
  Optimizer optimizer_;
};

}  // namespace

void bind_optimizer(py::module_& module) {
  module.def(
      "optimize", &optimize_graph, py::arg("graph").none(false), py::arg("options") = py::none(),
      "optimize(graph, max_iterations=20): minimizes Σ ρ(eᵀΩe) over the estimates, in place. The options are "
      "an Options, keyword arguments, or both. Other threads of Python run meanwhile. Ctrl-C "
      "(KeyboardInterrupt) or an exception of the callback ends the run after the current iteration; the "
      "estimates are then the best that were found.");
  py::class_<OptimizerObject>(
      module, "Optimizer",
      "Optimizer(graph, options=None, **options): keeps its plan and its memory between runs.",
      collected<OptimizerObject>())
      .def(py::init<GraphObject&, py::handle, const py::kwargs&>(), py::arg("graph").none(false),
           py::arg("options") = py::none())
      .def("run", &OptimizerObject::run, "Optimizes; the plan is reused if the structure has not changed.")
      .def(
          "covariance",
          [](OptimizerObject& self, py::handle vertices) {
            return self.query(&Optimizer::covariance, vertices);
          },
          py::arg("vertices"),
          "boxplus.covariance() at the current estimates, with the options of this optimizer. Uses its plan, "
          "and "
          "keeps the factor of H until H changes, so that repeated queries are fast.")
      .def(
          "marginal_covariances",
          [](OptimizerObject& self, py::handle vertices) {
            return self.query(&Optimizer::marginal_covariances, vertices);
          },
          py::arg("vertices"), "Likewise boxplus.marginal_covariances().")
      .def_property_readonly("options", &OptimizerObject::options, py::return_value_policy::copy)
      .def("set_options", &OptimizerObject::set_options, py::arg("options") = py::none());
}

}  // namespace boxplus::python
