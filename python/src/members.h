// SPDX-License-Identifier: BSD-3-Clause
// Lists of the data members of structs. A list is checked against its struct at compile time, so a new member
// of an engine struct cannot be missing in Python.
#pragma once

#include <pybind11/pybind11.h>

#include <concepts>
#include <span>
#include <string>
#include <tuple>
#include <type_traits>
#include <vector>

#include "convert.h"

namespace boxplus::python {

template <class T, class M>
struct Member {
  const char* name;
  M T::*pointer;
};
template <class T, class M>
Member(const char*, M T::*) -> Member<T, M>;

/// Converts to the type of any member.
struct AnyMember {
  template <class T>
  operator T() const;
};

/// The number of members of an aggregate.
template <class T, class... Some>
constexpr std::size_t member_count() {
  if constexpr (requires { T{Some{}..., AnyMember{}}; }) {
    return member_count<T, Some..., AnyMember>();
  } else {
    return sizeof...(Some);
  }
}

/// Defines a read-only attribute for each member. Lists of numbers become arrays, and lists of vectors lists
/// of arrays. `kOthers` members are not in the list.
template <std::size_t kOthers = 0, class Class, class... M>
void bind_members(Class& type, const std::tuple<M...>& members) {
  using T = typename Class::type;
  static_assert(member_count<T>() == sizeof...(M) + kOthers,
                "the list does not have all members of the struct");
  const auto bind = [&]<class Any>(const Member<T, Any>& member) {
    if constexpr (std::convertible_to<const Any&, std::span<const double>>) {
      type.def_property_readonly(member.name, [pointer = member.pointer](const T& self) {
        return to_array(std::span<const double>(self.*pointer));
      });
    } else if constexpr (std::is_same_v<Any, std::vector<Eigen::VectorXd>>) {
      type.def_property_readonly(member.name, [pointer = member.pointer](const T& self) {
        std::vector<Numbers> arrays;
        for (const Eigen::VectorXd& vector : self.*pointer)
          arrays.push_back(to_array(std::span(vector.data(), static_cast<std::size_t>(vector.size()))));
        return arrays;
      });
    } else {
      type.def_readonly(member.name, member.pointer);
    }
  };
  std::apply([&](const auto&... member) { (bind(member), ...); }, members);
}

/// A struct with read-only attributes; its repr lists them.
template <class T, class... M>
py::class_<T> bind_struct(py::handle scope, const char* name, const std::tuple<M...>& members) {
  py::class_<T> type(scope, name, "The struct of C++ with the same members.");
  bind_members(type, members);
  type.def("__repr__", [name, members](const py::object& self) {
    std::string text;
    const auto append = [&](const char* member) {
      text +=
          (text.empty() ? "" : ", ") + std::string(member) + "=" + std::string(py::repr(self.attr(member)));
    };
    std::apply([&](const auto&... member) { (append(member.name), ...); }, members);
    return std::string(name) + "(" + text + ")";
  });
  return type;
}

}  // namespace boxplus::python
