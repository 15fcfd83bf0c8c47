// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/io/vertex_tag.h"

#include "io/data_fields.h"

namespace boxplus {

VertexTag VertexTag::read(FieldReader& in) {
  VertexTag tag;
  tag.name = in.token("a name");
  in.numbers(tag.position.data(), 3, "the position of a name");
  in.numbers(tag.robot_pose.data(), 3, "the pose of the robot");
  tag.stamp = RobotStamp::read(in);
  in.expect_end();
  return tag;
}

void VertexTag::write(FieldWriter& out) const {
  write_word(out, "a name", name);
  write_finite(out, position);
  write_finite(out, robot_pose);
  stamp.write(out);
}

}  // namespace boxplus
