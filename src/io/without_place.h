// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>

#include "boxplus/base/error.h"

namespace boxplus {

/// The message of an error without its prefix "file:line:column: ".
inline std::string without_place(const InputError& error, std::string_view file) {
  const std::string place = fmt::format("{}:{}:{}: ", file, error.line(), error.column());
  const std::string_view text = error.what();
  return std::string(text.starts_with(place) ? text.substr(place.size()) : text);
}

}  // namespace boxplus
