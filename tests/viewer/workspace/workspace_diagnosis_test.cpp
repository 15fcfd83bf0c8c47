// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "viewer/workspace/settled.h"
#include "viewer/workspace/workspace.h"

namespace boxplus::viewer {
namespace {

class DiagnosedWorkspace : public testing::Test {
 protected:
  DiagnosedWorkspace() {
    workspace_.show(small_graph(), "small.g2o");
    settled(reader_);
    answer_ = Json::parse(workspace_.diagnosis());
    diagnosed_ = settled_messages(reader_);
  }

  Json age() { return settled(reader_)["diagnosis"]; }

  Workspace workspace_;
  Workspace::Reader reader_{workspace_, ""};
  Json answer_;
  Settled diagnosed_;
};

TEST(Workspace, HasNoDiagnosisBeforeTheFirstOne) {
  Workspace workspace;
  workspace.show(small_graph(), "small.g2o");
  Workspace::Reader reader(workspace, "");
  const Settled messages = settled_messages(reader);
  EXPECT_TRUE(messages.state["diagnosis"].is_null());
  EXPECT_TRUE(messages.diagnosis.is_null());
}

TEST_F(DiagnosedWorkspace, SendsTheDiagnosisToAllReadersAndToNewOnes) {
  EXPECT_EQ(diagnosed_.state["diagnosis"], "current");
  EXPECT_EQ(diagnosed_.diagnosis, answer_);
  Workspace::Reader newcomer(workspace_, "");
  const Settled messages = settled_messages(newcomer);
  EXPECT_EQ(messages.diagnosis, answer_);
  EXPECT_EQ(messages.state["diagnosis"], "current");
}

TEST_F(DiagnosedWorkspace, SaysThatTheEstimatesHaveChangedButNotAfterCovariances) {
  workspace_.covariances();
  EXPECT_EQ(age(), "current");
  workspace_.step({});
  const Settled messages = settled_messages(reader_);
  EXPECT_EQ(messages.state["diagnosis"], "other estimates");
  EXPECT_TRUE(messages.diagnosis.is_null()) << "the findings are sent once";
  workspace_.diagnosis();
  EXPECT_EQ(age(), "current");
  workspace_.reset();
  EXPECT_EQ(age(), "other estimates");
}

TEST_F(DiagnosedWorkspace, SaysThatTheGraphHasChanged) {
  workspace_.edit(1, {Edit::Kind::kDisable, {ElementName::Kind::kLine, 0}});
  EXPECT_EQ(age(), "other graph");
  workspace_.step({});
  EXPECT_EQ(age(), "other graph");
}

TEST_F(DiagnosedWorkspace, ForgetsTheDiagnosisOfAnotherGraph) {
  workspace_.open("small.g2o", format_graph(small_graph()));
  EXPECT_TRUE(age().is_null());
  Workspace::Reader newcomer(workspace_, "");
  EXPECT_TRUE(settled_messages(newcomer).diagnosis.is_null());
}

TEST(Workspace, SaysIfItOpensNoFiles) {
  Workspace workspace, of_program(nullptr);
  Workspace::Reader reader(workspace, ""), other(of_program, "");
  const Json of_file = settled(reader), of_other = settled(other);
  EXPECT_TRUE(of_file["opens_no_files"].is_null());
  EXPECT_TRUE(of_file["opens_no_truth"].is_null());
  EXPECT_EQ(of_other["opens_no_files"], "this viewer shows the graph of a program, and opens no files");
  EXPECT_EQ(of_other["opens_no_truth"], of_other["opens_no_files"]);
}

}  // namespace
}  // namespace boxplus::viewer
