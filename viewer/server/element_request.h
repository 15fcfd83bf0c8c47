// SPDX-License-Identifier: BSD-3-Clause
// What a request says about the vertex or edge that it means (PROTOCOL.md).
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "viewer/scene/element.h"

namespace boxplus::viewer {

/// The parameters of a query, or the members of a command.
using Parameters = std::multimap<std::string, std::string>;

struct ElementRequest {
  std::uint64_t structure;  ///< the number of the structure that the page shows
  ElementName name;
};
/// Throws InvalidArgument if a parameter is missing or wrong.
ElementRequest parse_element_request(const Parameters& parameters);

}  // namespace boxplus::viewer
