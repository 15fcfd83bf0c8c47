// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "io/g2o/round_trip.h"

namespace boxplus {
namespace {

TEST(RegisterSlam2d, ReadsAndWritesEachTag) {
  expect_round_trip(
      "PARAMS_SE2OFFSET 5 1 0 0.25\n"
      "PARAMS_SE2OFFSET 6 0 1 0\n"
      "VERTEX_SE2 0 0 0 0\n"
      "VERTEX_SE2 1 1 0.1 0.5\n"
      "VERTEX_XY 2 2 3\n"
      "VERTEX_XY 3 2 4\n"
      "VERTEX_SE2 4 0 0 0.5\n"
      "VERTEX_ODOM_DIFFERENTIAL 8 1 1 0.5\n"
      "EDGE_SE2 0 1 1 0 0.5 1 0.5 0 2 0 3\n"
      "EDGE_SE2_XY 0 2 2 3 1 0 1\n"
      "EDGE_BEARING_SE2_XY 0 2 0.5 100\n"
      "EDGE_PRIOR_SE2 1 1 0 0.5 1 0 0 1 0 1\n"
      "EDGE_PRIOR_SE2_XY 1 1 0 1 0 1\n"
      "EDGE_PRIOR_XY 2 1 0 1 0 1\n"
      "EDGE_POINTXY 2 3 0 1 1 0 1\n"
      "EDGE_SE2_POINTXY_OFFSET 1 2 5 1 1 1 0 1\n"
      "EDGE_SE2_XY_CALIB 1 2 4 1 1 1 0 1\n"
      "EDGE_SE2_OFFSET 0 1 5 6 1 0 0.5 1 0 0 1 0 1\n"
      "EDGE_SE2_OFFSET 0 1 5 5 1 0 0.5 1 0 0 1 0 1\n"
      "EDGE_SE2_CALIB 0 1 4 1 0 0.5 1 0 0 1 0 1\n"
      "EDGE_SE2_ODOM_DIFFERENTIAL_CALIB 0 1 8 1 2 0.1 1 0 0 1 0 1\n"
      "EDGE_SE2_TWOPOINTSXY 0 2 3 1 2 3 4 1 0 0 0 1 0 0 1 0 1\n"
      "EDGE_SE2_LOTSOFXY 0 2 3 || 2 1 2 3 4 1 0 0 0 1 0 0 1 0 1\n");
}

}  // namespace
}  // namespace boxplus
