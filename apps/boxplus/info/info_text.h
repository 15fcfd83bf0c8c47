// SPDX-License-Identifier: BSD-3-Clause
// The facts about a graph, as text for users and as JSON for scripts.
#pragma once

#include <string>

#include "info/graph_facts.h"

namespace boxplus::app {

std::string facts_text(const GraphFacts& facts, const std::string& name);
/// One JSON object, indented, with a newline at its end. Values that are not finite become null.
std::string facts_json(const GraphFacts& facts, const GraphFile& file, const std::string& name);

}  // namespace boxplus::app
