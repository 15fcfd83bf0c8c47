// SPDX-License-Identifier: BSD-3-Clause
// Cycles of references that lead through objects of C++, such as that of a graph and an error function that
// uses the graph.
#pragma once

#include <pybind11/pybind11.h>

#include <type_traits>

namespace boxplus::python {

namespace py = pybind11;

/// The functions by which Python's garbage collector finds and breaks cycles. They hold Python's lock (GIL),
/// must not run code of Python, and may get an object whose value does not exist yet.
template <class T>
class Collected {
 public:
  static int traverse(PyObject* self, visitproc visit, void* arg) {
    Py_VISIT(Py_TYPE(self));
    int result = 0;
    for_each_reference(self, [&](const py::object& object) {
      if (result == 0 && object) result = visit(object.ptr(), arg);
    });
    return result;
  }
  static int clear(PyObject* self) {
    for_each_reference(self, [](auto& object) {
      if constexpr (!std::is_const_v<std::remove_reference_t<decltype(object)>>) object = py::none();
    });
    return 0;
  }
  static void dealloc(PyObject* self) {
    PyObject_GC_UnTrack(self);
    py::detail::pybind11_object_dealloc(self);
  }

 private:
  template <class Function>
  static void for_each_reference(PyObject* self, const Function& function) {
    auto* const instance = reinterpret_cast<py::detail::instance*>(self);
    if (!instance->simple_layout && instance->nonsimple.values_and_holders == nullptr) return;
    if (void* value = instance->get_value_and_holder().value_ptr()) {
      static_cast<T*>(value)->for_each_reference(function);
    }
  }
};

/// An argument of py::class_<T>. T::for_each_reference(f) calls f with each py::object in a T that no other
/// object of C++ owns, too. If a cycle is broken, those that are not const become None.
template <class T>
py::custom_type_setup collected() {
  return py::custom_type_setup([](PyHeapTypeObject* heap_type) {
    PyTypeObject& type = heap_type->ht_type;
    type.tp_flags |= Py_TPFLAGS_HAVE_GC;
    type.tp_traverse = &Collected<T>::traverse;
    type.tp_clear = &Collected<T>::clear;
    type.tp_dealloc = &Collected<T>::dealloc;
  });
}

}  // namespace boxplus::python
