// SPDX-License-Identifier: BSD-3-Clause
// A readable name for a type, for messages and reports.
#pragma once

#include <string>
#include <string_view>
#include <typeinfo>

#include "boxplus/base/abi.h"
#include "boxplus/base/matrix.h"

namespace boxplus::detail {

/// The readable form of a mangled C++ name, or `mangled` itself if it cannot be demangled.
std::string demangle(const char* mangled);

template <class T>
inline constexpr bool kIsRealVector = false;
template <int N, int Options, int MaxRows, int MaxCols>
inline constexpr bool kIsRealVector<Eigen::Matrix<double, N, 1, Options, MaxRows, MaxCols>> = true;

/// T::kName if T has it; for Eigen's column vectors, "Vector2", "VectorX" and so on; otherwise T's C++ name.
template <class T>
std::string_view type_name() {
  if constexpr (requires { std::string_view(T::kName); }) {
    return T::kName;
  } else if constexpr (kIsRealVector<T>) {
    static const std::string name =
        "Vector" + (T::RowsAtCompileTime == kDynamic ? "X" : std::to_string(T::RowsAtCompileTime));
    return name;
  } else {
    static const std::string name = demangle(typeid(T).name());
    return name;
  }
}

}  // namespace boxplus::detail
