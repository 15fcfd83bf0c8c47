// SPDX-License-Identifier: BSD-3-Clause
// A library that registers types with the macros and the tags of listing 1 of the g2o document.
#include "g2o/manual/types.h"

#include "g2o/core/factory.h"

namespace g2o {
using manual::EdgeSE2;
using manual::EdgeSE2PointXY;
using manual::VertexPointXY;
using manual::VertexSE2;

G2O_REGISTER_TYPE_GROUP(slam2d);
G2O_REGISTER_TYPE(VERTEX_SE2, VertexSE2);
G2O_REGISTER_TYPE(VERTEX_XY, VertexPointXY);
G2O_REGISTER_TYPE(EDGE_SE2, EdgeSE2);
G2O_REGISTER_TYPE(EDGE_SE2_XY, EdgeSE2PointXY);
}  // namespace g2o
