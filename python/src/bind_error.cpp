// SPDX-License-Identifier: BSD-3-Clause
// The exceptions of base/error.h. Each also derives from the exception of Python with the same meaning.
#include "bind.h"
#include "boxplus/base/error.h"

namespace boxplus::python {
namespace {

py::object g_error, g_invalid_argument, g_input_error, g_file_error;

py::object new_exception(py::module_& module, const char* name, const py::tuple& bases, const char* doc) {
  const std::string full_name = "boxplus." + std::string(name);
  auto type = py::reinterpret_steal<py::object>(
      PyErr_NewExceptionWithDoc(full_name.c_str(), doc, bases.ptr(), nullptr));
  if (!type) throw py::error_already_set();
  module.attr(name) = type;
  return type;
}

void translate(std::exception_ptr pointer) {  // NOLINT(performance-unnecessary-value-param)
  try {
    if (pointer) std::rethrow_exception(pointer);
  } catch (const InputError& error) {
    py::object instance = g_input_error(error.what());
    instance.attr("line") = error.line();
    instance.attr("column") = error.column();
    PyErr_SetObject(g_input_error.ptr(), instance.ptr());
  } catch (const InvalidArgument& error) {
    PyErr_SetString(g_invalid_argument.ptr(), error.what());
  } catch (const FileError& error) {
    PyErr_SetString(g_file_error.ptr(), error.what());
  } catch (const Error& error) {
    PyErr_SetString(g_error.ptr(), error.what());
  }
}

py::object python_type(PyObject* type) {
  return py::reinterpret_borrow<py::object>(type);
}

}  // namespace

void bind_error(py::module_& module) {
  g_error = new_exception(module, "Error", py::make_tuple(python_type(PyExc_RuntimeError)),
                          "The base class of all exceptions of boxplus.");
  g_invalid_argument =
      new_exception(module, "InvalidArgument", py::make_tuple(g_error, python_type(PyExc_ValueError)),
                    "An argument that breaks the contract of the called function.");
  g_input_error = new_exception(module, "InputError", py::make_tuple(g_error, python_type(PyExc_ValueError)),
                                "Bad input in a file, at `line` and `column`.");
  g_file_error = new_exception(module, "FileError", py::make_tuple(g_error, python_type(PyExc_OSError)),
                               "A file that cannot be opened, read or written.");
  // Python's own objects are never destroyed, because the interpreter may end before the module does.
  for (const py::object& type : {g_error, g_invalid_argument, g_input_error, g_file_error}) type.inc_ref();
  py::register_exception_translator(&translate);
}

}  // namespace boxplus::python
