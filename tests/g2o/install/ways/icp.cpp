// SPDX-License-Identifier: BSD-3-Clause
// A client that defines its own g2o::EdgeXYZPrior. It first defines the include guard of the g2o header that
// declares a class of this name, so that this header is empty and the two classes do not conflict. Then it
// uses types and macros that are known after including only types_icp.h.
#define G2O_EDGE_XYZ_PRIOR_H_
#include "g2o/types/icp/types_icp.h"

namespace g2o {
class EdgeXYZPrior {
 public:
  int own() const { return 7; }
};
}  // namespace g2o

int main() {
  const g2o::VertexCam camera;
  const g2o::Edge_V_V_GICP pair;
  std::cout << camera.estimate() << PVAR(pair.pl_pl) << FIXED(1.5) << std::endl;
  return g2o::EdgeXYZPrior().own() == 7 ? 0 : 1;
}
