// SPDX-License-Identifier: BSD-3-Clause
#include "io/g2o/element_reader.h"

#include <gmock/gmock.h>

#include "io/complaint.h"

namespace boxplus {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

constexpr const char* kTwoPoses = "VERTEX_SE2 0 0 0 0\nVERTEX_SE2 1 1 0 0.5\n";

TEST(ElementReader, RefusesBadVertices) {
  EXPECT_EQ(complaint("VERTEX_SE2 0 1 2"), "g:1:17: expected the heading θ, got the end of the line");
  EXPECT_EQ(complaint("\nVERTEX_SE2 0 1 nan 2"), "g:2:16: expected y (a finite number), got 'nan'");
  EXPECT_EQ(complaint("VERTEX_SE2 -2 1 2 3"), "g:1:12: expected an id ≥ 0, got -2");
  EXPECT_THAT(complaint(std::string(kTwoPoses) + "VERTEX_XY 1 0 0"), HasSubstr("g:3:11: expected a new id"));
  EXPECT_THAT(complaint("VERTEX_SE2 0 1 2 3 4"), HasSubstr("g:1:20: expected the end of the line, got '4'"));
}

TEST(ElementReader, RefusesBadEdges) {
  const std::string poses = std::string(kTwoPoses) + "VERTEX_XY 2 0 0\n";
  EXPECT_THAT(complaint(poses + "EDGE_SE2 0 9 1 0 0 1 0 0 1 0 1"),
              HasSubstr("g:4:12: expected the id of a vertex, but there is no vertex 9"));
  EXPECT_THAT(complaint(poses + "EDGE_SE2 0 2 1 0 0 1 0 0 1 0 1"),
              HasSubstr("expected the id of a vertex of type SE2, but vertex 2 is a Vector2"));
  EXPECT_THAT(complaint(poses + "EDGE_SE2 0 0 1 0 0 1 0 0 1 0 1"), HasSubstr("appears twice"));
  EXPECT_THAT(complaint(poses + "EDGE_SE2 0 1 1 0 0 1 0 0 1 0"),
              HasSubstr("expected an entry of the information matrix, got the end"));
  EXPECT_THAT(complaint(poses + "EDGE_SE2 0 1 1 0 0 1 2 0 1 0 1"),
              HasSubstr("g:4:20: information: expected a positive semi-definite"));
  EXPECT_THAT(complaint(poses + "EDGE_SE2_POINTXY_OFFSET 0 2 4 1 1 1 0 1"),
              HasSubstr("there is no parameter 4"));
  EXPECT_THAT(complaint(poses + "EDGE_SE2_LOTSOFXY 0 2 || 999999999999 1 1 1 0 1"),
              HasSubstr("number of points"));
  EXPECT_THAT(complaint(poses + "EDGE_SE2_LOTSOFXY 0 2 || 2 1 1 1 1 1 0 0 0 1 0 0 1 0 1"),
              StartsWith("g:4:"));
  EXPECT_THAT(complaint(poses + "FIX 17"), HasSubstr("there is no vertex 17"));
  EXPECT_THAT(complaint(poses + "FIX"), HasSubstr("got the end of the line"));
}

TEST(ElementReader, RefusesAnIndefiniteInformationEvenIfTheEdgeHasAnUnassignedVertex) {
  EXPECT_THAT(complaint(std::string(kTwoPoses) + "EDGE_SE2 0 -1 1 0 0 1 2 0 1 0 1\n"),
              StartsWith("g:3:21: information: expected a positive semi-definite matrix"));
}

}  // namespace
}  // namespace boxplus
