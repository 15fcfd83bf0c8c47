// SPDX-License-Identifier: BSD-3-Clause
// The words of TORO (Grisetti, Stachniss, Burgard, "Nonlinear constraint network optimization for efficient
// map learning", 2009). They are read, and written as their .g2o counterparts.
#include "boxplus/io/registry.h"
#include "boxplus/types/slam2d.h"

namespace boxplus {

void register_toro(Registry& registry) {
  registry.old_vertex<SE2>("VERTEX2");
  registry.old_edge<InformationOrder::kToro, Between<SE2>, SE2, SE2>("EDGE2");
}

}  // namespace boxplus
