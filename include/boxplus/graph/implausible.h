// SPDX-License-Identifier: BSD-3-Clause
// Whether an estimate can be right at all, as its type says by a member implausible().
#pragma once

#include <string>

#include "boxplus/base/abi.h"
#include "boxplus/manifold/product.h"

namespace boxplus::detail {

/// What x.implausible() says, or an empty text if the type has no such member.
template <class T>
std::string why_implausible(const T& x) {
  if constexpr (requires { std::string(x.implausible()); }) {
    return std::string(x.implausible());
  } else {
    return {};
  }
}

/// What the first part says that is implausible.
template <class... Parts>
std::string why_implausible(const Product<Parts...>& x) {
  std::string why;
  const auto is_found = [&why](const auto& part) { return !(why = why_implausible(part)).empty(); };
  std::apply([&](const Parts&... part) { static_cast<void>((is_found(part) || ...)); }, x.parts);
  return why;
}

}  // namespace boxplus::detail
