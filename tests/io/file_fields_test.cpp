// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/io/file_fields.h"

#include <gmock/gmock.h>

#include "io/complaint.h"

namespace boxplus {
namespace {

using testing::HasSubstr;
using testing::SizeIs;

TEST(FileFields, NormalizeQuaternionsOfAlmostUnitLengthAndRefuseOthers) {
  const GraphFile file = parse_graph("VERTEX_SE3:QUAT 0 1 2 3 0 0 0 1.0005", "g");
  EXPECT_EQ(file.graph.estimate(file.graph.vertex<SE3>(0)).quaternion().w, 1);
  ASSERT_THAT(file.notes, SizeIs(1));
  EXPECT_EQ(file.notes[0].line, 1);
  EXPECT_EQ(file.notes[0].text, "a quaternion of length 1.0005 was normalized");
  EXPECT_THAT(complaint("VERTEX_SE3:QUAT 0 1 2 3 0 0 0 0"),
              HasSubstr("g:1:25: expected a quaternion of length 1"));
  EXPECT_THAT(complaint("VERTEX_SE3:QUAT 0 1 2 3 0 0 1 1"), HasSubstr("got one of length 1.414"));
}

TEST(FileFields, KeepPlanesInAnyScaleAndRefuseThoseWithoutANormal) {
  const std::string scaled = "VERTEX_PLANE 0 3 0 4 -10 0.2 0.2 0.2\n";
  const GraphFile file = parse_graph(scaled, "g");
  EXPECT_TRUE(file.notes.empty());
  EXPECT_EQ(file.graph.estimate(file.graph.vertex<Plane3>(0)).unit().coefficients[3], -2);
  EXPECT_EQ(format_graph(file), scaled);
  EXPECT_THAT(complaint("VERTEX_PLANE 0 0 0 0 1 0.2 0.2 0.2"), HasSubstr("g:1:16: expected a normal"));
  EXPECT_THAT(complaint("VERTEX_PLANE 0 1e300 0 0 1 0.2 0.2 0.2"), HasSubstr("g:1:16: expected a normal"));
}

TEST(FileFields, MakeMomentsOfLinesOrthogonalIfTheyAreAlmostOrthogonalAndRefuseOthers) {
  const std::string rounded = "VERTEX_LINE3D 0 -1.84 -0.62001 1.2 0.36 0.48 0.8\n";
  const GraphFile kept = parse_graph(rounded, "g");
  EXPECT_TRUE(kept.notes.empty());
  EXPECT_EQ(format_graph(kept), rounded);
  const GraphFile file = parse_graph("VERTEX_LINE3D 0 0 2 0.001 0 0 1", "g");
  ASSERT_THAT(file.notes, SizeIs(1));
  EXPECT_EQ(file.notes[0].text, "a moment was made orthogonal to the direction of its line");
  EXPECT_EQ(file.graph.estimate(file.graph.vertex<Line3>(0)).moment, Vector3(0, 2, 0));
  EXPECT_THAT(complaint("VERTEX_LINE3D 0 0 2 0.1 0 0 1"),
              HasSubstr("g:1:17: expected a moment that is orthogonal"));
  EXPECT_THAT(complaint("VERTEX_LINE3D 0 0 2 1 0 0 0"), HasSubstr("g:1:23: expected a direction"));
}

}  // namespace
}  // namespace boxplus
