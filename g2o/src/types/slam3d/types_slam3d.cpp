// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/types/slam3d/types_slam3d.h"

#include "g2o/core/factory.h"
#include "types/gnuplot.h"

namespace g2o {

G2O_REGISTER_TYPE_GROUP(slam3d);

G2O_REGISTER_TYPE_NAME("VERTEX_SE3:QUAT", VertexSE3);
G2O_REGISTER_TYPE_NAME("VERTEX_TRACKXYZ", VertexPointXYZ);
G2O_REGISTER_TYPE_NAME("PARAMS_SE3OFFSET", ParameterSE3Offset);
G2O_REGISTER_TYPE_NAME("CACHE_SE3_OFFSET", CacheSE3Offset);
G2O_REGISTER_TYPE_NAME("EDGE_SE3:QUAT", EdgeSE3);
G2O_REGISTER_TYPE_NAME("EDGE_SE3_TRACKXYZ", EdgeSE3PointXYZ);
G2O_REGISTER_TYPE_NAME("EDGE_SE3_PRIOR", EdgeSE3Prior);
G2O_REGISTER_TYPE_NAME("EDGE_SE3_XYZ_PRIOR", EdgeSE3XYZPrior);
G2O_REGISTER_TYPE_NAME("EDGE_SE3_OFFSET", EdgeSE3Offset);
G2O_REGISTER_TYPE_NAME("EDGE_POINTXYZ", EdgePointXYZ);
G2O_REGISTER_TYPE_NAME("EDGE_POINTXYZ_PRIOR", EdgeXYZPrior);
G2O_REGISTER_TYPE_NAME("EDGE_SE3_LOTSOF_XYZ", EdgeSE3LotsOfXYZ);
G2O_REGISTER_TYPE_NAME("PARAMS_CAMERACALIB", ParameterCamera);
G2O_REGISTER_TYPE_NAME("PARAMS_STEREOCAMERACALIB", ParameterStereoCamera);
G2O_REGISTER_TYPE_NAME("CACHE_CAMERA", CacheCamera);
G2O_REGISTER_TYPE_NAME("EDGE_PROJECT_DEPTH", EdgeSE3PointXYZDepth);
G2O_REGISTER_TYPE_NAME("EDGE_PROJECT_DISPARITY", EdgeSE3PointXYZDisparity);

namespace {

struct WriteElement {
  void operator()(const VertexSE3& v, std::ostream& os) const {
    os << internal::toVectorMQT(v.estimate()).transpose() << '\n';
  }
  void operator()(const VertexPointXYZ& v, std::ostream& os) const { os << v.estimate().transpose() << '\n'; }
  void operator()(const EdgeSE3& e, std::ostream& os) const {
    (*this)(*e.vertexXn<0>(), os);
    (*this)(*e.vertexXn<1>(), os);
    os << '\n';
  }
};

using VertexSE3Gnuplot = internal::GnuplotAction<VertexSE3, WriteElement>;
using VertexPointXYZGnuplot = internal::GnuplotAction<VertexPointXYZ, WriteElement>;
using EdgeSE3Gnuplot = internal::GnuplotAction<EdgeSE3, WriteElement>;

}  // namespace

G2O_REGISTER_ACTION(VertexSE3Gnuplot)
G2O_REGISTER_ACTION(VertexPointXYZGnuplot)
G2O_REGISTER_ACTION(EdgeSE3Gnuplot)

}  // namespace g2o
