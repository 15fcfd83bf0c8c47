// SPDX-License-Identifier: BSD-3-Clause
// Readable names of edge types that are templates: "Between<SE2>".
#pragma once

#include <array>
#include <string_view>

#include "boxplus/base/matrix.h"

namespace boxplus::detail {

/// The short name of a vertex type, at compile time; empty if it has none.
template <class T>
constexpr std::string_view short_name() {
  if constexpr (requires { std::string_view(T::kName); }) {
    return T::kName;
  } else if constexpr (requires { T::RowsAtCompileTime; }) {
    return T::RowsAtCompileTime == 2 ? "Vector2" : T::RowsAtCompileTime == 3 ? "Vector3" : "Vector";
  } else {
    return "";
  }
}

/// "Edge<T>" as a constant. `Edge::kText` is the name of the template.
template <class Edge, class T>
struct TypeLabel {
  static constexpr std::size_t kSize = Edge::kText.size() + short_name<T>().size() + 2;
  static constexpr std::array<char, kSize> kCharacters = [] {
    std::array<char, kSize> text{};
    std::size_t i = 0;
    for (char c : Edge::kText) text[i++] = c;
    text[i++] = '<';
    for (char c : short_name<T>()) text[i++] = c;
    text[i] = '>';
    return text;
  }();
  static constexpr std::string_view kValue{kCharacters.data(), kSize};
};

}  // namespace boxplus::detail
