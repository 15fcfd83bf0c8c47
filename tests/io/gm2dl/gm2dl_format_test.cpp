// SPDX-License-Identifier: BSD-3-Clause
#include "io/gm2dl/gm2dl_format.h"

#include <gtest/gtest.h>

#include "boxplus/io/data.h"
#include "io/complaint.h"

namespace boxplus {
namespace {

const std::string kScan = "ROBOTLASER1 0 -1 2 1 10 0 0 1 1.5 0 0 0 0 0 0 0 0 0 0 0 0 1 host 2\n";
const std::string kText = "VERTEX 0 0 0 0\n" + kScan + "VERTEX 1 1 0 0.5\nEDGE 0 1 1 0 0.5 10 1 20 30 2 3\n";

TEST(Gm2dlFormat, ReadsPosesScansAndEdgesWithTheInformationInTheOrderOfToro) {
  const GraphFile file = parse_graph(kText, "g");
  EXPECT_EQ(file.format, "Gm2dl");
  EXPECT_EQ(format_graph(file),
            "VERTEX_SE2 0 0 0 0\n" + kScan + "VERTEX_SE2 1 1 0 0.5\nEDGE_SE2 0 1 1 0 0.5 10 1 2 20 3 30\n");
  ASSERT_EQ(read_data(file, "g").size(), 1u);
  EXPECT_EQ(read_data(file, "g")[0].after, 0);
}

TEST(Gm2dlFormat, IsRecognizedByTheTagOfTheFirstElement) {
  EXPECT_TRUE(gm2dl_format().recognize("# a comment\nEDGE 0 1"));
  EXPECT_FALSE(gm2dl_format().recognize("VERTEX2 0 0 0 0\nVERTEX 1 0 0 0\n"));
}

TEST(Gm2dlFormat, WritesPosesScansAndEdgesAsItReadsThem) {
  EXPECT_EQ(format_graph(parse_graph(kText, "g"), {.format = "Gm2dl"}), kText);
  EXPECT_THROW(format_graph(parse_graph("VERTEX3 0 0 0 0 0 0 0\n", "g"), {.format = "Gm2dl"}),
               InvalidArgument);
}

TEST(Gm2dlFormat, ReportsMalformedLinesWithTheirPlace) {
  EXPECT_EQ(complaint("VERTEX 0 0 0\n"), "g:1:13: expected the heading θ, got the end of the line");
}

}  // namespace
}  // namespace boxplus
