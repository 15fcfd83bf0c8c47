// SPDX-License-Identifier: BSD-3-Clause
// Formats the facts about a graph: as text for users, and as JSON for scripts.
#pragma once

#include <string>

#include "info/graph_facts.h"

namespace boxplus::app {

std::string facts_text(const GraphFacts& facts, const std::string& name);
/// Returns an indented JSON object that ends with a newline. Values that are not finite become null.
std::string facts_json(const GraphFacts& facts, const GraphFile& file, const std::string& name);

}  // namespace boxplus::app
