// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_VERTEX_TAG_H
#define G2O_VERTEX_TAG_H

#include <string>

#include "g2o/core/eigen_types.h"
#include "g2o/core/hyper_graph_action.h"
#include "g2o/types/data/robot_data.h"
#include "g2o/types/slam2d/se2.h"

namespace g2o {

/// A name at a position. Tag: VERTEX_TAG. read() and write() use all fields of the rest of a line.
class G2O_TYPES_DATA_API VertexTag : public RobotData {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  VertexTag();
  ~VertexTag() override;

  bool read(std::istream& is) override;
  /// Values that have not changed since read() are written as they were read.
  bool write(std::ostream& os) const override;

  /// One word in files.
  const std::string& name() const { return _name; }
  void setName(const std::string& name) { _name = name; }

  /// The position in the frame of the vertex (meters).
  const Vector3F& position() const { return _position; }
  void setPosition(const Vector3F& position) { _position = position; }

  /// The pose of the robot in the frame of the odometry.
  const SE2& odom2dPose() const { return _odom2dPose; }
  void setOdom2dPose(const SE2& odomPose) { _odom2dPose = odomPose; }

 protected:
  std::string _name = "tag";
  Vector3F _position = Vector3F::Zero();
  SE2 _odom2dPose;

 private:
  Vector3 _positionOfFile = Vector3::Zero();  // in double precision
};

/// The action "draw" of VertexTag: the name at its position, if the data belongs to a pose. Its property is
/// TEXT_SIZE (meters).
class G2O_TYPES_DATA_API VertexTagDrawAction : public internal::NamedAction<DrawAction> {
 public:
  VertexTagDrawAction();
};

}  // namespace g2o

#endif  // G2O_VERTEX_TAG_H
