// SPDX-License-Identifier: BSD-3-Clause
// What a workspace keeps for new readers, and what it does if functions of the user throw.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "boxplus/base/error.h"
#include "boxplus/manifold/se2.h"
#include "viewer/workspace/settled.h"
#include "viewer/workspace/workspace.h"

namespace boxplus::viewer {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::vector<int> iterations_of_frames(Workspace::Reader& reader) {
  std::vector<int> iterations;
  for (const Message& message : reader.wait(std::chrono::seconds(10))) {
    if (kind_of(message) == MessageKind::kFrame) iterations.push_back(json_of(message)["iteration"]);
  }
  return iterations;
}

TEST(Workspace, SendsTheFramesOfTheRunToANewReader) {
  Workspace workspace;
  workspace.show(small_graph(), "small.g2o");
  Workspace::Reader reader(workspace, "");
  settled(reader);
  workspace.step({});
  settled(reader);
  Workspace::Reader newcomer(workspace, "");
  EXPECT_THAT(iterations_of_frames(newcomer), ElementsAre(0, 1));
  workspace.reset();
  settled(reader);
  Workspace::Reader other(workspace, "");
  EXPECT_THAT(iterations_of_frames(other), ElementsAre(0));
}

TEST(Workspace, BeginsTheFramesOfARunWithTheEstimatesOfTheRunBefore) {
  Workspace workspace;
  workspace.show(small_graph(), "small.g2o");
  Workspace::Reader reader(workspace, "");
  workspace.optimize({});
  const double chi2 = settled(reader)["chi2"];
  workspace.step({});
  settled(reader);
  Workspace::Reader newcomer(workspace, "");
  const std::vector<Message> messages = newcomer.wait(std::chrono::seconds(10));
  for (const Message& message : messages) {
    if (kind_of(message) != MessageKind::kFrame) continue;
    EXPECT_EQ(json_of(message)["iteration"], 0);
    EXPECT_EQ(json_of(message)["chi2"].get<double>(), chi2);
    break;
  }
}

TEST(Workspace, KeepsAThousandLinesOfItsLog) {
  Workspace workspace;
  workspace.show(small_graph(), "small.g2o");
  constexpr int kEdits = 700;
  for (int k = 0; k < kEdits; ++k) {
    workspace.edit(1, {Edit::Kind::kDisable, {ElementName::Kind::kEdge, 2}});
    workspace.edit(1, {Edit::Kind::kEnable, {ElementName::Kind::kEdge, 2}});
  }
  Workspace::Reader reader(workspace, "");
  const Json log = settled(reader)["log"];
  EXPECT_EQ(log["lines"].size(), 1000U);
  EXPECT_EQ(log["first"], 2 * kEdits + 1 - 1000);
  EXPECT_THAT(log["lines"].back()["text"].get<std::string>(), HasSubstr("enabled"));
}

/// A graph whose only edge throws what `throw_it` throws, once it is armed.
class ThrowingWorkspace : public testing::Test {
 protected:
  template <class F>
  void show(F throw_it) {
    GraphFile file;
    const auto a = file.graph.add_vertex(1.0), b = file.graph.add_vertex(2.0);
    file.graph.add_edge(
        [this, throw_it](double x, double y) {
          if (is_armed_) throw_it();
          return y - x - 3;
        },
        a, b);
    workspace_.show(std::move(file), "own");
    is_armed_ = true;
  }

  std::atomic<bool> is_armed_ = false;
  Workspace workspace_;
  Workspace::Reader reader_{workspace_, ""};
};

TEST_F(ThrowingWorkspace, SurvivesAnExceptionThatIsNoStdException) {
  show([] { throw 42; });
  workspace_.optimize({});
  const Json state = settled(reader_);
  EXPECT_EQ(state["run"]["status"], "failed");
  EXPECT_THAT(state["run"]["headline"].get<std::string>(), HasSubstr("no std::exception"));
  is_armed_ = false;
  workspace_.optimize({});
  EXPECT_EQ(settled(reader_)["run"]["status"], "converged");
}

TEST_F(ThrowingWorkspace, RefusesPatternAndDiagnosisWithTheWordsOfTheException) {
  show([] { throw std::runtime_error("the sensor is broken"); });
  const auto refuses = testing::ThrowsMessage<InvalidArgument>(HasSubstr("the sensor is broken"));
  EXPECT_THAT([&] { workspace_.diagnosis(); }, refuses);
  EXPECT_THAT([&] { workspace_.describe(1, {ElementName::Kind::kEdge, 0}); }, refuses);
  // The pattern needs errors only if the graph has poses.
  GraphFile poses;
  const auto pose = poses.graph.add_vertex(SE2()), other = poses.graph.add_vertex(SE2(1, 0, 0));
  poses.graph.add_edge(
      [this](const SE2& x, const SE2& y) {
        if (is_armed_) throw Error("the sensor is broken");
        return y.x() - x.x();
      },
      pose, other);
  is_armed_ = false;
  workspace_.show(std::move(poses), "poses");
  is_armed_ = true;
  EXPECT_THAT([&] { workspace_.pattern(); }, refuses);
  is_armed_ = false;
  EXPECT_NE(workspace_.pattern(), nullptr);
}

TEST(OutcomeOf, SaysThatChi2IsNotKnownIfTheRunWasStoppedBefore) {
  GraphFile file = small_graph();
  const std::atomic<bool> stop = true;
  Options options;
  options.stop = &stop;
  const Outcome outcome = outcome_of(optimize(file.graph, options));
  EXPECT_EQ(outcome.headline, "not converged: stopped before chi2 was computed; the estimates are unchanged");
}

TEST(FrameHistory, ForgetsEverySecondFrameIfThereIsNoRoom) {
  FrameHistory history(30);
  for (char name = 'a'; name < 'j'; ++name) history.add(std::make_shared<std::string>(10, name));
  std::string names;
  for (const Message& frame : history.frames()) names += frame->front();
  EXPECT_EQ(names, "aei") << "each frame of the same stride is kept";
  history.clear();
  EXPECT_TRUE(history.frames().empty());
}

}  // namespace
}  // namespace boxplus::viewer
