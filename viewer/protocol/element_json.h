// SPDX-License-Identifier: BSD-3-Clause
// A vertex or an edge as JSON (PROTOCOL.md).
#pragma once

#include <cstdint>
#include <string>

#include "viewer/scene/element.h"
#include "viewer/scene/verdicts.h"

namespace boxplus::viewer {

/// Throws InvalidArgument if the graph has no such element.
std::string element_json(const Graph& graph, const Structure& structure, const ElementName& name,
                         std::uint64_t structure_number, const Verdicts& verdicts = {});

}  // namespace boxplus::viewer
