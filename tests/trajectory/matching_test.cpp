// SPDX-License-Identifier: BSD-3-Clause
#include "trajectory/matching.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "boxplus/base/error.h"
#include "trajectory/tum.h"

namespace boxplus {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

Trajectory trajectory(const char* text) {
  return trajectory_of(parse_graph(text, "graph.g2o"), "graph.g2o");
}

std::vector<Id> ids_of(const std::vector<PosePair>& pairs) {
  std::vector<Id> ids;
  for (const PosePair& pair : pairs) {
    EXPECT_EQ(pair.result.id, pair.truth.id);
    ids.push_back(pair.result.id);
  }
  return ids;
}

TEST(MatchedPoses, ArePairedByIdAndLeaveOutAllOthers) {
  const Trajectory result = trajectory("VERTEX_SE2 7 0 0 0\nVERTEX_SE2 3 1 0 0\nVERTEX_SE2 9 2 0 0\n");
  const Trajectory truth = trajectory("VERTEX_SE2 9 0 0 0\nVERTEX_SE2 8 0 0 0\nVERTEX_SE2 3 0 0 0\n");
  const PosePairs matched = matched_poses(result, truth, 0);
  EXPECT_STREQ(matched.matched_by, "id");
  EXPECT_THAT(ids_of(matched.pairs), ElementsAre(3, 9));
  EXPECT_EQ(matched.pairs.front().result.position[0], 1);
}

TEST(MatchedPoses, OfAColmapModelAndABalProblemKeepTheirIds) {
  Trajectory images, cameras;
  images.source = TrajectorySource::kColmap;
  cameras.source = TrajectorySource::kBal;
  for (const Id k : {0, 1, 2}) {
    images.poses.push_back({.id = 3 - k, .name = std::to_string(k)});
    cameras.poses.push_back({.id = k});
  }
  const auto ids = [](const Trajectory& result, const Trajectory& truth) {
    std::vector<Id> all;
    for (const PosePair& pair : matched_poses(result, truth, 0).pairs)
      all.insert(all.end(), {pair.result.id, pair.truth.id});
    return all;
  };
  EXPECT_THAT(ids(images, cameras), ElementsAre(3, 0, 2, 1, 1, 2));
  EXPECT_THAT(ids(cameras, images), ElementsAre(0, 3, 1, 2, 2, 1));
}

TEST(MatchedPoses, AreNoPosesInThePlaneAndInSpace) {
  const Trajectory plane = trajectory("VERTEX_SE2 0 0 0 0\n");
  const Trajectory space = trajectory("VERTEX_SE3:QUAT 0 0 0 0 0 0 0 1\n");
  EXPECT_THROW(matched_poses(plane, space, 0), InvalidArgument);
}

TEST(MatchedPoses, OfTumFilesArePairedByTime) {
  const Trajectory result = parse_tum("0.001 0 0 0 0 0 0 1\n1 1 0 0 0 0 0 1\n", "a.txt");
  const Trajectory truth = parse_tum("# time x y z q\n0 5 0 0 0 0 0 1\n0.5 6 0 0 0 0 0 1\n", "b.txt");
  const std::vector<PosePair> pairs = matched_poses(result, truth, 0.01).pairs;
  ASSERT_EQ(pairs.size(), 1U);
  EXPECT_EQ(pairs.front().truth.position[0], 5);
}

TEST(TrajectoryOf, RefusesGraphsWithoutPoses) {
  EXPECT_THAT([] { trajectory("VERTEX_XY 0 1 2\n"); },
              ThrowsMessage<FileError>(HasSubstr("graph.g2o: expected poses")));
  EXPECT_THAT([] { trajectory("EDGE_SE2 0 1 1 0 0 1 0 0 1 0 1\n"); },
              ThrowsMessage<FileError>(HasSubstr("edges only")));
}

TEST(RefuseTum, NamesTheFile) {
  EXPECT_NO_THROW(refuse_tum("VERTEX_SE2 0 0 0 0\n", "a"));
  EXPECT_THAT([] { refuse_tum("# a comment\n1 0 0 0 0 0 0 1\n", "a.txt"); },
              ThrowsMessage<FileError>(HasSubstr("a.txt: expected a graph")));
}

}  // namespace
}  // namespace boxplus
