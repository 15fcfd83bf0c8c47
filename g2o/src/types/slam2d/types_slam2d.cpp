// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/types/slam2d/types_slam2d.h"

#include "g2o/core/factory.h"
#include "types/gnuplot.h"

namespace g2o {

G2O_REGISTER_TYPE_GROUP(slam2d);

G2O_REGISTER_TYPE(VERTEX_SE2, VertexSE2);
G2O_REGISTER_TYPE(VERTEX_XY, VertexPointXY);
G2O_REGISTER_TYPE(PARAMS_SE2OFFSET, ParameterSE2Offset);
G2O_REGISTER_TYPE(CACHE_SE2_OFFSET, CacheSE2Offset);
G2O_REGISTER_TYPE(EDGE_SE2, EdgeSE2);
G2O_REGISTER_TYPE(EDGE_SE2_XY, EdgeSE2PointXY);
G2O_REGISTER_TYPE(EDGE_BEARING_SE2_XY, EdgeSE2PointXYBearing);
G2O_REGISTER_TYPE(EDGE_PRIOR_SE2, EdgeSE2Prior);
G2O_REGISTER_TYPE(EDGE_PRIOR_SE2_XY, EdgeSE2XYPrior);
G2O_REGISTER_TYPE(EDGE_PRIOR_XY, EdgeXYPrior);
G2O_REGISTER_TYPE(EDGE_POINTXY, EdgePointXY);
G2O_REGISTER_TYPE(EDGE_SE2_XY_CALIB, EdgeSE2PointXYCalib);
G2O_REGISTER_TYPE(EDGE_SE2_OFFSET, EdgeSE2Offset);
G2O_REGISTER_TYPE(EDGE_SE2_POINTXY_OFFSET, EdgeSE2PointXYOffset);
G2O_REGISTER_TYPE(EDGE_SE2_TWOPOINTSXY, EdgeSE2TwoPointsXY);
G2O_REGISTER_TYPE(EDGE_SE2_LOTSOFXY, EdgeSE2LotsOfXY);

namespace {

struct WriteElement {
  void operator()(const VertexSE2& v, std::ostream& os) const {
    os << v.estimate().translation().transpose() << " " << v.estimate().rotation().angle() << '\n';
  }
  void operator()(const VertexPointXY& v, std::ostream& os) const { os << v.estimate().transpose() << '\n'; }
  void operator()(const EdgeSE2& e, std::ostream& os) const {
    (*this)(*e.vertexXn<0>(), os);
    (*this)(*e.vertexXn<1>(), os);
    os << '\n';
  }
  template <class Observation>
  void operator()(const Observation& e, std::ostream& os) const {
    os << e.template vertexXn<0>()->estimate().translation().transpose() << '\n'
       << e.template vertexXn<1>()->estimate().transpose() << "\n\n";
  }
};

using VertexSE2Gnuplot = internal::GnuplotAction<VertexSE2, WriteElement>;
using VertexPointXYGnuplot = internal::GnuplotAction<VertexPointXY, WriteElement>;
using EdgeSE2Gnuplot = internal::GnuplotAction<EdgeSE2, WriteElement>;
using EdgeSE2PointXYGnuplot = internal::GnuplotAction<EdgeSE2PointXY, WriteElement>;
using EdgeSE2PointXYBearingGnuplot = internal::GnuplotAction<EdgeSE2PointXYBearing, WriteElement>;

}  // namespace

G2O_REGISTER_ACTION(VertexSE2Gnuplot)
G2O_REGISTER_ACTION(VertexPointXYGnuplot)
G2O_REGISTER_ACTION(EdgeSE2Gnuplot)
G2O_REGISTER_ACTION(EdgeSE2PointXYGnuplot)
G2O_REGISTER_ACTION(EdgeSE2PointXYBearingGnuplot)

}  // namespace g2o
