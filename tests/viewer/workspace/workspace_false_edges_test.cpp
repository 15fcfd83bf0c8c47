// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "viewer/workspace/settled.h"
#include "viewer/workspace/workspace.h"

namespace boxplus::viewer {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

/// A robot that goes around a square three times, with a true closure between all laps and a false one.
GraphFile square() {
  constexpr int kSide = 5, kPoses = 60;
  std::string text;
  for (int k = 0; k < kPoses; ++k) {
    const int side = k / kSide % 4, along = k % kSide;
    const std::array x{along, kSide, kSide - along, 0}, y{0, along, kSide, kSide - along};
    const std::array angle{0.0, M_PI / 2, M_PI, -M_PI / 2};
    const auto s = static_cast<std::size_t>(side);
    text += fmt::format("VERTEX_SE2 {} {} {} {}\n", k, x[s], y[s], angle[s]);
  }
  const char* omega = "100 0 0 100 0 1000";
  for (int k = 1; k < kPoses; ++k)
    text += fmt::format("EDGE_SE2 {} {} 1 0 {} {}\n", k - 1, k, k % kSide == 0 ? M_PI / 2 : 0.0, omega);
  for (int k = 0; k + 4 * kSide < kPoses; ++k)
    text += fmt::format("EDGE_SE2 {} {} 0 0 0 {}\n", k, k + 4 * kSide, omega);
  text += fmt::format("EDGE_SE2 2 50 4 4 1 {}\n", omega);
  return parse_graph(text, "square.g2o");
}

class WorkspaceWithAFalseEdge : public testing::Test {
 protected:
  WorkspaceWithAFalseEdge() {
    workspace_.show(square(), "square.g2o");
    before_ = settled(reader_);
    workspace_.optimize({{"outliers", "loop-closures"}});
    settled(reader_);
    Workspace::Reader newcomer(workspace_, "");  // gets all rows at once
    after_ = settled(newcomer);
  }

  Workspace workspace_;
  Workspace::Reader reader_{workspace_, ""};
  Json before_, after_;
};

TEST_F(WorkspaceWithAFalseEdge, ShowsTheStagesOfTheSearch) {
  const Json& run = after_["run"];
  EXPECT_EQ(run["false_edges"], 1);
  EXPECT_THAT(run["stages"].get<std::vector<std::string>>(), ElementsAre("odometry", "search"));
  ASSERT_GE(run["rows"].size(), 2U);
  for (std::size_t k = 0; k < run["rows"].size(); ++k) EXPECT_EQ(run["rows"][k]["iteration"], k + 1);
  const Json& first = run["rows"][0];
  EXPECT_NEAR(first["chi2"].get<double>() + first["chi2_decrease"].get<double>(),
              before_["chi2"].get<double>(), 1e-6);
  EXPECT_GT(before_["chi2"].get<double>(), 100);
  EXPECT_LT(run["rows"].back()["chi2"].get<double>(), 1e-6);
  EXPECT_THAT(run["headline"].get<std::string>(), HasSubstr("without 1 false edge"));
}

TEST_F(WorkspaceWithAFalseEdge, RemovesItFromTheGraphAndFromSavedFiles) {
  EXPECT_THAT(workspace_.formatted("g2o"), HasSubstr("EDGE_SE2 2 50"));
  workspace_.remove_false_edges();
  const Json state = settled(reader_);
  EXPECT_EQ(state["file"]["edges"], before_["file"]["edges"].get<int>() - 1);
  EXPECT_LT(state["chi2"].get<double>(), 1e-6);
  EXPECT_THAT(workspace_.formatted("g2o"), Not(HasSubstr("EDGE_SE2 2 50")));
  EXPECT_THROW(workspace_.remove_false_edges(), InvalidArgument);
}

TEST_F(WorkspaceWithAFalseEdge, IsDiagnosedWithoutIt) {
  const Json diagnosis = Json::parse(workspace_.diagnosis());
  EXPECT_EQ(diagnosis["left_out"], 1);
  for (const Json& finding : diagnosis["findings"])
    EXPECT_THAT(finding["text"].get<std::string>(), Not(HasSubstr("not at a minimum")));
}

TEST_F(WorkspaceWithAFalseEdge, FitsItsMeasurements) {
  EXPECT_GT(after_["run"]["degrees_of_freedom"], 0);
  EXPECT_LT(after_["run"]["chi2_per_degree"], 1);
  workspace_.optimize({});
  EXPECT_GT(settled(reader_)["run"]["chi2_per_degree"], 1);
}

TEST(Workspace, RemovesNoFalseEdgesWithoutASearch) {
  Workspace workspace;
  workspace.show(small_graph(), "small.g2o");
  EXPECT_THROW(workspace.remove_false_edges(), InvalidArgument);
}

TEST(Workspace, SaysFromWhichInitialGuessTheIterationsStart) {
  Workspace workspace;
  workspace.show(small_graph(), "small.g2o");
  Workspace::Reader reader(workspace, "");
  workspace.optimize({{"start", "odometry"}});
  const Json run = settled(reader)["run"];
  EXPECT_EQ(run["start"]["name"], "odometry");
  EXPECT_NEAR(run["start"]["chi2"].get<double>(), 0.25, 1e-12);
  workspace.optimize({{"start", "current"}});
  EXPECT_TRUE(settled(reader)["run"]["start"].is_null());
}

}  // namespace
}  // namespace boxplus::viewer
