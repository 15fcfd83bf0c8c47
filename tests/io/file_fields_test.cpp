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

}  // namespace
}  // namespace boxplus
