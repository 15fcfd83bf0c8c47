// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "boxplus/base/error.h"
#include "viewer/workspace/settled.h"
#include "viewer/workspace/workspace.h"

namespace boxplus::viewer {
namespace {

using testing::HasSubstr;

/// small_graph() at its optimum if the last edge measured 2, and a pose that it does not have.
constexpr const char* kTruth =
    "VERTEX_SE2 0 0 0 0\nVERTEX_SE2 1 1 0 0\nVERTEX_SE2 2 2 0 0\nVERTEX_SE2 7 3 0 0\n";

class WorkspaceWithTruth : public testing::Test {
 protected:
  WorkspaceWithTruth() {
    workspace_.show(small_graph(), "small.g2o");
    settled(reader_);
    workspace_.open_truth("truth.g2o", kTruth);
    opened_ = settled_messages(reader_);
  }

  std::string last_line(const Settled& messages) const {
    return messages.log.empty() ? "" : messages.log.back();
  }

  Workspace workspace_;
  Workspace::Reader reader_{workspace_, ""};
  Settled opened_;
};

TEST_F(WorkspaceWithTruth, SendsTheTruthAndCountsWhatMatches) {
  EXPECT_TRUE(opened_.state["error"].is_null());
  EXPECT_EQ(opened_.truth["name"], "truth.g2o");
  EXPECT_EQ(opened_.truth["matched_by"], "id");
  EXPECT_EQ(opened_.truth["matched"], 3);
  EXPECT_EQ(opened_.truth["poses"], 3);
  EXPECT_EQ(opened_.truth["true_poses"], 4);
  EXPECT_EQ(opened_.truth["structure"], opened_.frame["structure"]);
  EXPECT_EQ(opened_.truth["arrays"]["positions"]["count"], 9);
  EXPECT_THAT(last_line(opened_), HasSubstr("truth.g2o is the truth: 3 of 3 poses match 3 of 4 true poses"));
  Workspace::Reader newcomer(workspace_, "");
  const Settled messages = settled_messages(newcomer);
  EXPECT_EQ(messages.truth, opened_.truth);
  EXPECT_EQ(messages.frame, opened_.frame);
}

TEST_F(WorkspaceWithTruth, ComparesEachFrame) {
  const double before = opened_.frame["truth"]["ate_m"].get<double>();
  workspace_.optimize({});
  const Json optimized = settled_frame(reader_)["truth"];
  // The poses are on a line, 7/6 m apart instead of 1 m: the errors are −1/6 m, 0 and 1/6 m.
  EXPECT_NEAR(optimized["ate_m"].get<double>(), std::sqrt(2.0 / 3) / 6, 1e-6);
  EXPECT_NEAR(optimized["rpe_m"].get<double>(), 1.0 / 6, 1e-6);
  EXPECT_NEAR(optimized["rpe_rad"].get<double>(), 0, 1e-6);
  EXPECT_GT(before, 1);
  workspace_.reset();
  EXPECT_EQ(settled_frame(reader_)["truth"]["ate_m"], before);
}

TEST_F(WorkspaceWithTruth, KeepsTheTruthIfAnotherOneIsRefused) {
  const auto expect_refusal = [&](const char* name, const char* text, const char* message) {
    workspace_.open_truth(name, text);
    const Settled messages = settled_messages(reader_);
    EXPECT_THAT(messages.state["error"].get<std::string>(), HasSubstr(message));
    EXPECT_TRUE(messages.truth.is_null());
    EXPECT_TRUE(messages.frame.is_null());
  };
  expect_refusal("bad.g2o", "VERTEX_SE2 0 0 zero 0\n", "bad.g2o:1:16: expected");
  expect_refusal("far.g2o", "VERTEX_SE2 8 0 0 0\n",
                 "far.g2o: expected poses that match small.g2o by id, found none");
  expect_refusal("space.g2o", "VERTEX_SE3:QUAT 0 0 0 0 0 0 0 1\n",
                 "space.g2o: expected a truth for small.g2o, which has poses in the plane");
  expect_refusal("points.g2o", "VERTEX_XY 0 1 2\n", "points.g2o: expected poses");
  expect_refusal("times.txt", "1 0 0 0 0 0 0 1\n", "times.txt: expected a graph");
  expect_refusal("empty.g2o", "", "empty.g2o");
  workspace_.step({});
  EXPECT_FALSE(settled_frame(reader_)["truth"].is_null());
}

TEST_F(WorkspaceWithTruth, SendsTheTruthInTheOrderOfTheNewStructureAfterAnEdit) {
  workspace_.edit(1, {Edit::Kind::kRemove, {ElementName::Kind::kId, 1}});
  const Settled messages = settled_messages(reader_);
  EXPECT_EQ(messages.truth["structure"], messages.structure["structure"]);
  EXPECT_EQ(messages.truth["arrays"]["positions"]["count"], 6);
  EXPECT_TRUE(messages.frame["truth"]["ate_m"].is_number());
  workspace_.edit(2, {Edit::Kind::kRemove, {ElementName::Kind::kId, 2}});
  const Json single = settled_frame(reader_)["truth"];
  EXPECT_NEAR(single["ate_m"].get<double>(), 0, 1e-12);
  EXPECT_TRUE(single["rpe_m"].is_null());
}

TEST_F(WorkspaceWithTruth, DropsTheTruthIfAnotherGraphIsOpened) {
  workspace_.open("small.g2o", format_graph(small_graph()));
  const Settled messages = settled_messages(reader_);
  EXPECT_FALSE(messages.structure.is_null());
  EXPECT_TRUE(messages.truth.is_null());
  EXPECT_TRUE(messages.frame["truth"].is_null());
}

TEST(Workspace, ShowsAGraphWithItsTruth) {
  Workspace workspace;
  workspace.show(small_graph(), "small.g2o", Truth(parse_graph(kTruth, "t.g2o"), "t.g2o"));
  Workspace::Reader reader(workspace, "");
  const Settled messages = settled_messages(reader);
  EXPECT_EQ(messages.truth["matched"], 3);
  EXPECT_TRUE(messages.frame["truth"]["ate_m"].is_number());
}

TEST(Workspace, RefusesATruthWithoutAGraph) {
  Workspace workspace, of_program(nullptr);
  EXPECT_THROW(workspace.open_truth("truth.g2o", kTruth), InvalidArgument);
  of_program.show(small_graph(), "small.g2o");
  EXPECT_THROW(of_program.open_truth("truth.g2o", kTruth), InvalidArgument);
}

}  // namespace
}  // namespace boxplus::viewer
