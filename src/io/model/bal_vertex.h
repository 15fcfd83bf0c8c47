// SPDX-License-Identifier: BSD-3-Clause
// The vertices and edges of graphs that are read from BAL files.
#pragma once

#include "boxplus/types/ba.h"

namespace boxplus {

using BalVertex = Product<SE3, BalCamera>;
using BalEdge = Reprojection<BalCamera>;

}  // namespace boxplus
