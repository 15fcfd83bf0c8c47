// SPDX-License-Identifier: BSD-3-Clause
// What the classes of the module do where those of pybind11 would end the process.
#include <algorithm>
#include <string>

#include "bind.h"

namespace boxplus::python {
namespace {

/// pybind11 calls this if an object without a value is used. Its own function would give such an object
/// memory that nothing has written.
void* refuse_object_without_value(std::size_t /*size*/) {
  throw py::type_error(
      "expected an object of boxplus, got one without a value, whose __init__() has not been called");
}

/// __reduce_ex__() of all classes, for pickles and copies. Below protocol 2, Python would call a constructor
/// that pybind11's base class does not have.
py::object reduce(const py::object& self, int protocol) {
  const py::handle base(reinterpret_cast<PyObject*>(&PyBaseObject_Type));
  try {
    return base.attr("__reduce_ex__")(self, std::max(protocol, 2));
  } catch (py::error_already_set& error) {
    const py::type type = py::type::of(self);
    if (!error.matches(PyExc_TypeError) || py::hasattr(type, "__setstate__")) throw;
    throw py::type_error(std::string(py::str(type.attr("__name__"))) + ": cannot be pickled or copied");
  }
}

bool is_bound_class(py::handle value) {
  const auto as_type = [](PyObject* object) { return reinterpret_cast<PyTypeObject*>(object); };
  return PyType_Check(value.ptr()) != 0 &&
         PyType_IsSubtype(as_type(value.ptr()), as_type(py::detail::get_internals().instance_base)) != 0;
}

}  // namespace

void make_classes_safe(py::handle scope) {
  for (const auto& [name, value] : py::dict(scope.attr("__dict__"))) {
    if (!is_bound_class(value)) continue;
    py::detail::get_type_info(reinterpret_cast<PyTypeObject*>(value.ptr()))->operator_new =
        &refuse_object_without_value;
    py::setattr(
        value, "__reduce_ex__",
        py::cpp_function(&reduce, py::name("__reduce_ex__"), py::is_method(value), py::arg("protocol")));
    make_classes_safe(value);
  }
}

}  // namespace boxplus::python
