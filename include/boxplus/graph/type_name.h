// SPDX-License-Identifier: BSD-3-Clause
// A readable name for a type, for messages and reports.
#pragma once

#include <string>
#include <string_view>
#include <typeinfo>

#include "boxplus/base/abi.h"
#include "boxplus/base/matrix.h"

namespace boxplus {
template <class... Parts>
struct Product;
}  // namespace boxplus

namespace boxplus::detail {

/// The readable form of a mangled C++ name, or `mangled` itself if it cannot be demangled.
std::string demangle(const char* mangled);

template <class T>
inline constexpr bool kIsRealVector = false;
template <int N, int Options, int MaxRows, int MaxCols>
inline constexpr bool kIsRealVector<Eigen::Matrix<double, N, 1, Options, MaxRows, MaxCols>> = true;

template <class T>
std::string_view type_name();

/// "Product<SE3, Vector3>" for a Product; otherwise empty.
template <class T>
struct ProductName {
  static constexpr bool kIsProduct = false;
};
template <class... Parts>
struct ProductName<Product<Parts...>> {
  static constexpr bool kIsProduct = true;
  static std::string text() {
    std::string list;
    ((list += (list.empty() ? "" : ", ") + std::string(type_name<Parts>())), ...);
    return "Product<" + list + ">";
  }
};

/// T::kName if T has it; for Eigen's column vectors, "Vector2", "VectorX" and so on; for products, the names
/// of the parts; otherwise T's C++ name.
template <class T>
std::string_view type_name() {
  if constexpr (requires { std::string_view(T::kName); }) {
    return T::kName;
  } else if constexpr (kIsRealVector<T>) {
    static const std::string name =
        "Vector" + (T::RowsAtCompileTime == kDynamic ? "X" : std::to_string(T::RowsAtCompileTime));
    return name;
  } else if constexpr (ProductName<T>::kIsProduct) {
    static const std::string name = ProductName<T>::text();
    return name;
  } else {
    static const std::string name = demangle(typeid(T).name());
    return name;
  }
}

}  // namespace boxplus::detail
