// SPDX-License-Identifier: BSD-3-Clause
// Options: attributes, and keyword arguments of optimize().
#include <pybind11/stl.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "bind.h"
#include "boxplus/options/option_table.h"
#include "convert.h"
#include "enumerators.h"
#include "members.h"
#include "option_class.h"
#include "options_object.h"

namespace boxplus::python {
namespace {

/// All options but vertices, callback, stop, and custom_linear_solver, which Python cannot write.
constexpr std::tuple kOptions = std::tuple_cat(
    detail::kOptions,
    std::tuple{detail::Option{.name = "edges",
                              .member = &Options::edges,
                              .help = "If the list is not empty, only these edges take part"}});
static_assert(member_count<Options>() == std::tuple_size_v<decltype(kOptions)> + 4,
              "kOptions does not have all members of Options");

/// The names of all options that Python can write.
std::vector<std::string> names() {
  std::vector<std::string> result;
  std::apply([&](const auto&... member) { (result.emplace_back(member.name), ...); }, kOptions);
  result.insert(result.end(), {"vertices", "callback", "stop"});
  return result;
}

void set_vertices(OptionsObject& options, py::handle vertices) {
  const char* const expected = "a list of VertexRefs or ids";
  if (!py::isinstance<py::sequence>(vertices)) throw_type_error("Options.vertices", expected, vertices);
  std::vector<std::variant<VertexRef, Id>> read;
  for (const py::handle vertex : vertices) {
    if (py::isinstance<VertexRef>(vertex))
      read.emplace_back(vertex.cast<VertexRef>());
    else if (is_integer(vertex))
      read.emplace_back(read_integer(vertex, "Options.vertices"));
    else
      throw_type_error("Options.vertices", expected, vertices);
  }
  options.vertices = std::move(read);
}

void set_callback(OptionsObject& options, const py::object& callback) {
  if (!callback.is_none() && PyCallable_Check(callback.ptr()) == 0)
    throw_type_error("Options.callback", "a function or None", callback);
  options.callback = callback;
}

}  // namespace

Options OptionsObject::for_graph(const Graph& graph) const {
  Options result = options;
  for (const auto& vertex : vertices) {
    const VertexRef* const ref = std::get_if<VertexRef>(&vertex);
    result.vertices.push_back(ref ? *ref : vertex_of(graph, py::int_(std::get<Id>(vertex)), "vertices"));
  }
  result.stop = stop ? &stop->is_set : nullptr;
  return result;
}

OptionsObject options_with(py::handle options, const py::kwargs& changes) {
  if (!options.is_none() && !py::isinstance<OptionsObject>(options))
    throw_type_error("options", "an Options or None", options);
  OptionsObject result = options.is_none() ? OptionsObject{} : options.cast<const OptionsObject&>();
  set_options(py::cast(&result, py::return_value_policy::reference), changes, names());
  return result;
}

void bind_options(py::module_& module) {
  bind_enum<AlgorithmKind>(module);
  bind_enum<LinearSolverKind>(module);
  bind_enum<Precision>(module);
  bind_enum<Ordering>(module);
  bind_enum<Start>(module);
  bind_enum<GaugePolicy>(module);
  bind_enum<SchurMode>(module);

  py::class_<StopFlag, std::shared_ptr<StopFlag>>(
      module, "StopFlag", "Options(stop=flag): any thread may stop the run by flag.set().")
      .def(py::init<>())
      .def("set", [](StopFlag& flag) { flag.is_set = true; })
      .def("clear", [](StopFlag& flag) { flag.is_set = false; })
      .def("is_set", [](const StopFlag& flag) { return flag.is_set.load(); });

  py::class_<OptionsObject> type(
      module, "Options",
      "The options of optimize(); boxplus/options/options.h explains each of them. "
      "Values of enumerations may be given as text: algorithm=\"dogleg\".",
      collected<OptionsObject>());
  bind_enum<Options::DampingScale>(type);
  type.def(py::init([](const py::kwargs& changes) { return options_with(py::none(), changes); }));
  const auto bind = [&](const auto& member) {
    const std::string name = "Options." + std::string(member.name);
    type.def_property(
        member.name.data(), [member](const OptionsObject& self) { return self.options.*member.member; },
        [member, name](OptionsObject& self, const py::object& value) {
          read_option(value, name, self.options.*member.member);
        },
        member.help.data());
  };
  std::apply([&](const auto&... member) { (bind(member), ...); }, kOptions);
  type.def_property(
          "vertices", [](const OptionsObject& self) { return self.vertices; }, &set_vertices,
          "Only these vertices move; the others are held. VertexRefs or ids.")
      .def_property(
          "callback", [](const OptionsObject& self) { return self.callback; }, &set_callback,
          "Called after every iteration with an IterationRecord. If it returns False, the run stops.")
      .def_readwrite("stop", &OptionsObject::stop)
      .def("__copy__", [](const OptionsObject& self) { return self; })
      .def("__repr__", [](const py::object& self) { return options_text(self, names()); });
}

}  // namespace boxplus::python
