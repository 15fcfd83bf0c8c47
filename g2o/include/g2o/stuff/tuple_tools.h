// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_TUPLE_TOOLS_H
#define G2O_TUPLE_TOOLS_H

#if __cplusplus < 201703L
#pragma GCC system_header  // Otherwise, compilers warn about C++17 in this header.
#endif

#include <cstddef>
#include <iostream>
#include <tuple>
#include <type_traits>
#include <utility>

namespace g2o {

template <typename F, typename T, std::size_t... I>
void tuple_apply_i_(F&& f, T& t, int i, std::index_sequence<I...>) {
  ((i == static_cast<int>(I) ? static_cast<void>(f(std::get<I>(t))) : void()), ...);
}

/// Calls f with the tuple element at an index that is known only at run time.
template <typename F, typename T>
void tuple_apply_i(F&& f, T& t, int i) {
  tuple_apply_i_(f, t, i, std::make_index_sequence<std::tuple_size<std::decay_t<T>>::value>());
}

}  // namespace g2o

#endif  // G2O_TUPLE_TOOLS_H
