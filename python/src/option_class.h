// SPDX-License-Identifier: BSD-3-Clause
// What the classes of options have in common: attributes that check their values, and keyword arguments.
#pragma once

#include <pybind11/pybind11.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "convert.h"
#include "enumerators.h"

namespace boxplus::python {

/// Reads the value of an option. Throws TypeError or ValueError if it does not suit.
template <class T>
void read_option(py::handle value, const std::string& name, T& out) {
  if constexpr (std::is_enum_v<T>) {
    out = read_enumerator<T>(value, name);
  } else if constexpr (std::is_same_v<T, bool>) {
    if (!py::isinstance<py::bool_>(value)) throw_type_error(name, "a bool", value);
    out = value.cast<bool>();
  } else if constexpr (std::is_integral_v<T>) {
    const std::int64_t number = read_integer(value, name);
    if (!std::in_range<T>(number)) throw_value_error(name, "an int in the range of the option", value);
    out = static_cast<T>(number);
  } else if constexpr (std::is_same_v<T, double>) {  // may be infinite; the engine refuses NaN
    if (!PyFloat_Check(value.ptr()) && !is_integer(value) && !py::hasattr(value, "__float__"))
      throw_type_error(name, "a float", value);
    out = py::float_(py::reinterpret_borrow<py::object>(value));
  } else {
    try {
      out = value.cast<T>();
    } catch (const py::cast_error&) {
      throw_type_error(name, "a list of EdgeRefs", value);
    }
  }
}

/// Sets the attributes of an object of options. Throws TypeError for a name that is not in `names`.
inline void set_options(const py::object& object, const py::kwargs& changes,
                        const std::vector<std::string>& names) {
  for (const auto& [name, value] : changes) {
    if (std::find(names.begin(), names.end(), name.cast<std::string>()) == names.end()) {
      std::string text;
      for (const std::string& known : names) text += (text.empty() ? "" : ", ") + known;
      const std::string type = py::str(py::type::of(object).attr("__name__"));
      throw py::type_error(type + ": expected one of " + text + ", got " + std::string(py::repr(name)));
    }
    py::setattr(object, name, value);
  }
}

/// "Options(max_iterations=3)": the options that differ from their defaults.
inline std::string options_text(const py::object& self, const std::vector<std::string>& names) {
  const py::object defaults = py::type::of(self)();
  std::string text;
  for (const std::string& name : names) {
    const py::object value = self.attr(name.c_str());
    if (value.equal(defaults.attr(name.c_str()))) continue;
    text += (text.empty() ? "" : ", ") + name + "=" + std::string(py::repr(value));
  }
  return std::string(py::str(py::type::of(self).attr("__name__"))) + "(" + text + ")";
}

}  // namespace boxplus::python
