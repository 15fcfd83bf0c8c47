// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "boxplus/io/graph_file.h"

namespace boxplus {

/// Reads a text, and checks that each of its tags is known and that the text is written unchanged.
inline void expect_round_trip(const std::string& text) {
  const GraphFile file = parse_graph(text, "g");
  EXPECT_TRUE(file.kept.empty());
  EXPECT_EQ(format_graph(file), text);
}

}  // namespace boxplus
