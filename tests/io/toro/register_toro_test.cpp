// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "boxplus/boxplus.h"

namespace boxplus {
namespace {

TEST(RegisterToro, ReadsTheEntriesOfTheInformationInTheOrderOfToro) {
  const GraphFile file =
      parse_graph("VERTEX2 0 0 0 0\nVERTEX2 1 1 0 0\nEDGE2 0 1 1 0 0 10 1 20 30 2 3\n", "g");
  const detail::InformationView omega = file.graph.information(file.edges[0]);
  EXPECT_EQ(omega(0, 0), 10);
  EXPECT_EQ(omega(0, 1), 1);
  EXPECT_EQ(omega(1, 1), 20);
  EXPECT_EQ(omega(2, 2), 30);
  EXPECT_EQ(omega(0, 2), 2);
  EXPECT_EQ(omega(1, 2), 3);
}

TEST(RegisterToro, ReadsRollPitchAndYaw) {
  const GraphFile file = parse_graph(
      "VERTEX3 0 0 0 0 0 0 0\nVERTEX3 1 1 2 3 0.3 -0.4 1.2\nEDGE3 0 1 1 2 3 0.3 -0.4 1.2 "
      "1 0 0 5 0 0 2 0 0 0 0 3 0 0 0 100 0 7 200 0 300\n",
      "g");
  const Eigen::Matrix3d expected =
      (Eigen::AngleAxisd(1.2, Eigen::Vector3d::UnitZ()) * Eigen::AngleAxisd(-0.4, Eigen::Vector3d::UnitY()) *
       Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitX()))
          .toRotationMatrix();
  const SE3& pose = file.graph.estimate(file.graph.vertex<SE3>(1));
  EXPECT_LT((pose.rotation() - expected).norm(), 1e-15);
  EXPECT_EQ(pose.translation(), Vector3(1, 2, 3));
  EXPECT_LT(file.graph.chi2(), 1e-28);
  const detail::InformationView omega = file.graph.information(file.edges[0]);
  EXPECT_EQ(omega(1, 1), 2);
  EXPECT_EQ(omega(0, 3), 2 * 5) << "a small angle is twice its component of the quaternion";
  EXPECT_EQ(omega(3, 3), 4 * 100);
  EXPECT_EQ(omega(3, 5), 4 * 7);
}

}  // namespace
}  // namespace boxplus
