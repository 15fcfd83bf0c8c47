// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/types/data/robot_data.h"

namespace g2o {

RobotData::RobotData() = default;
RobotData::~RobotData() = default;

}  // namespace g2o
