// SPDX-License-Identifier: BSD-3-Clause
// Uses classes of several type libraries without G2O_USE_TYPE_GROUP, saves a graph of these classes, and
// loads it again.
#include <cstdio>
#include <sstream>

#include "g2o/core/sparse_optimizer.h"
#include "g2o/types/sba/types_six_dof_expmap.h"
#include "g2o/types/sclam2d/types_sclam2d.h"
#include "g2o/types/sim3/types_seven_dof_expmap.h"
#include "g2o/types/slam2d_addons/types_slam2d_addons.h"
#include "g2o/types/slam3d_addons/types_slam3d_addons.h"

template <class V>
void add(g2o::SparseOptimizer& optimizer) {
  auto v = g2o::make_unique<V>();
  v->setId(static_cast<int>(optimizer.vertices().size()));
  v->setToOrigin();
  optimizer.addVertex(v.release());
}

int main() {
  g2o::SparseOptimizer optimizer, again;
  add<g2o::VertexSE2>(optimizer);
  add<g2o::VertexSegment2D>(optimizer);
  add<g2o::VertexOdomDifferentialParams>(optimizer);
  add<g2o::VertexSE3>(optimizer);
  add<g2o::VertexPlane>(optimizer);
  add<g2o::VertexSE3Expmap>(optimizer);
  add<g2o::VertexSim3Expmap>(optimizer);
  std::stringstream file;
  const bool saved = optimizer.save(file), loaded = again.load(file);
  std::printf("saved %d, loaded %d, %zu vertices\n", saved, loaded, again.vertices().size());
  return saved && loaded && again.vertices().size() == 7 ? 0 : 1;
}
