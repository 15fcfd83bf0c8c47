// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/types/data/types_data.h"

#include "g2o/core/factory.h"

namespace g2o {

G2O_REGISTER_TYPE_GROUP(data);
G2O_USE_TYPE_GROUP(data_actions);

G2O_REGISTER_TYPE(ROBOTLASER1, RobotLaser);
G2O_REGISTER_TYPE(RAWLASER1, RawLaser);
G2O_REGISTER_TYPE(VERTEX_TAG, VertexTag);
G2O_REGISTER_TYPE(VERTEX_ELLIPSE, VertexEllipse);

}  // namespace g2o
