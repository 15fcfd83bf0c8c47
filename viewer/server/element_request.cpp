// SPDX-License-Identifier: BSD-3-Clause
#include "viewer/server/element_request.h"

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <optional>
#include <utility>

#include "boxplus/base/error.h"
#include "settings/parse_number.h"

namespace boxplus::viewer {
namespace {

constexpr std::array kNames{
    std::pair{"vertex", ElementName::Kind::kVertex}, std::pair{"id", ElementName::Kind::kId},
    std::pair{"line", ElementName::Kind::kLine}, std::pair{"edge", ElementName::Kind::kEdge}};

std::optional<std::uint64_t> number(const Parameters& parameters, const std::string& name) {
  const auto found = parameters.find(name);
  if (found == parameters.end()) return std::nullopt;
  std::uint64_t value = 0;
  if (!parse_number(found->second, value))
    throw InvalidArgument(fmt::format("{}: expected a number ≥ 0", name));
  return value;
}

ElementName element_name(const Parameters& parameters) {
  std::optional<ElementName> chosen;
  for (const auto& known : kNames) {
    const std::optional<std::uint64_t> value = number(parameters, known.first);
    if (!value) continue;
    if (chosen) throw InvalidArgument("expected only one of vertex, id, line and edge");
    chosen = ElementName{known.second, *value};
  }
  if (!chosen) throw InvalidArgument("expected one of vertex, id, line and edge");
  return *chosen;
}

}  // namespace

ElementRequest parse_element_request(const Parameters& parameters) {
  const std::optional<std::uint64_t> structure = number(parameters, "structure");
  if (!structure) throw InvalidArgument("expected the number of the structure");
  return {*structure, element_name(parameters)};
}

}  // namespace boxplus::viewer
