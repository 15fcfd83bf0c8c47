// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "io/g2o/round_trip.h"

namespace boxplus {
namespace {

TEST(RegisterSlam3d, ReadsAndWritesEachTag) {
  expect_round_trip(
      "PARAMS_SE3OFFSET 5 0 0 1 0 0 0 1\n"
      "PARAMS_SE3OFFSET 6 0 1 0 0 0 0 1\n"
      "VERTEX_SE3:QUAT 0 0 0 0 0 0 0 1\n"
      "VERTEX_SE3:QUAT 1 1 2 3 0 0 0.6 0.8\n"
      "VERTEX_TRACKXYZ 2 1 1 1\n"
      "VERTEX_TRACKXYZ 3 1 1 2\n"
      "EDGE_SE3:QUAT 0 1 1 2 3 0 0 0.6 0.8 1 0 0 0 0 0 1 0 0 0 0 1 0 0 0 1 0 0 1 0 1\n"
      "EDGE_SE3_TRACKXYZ 0 2 5 1 2 3 1 0 0 1 0 1\n"
      "EDGE_SE3_PRIOR 1 5 1 2 3 0 0 0.6 0.8 1 0 0 0 0 0 1 0 0 0 0 1 0 0 0 1 0 0 1 0 1\n"
      "EDGE_SE3_XYZ_PRIOR 1 5 1 2 3 1 0 0 1 0 1\n"
      "EDGE_SE3_OFFSET 0 1 5 6 1 2 3 0 0 0.6 0.8 1 0 0 0 0 0 1 0 0 0 0 1 0 0 0 1 0 0 1 0 1\n"
      "EDGE_SE3_OFFSET 0 1 5 5 1 2 3 0 0 0.6 0.8 1 0 0 0 0 0 1 0 0 0 0 1 0 0 0 1 0 0 1 0 1\n"
      "EDGE_POINTXYZ 2 3 0 0 1 1 0 0 1 0 1\n"
      "EDGE_POINTXYZ_PRIOR 2 1 1 1 1 0 0 1 0 1\n"
      "EDGE_SE3_LOTSOF_XYZ 0 2 3 || 2 1 2 3 4 5 6 1 0 0 0 0 0 1 0 0 0 0 1 0 0 0 1 0 0 1 0 1\n");
}

}  // namespace
}  // namespace boxplus
