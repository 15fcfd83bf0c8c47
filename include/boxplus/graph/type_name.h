// SPDX-License-Identifier: BSD-3-Clause
// A readable name for a type, for messages and reports.
#pragma once

#include <string>
#include <string_view>
#include <typeinfo>

#include "boxplus/base/abi.h"

namespace boxplus {

/// `mangled` in plain C++, or itself where that fails.
std::string demangle(const char* mangled);

/// T::kName where T has one, else T's C++ name.
template <class T>
std::string_view type_name() {
  if constexpr (requires { std::string_view(T::kName); }) {
    return T::kName;
  } else {
    static const std::string name = demangle(typeid(T).name());
    return name;
  }
}

}  // namespace boxplus
