// SPDX-License-Identifier: BSD-3-Clause
// Lists of the data members of structs. A list is checked against its struct at compile time, so a new member
// of an engine struct cannot be missing in Python.
#pragma once

#include <pybind11/pybind11.h>

#include <tuple>

namespace boxplus::python {

namespace py = pybind11;

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

/// Defines a read-only attribute for each member. `kOthers` members are not in the list.
template <std::size_t kOthers = 0, class Class, class... M>
void bind_members(Class& type, const std::tuple<M...>& members) {
  using T = typename Class::type;
  static_assert(member_count<T>() == sizeof...(M) + kOthers,
                "the list does not have all members of the struct");
  std::apply([&](const auto&... member) { (type.def_readonly(member.name, member.pointer), ...); }, members);
}

}  // namespace boxplus::python
