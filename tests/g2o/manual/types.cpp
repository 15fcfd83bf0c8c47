// SPDX-License-Identifier: BSD-3-Clause
// Registration after the document's listing 1.
#include "g2o/manual/types.h"

#include "g2o/core/factory.h"

namespace manual {

G2O_REGISTER_TYPE_GROUP(manual);
G2O_REGISTER_TYPE(MANUAL_VERTEX_SE2, VertexSE2);
G2O_REGISTER_TYPE(MANUAL_VERTEX_XY, VertexPointXY);
G2O_REGISTER_TYPE(MANUAL_EDGE_SE2, EdgeSE2);
G2O_REGISTER_TYPE(MANUAL_EDGE_SE2_XY, EdgeSE2PointXY);

}  // namespace manual
