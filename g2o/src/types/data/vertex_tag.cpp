// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/types/data/vertex_tag.h"

#include <array>

#include "types/data/adapters_data.h"

namespace g2o {

VertexTag::VertexTag() = default;
VertexTag::~VertexTag() = default;

bool VertexTag::read(std::istream& is) {
  return adapters::read_data<boxplus::VertexTag>(is, [&](const boxplus::VertexTag& tag) {
    const auto& p = tag.position;
    _position = Vector3F(adapters::to_float(p[0]), adapters::to_float(p[1]), adapters::to_float(p[2]));
    _positionOfFile = Vector3(p.data());
    _name = tag.name;
    _odom2dPose = SE2(Vector3(tag.robot_pose.data()));
    adapters::take_stamp(tag.stamp, *this);
  });
}

bool VertexTag::write(std::ostream& os) const {
  boxplus::VertexTag tag;
  tag.name = _name;
  const Vector3 pose = _odom2dPose.toVector();
  for (int i = 0; i < 3; ++i) {
    tag.position[i] = adapters::number_of(_position[i], _positionOfFile[i]);
    tag.robot_pose[i] = pose[i];
  }
  tag.stamp = adapters::stamp_of(*this);
  return adapters::write_data(os, tag);
}

}  // namespace g2o
