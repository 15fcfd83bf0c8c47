// SPDX-License-Identifier: BSD-3-Clause
#include "viewer/workspace/workspace.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <tuple>

#include "boxplus/base/error.h"
#include "boxplus/manifold/se2.h"
#include "boxplus/types/between.h"
#include "viewer/workspace/settled.h"

namespace boxplus::viewer {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

/// The newest state, without waiting for the end of anything.
Json last_state(Workspace::Reader& reader) {
  for (const Message& message : reader.wait(10s)) {
    if (kind_of(message) == MessageKind::kState) return Json::parse(message->substr(8));
  }
  return {};
}

TEST(Workspace, GivesANewReaderEverything) {
  Workspace workspace;
  workspace.show(small_graph(), "small.g2o");
  Workspace::Reader reader(workspace, R"({"token": "x"})");
  const std::vector<Message> messages = reader.wait(1s);
  ASSERT_EQ(messages.size(), 4U);
  EXPECT_EQ(kind_of(messages[0]), MessageKind::kState);
  EXPECT_EQ(kind_of(messages[1]), MessageKind::kForm);
  EXPECT_EQ(kind_of(messages[2]), MessageKind::kStructure);
  EXPECT_EQ(kind_of(messages[3]), MessageKind::kFrame);
  const Json state = Json::parse(messages[0]->substr(8));
  EXPECT_EQ(state["token"], "x");
  EXPECT_TRUE(state["run"].is_null());
  EXPECT_THAT(reader.wait(0ms), IsEmpty());
}

TEST(Workspace, SendsTheErrorsOfLinesAtRest) {
  Workspace workspace;
  workspace.show(small_graph(), "small.g2o");
  Workspace::Reader reader(workspace, "");
  const Json of_file = settled_frame(reader)["arrays"];
  EXPECT_EQ(of_file["chi2"]["count"], 3);
  EXPECT_FALSE(of_file.contains("weights"));
  workspace.optimize({{"kernel", "Huber"}});
  EXPECT_EQ(settled_frame(reader)["arrays"]["weights"]["count"], 3);
}

TEST(Workspace, OptimizesAsOptimizeDoes) {
  Workspace workspace;
  workspace.show(small_graph(), "small.g2o");
  Workspace::Reader reader(workspace, "");
  workspace.optimize({});
  const Json state = settled(reader);
  EXPECT_EQ(state["run"]["status"], "converged");
  GraphFile file = small_graph();
  Options options;
  options.start = Start::kAutomatic;
  const Report report = optimize(file.graph, options);
  EXPECT_EQ(state["chi2"].get<double>(), report.chi2_final);
}

TEST(Workspace, ShowsCovariancesUntilTheEstimatesChange) {
  Workspace workspace;
  workspace.show(small_graph(), "small.g2o");
  Workspace::Reader reader(workspace, "");
  workspace.optimize({});
  const Json optimized = settled_frame(reader);
  EXPECT_EQ(optimized["uncertainty"], "");
  EXPECT_FALSE(optimized["arrays"].contains("covariances"));

  workspace.covariances();
  const Json uncertain = settled_frame(reader);
  EXPECT_EQ(uncertain["uncertainty"], "covariances of all 3 positions, relative to vertex 0");
  EXPECT_EQ(uncertain["arrays"]["uncertain"]["count"], 3);
  EXPECT_EQ(uncertain["arrays"]["covariances"]["count"], 18);
  EXPECT_EQ(uncertain["iteration"], optimized["iteration"]);
  EXPECT_EQ(uncertain["chi2"], optimized["chi2"]);
  EXPECT_GT(uncertain["sequence"], optimized["sequence"]);
  Workspace::Reader newcomer(workspace, "");
  EXPECT_EQ(settled_frame(newcomer), uncertain);

  workspace.reset();
  EXPECT_EQ(settled_frame(reader)["uncertainty"], "");
}

TEST(Workspace, SaysWhyThereAreNoCovariances) {
  Workspace workspace;
  workspace.show(parse_graph("VERTEX_SE2 4 0 0 0\nVERTEX_SE2 5 0 0 0\n", "loose.g2o"), "loose.g2o");
  Workspace::Reader reader(workspace, "");
  workspace.covariances();
  const Json frame = settled_frame(reader);
  EXPECT_THAT(frame["uncertainty"].get<std::string>(), HasSubstr("vertex 5"));
  EXPECT_FALSE(frame["arrays"].contains("covariances"));
}

TEST(Workspace, RestoresTheEstimatesOfTheFile) {
  Workspace workspace;
  workspace.show(small_graph(), "small.g2o");
  Workspace::Reader reader(workspace, "");
  const double before = settled(reader)["chi2"].get<double>();
  workspace.step({});
  EXPECT_LT(settled(reader)["chi2"].get<double>(), before);
  workspace.reset();
  EXPECT_EQ(settled(reader)["chi2"].get<double>(), before);
}

TEST(Workspace, SendsTheStructureAgainAfterAnEditThatChangesIt) {
  Workspace workspace;
  workspace.show(small_graph(), "small.g2o");
  Workspace::Reader reader(workspace, "");
  const auto structures = [&] {
    int count = 0;
    for (const Message& message : reader.wait(1s)) count += kind_of(message) == MessageKind::kStructure;
    return count;
  };
  EXPECT_EQ(structures(), 1);
  workspace.edit(1, {Edit::Kind::kFix, {ElementName::Kind::kId, 1}});
  EXPECT_EQ(structures(), 1);
  workspace.edit(2, {Edit::Kind::kScale, {ElementName::Kind::kLine, 0}, 2});
  EXPECT_EQ(structures(), 0);
  EXPECT_THROW(workspace.edit(1, {Edit::Kind::kFree, {ElementName::Kind::kId, 1}}), InvalidArgument);
  workspace.edit(2, {Edit::Kind::kFree, {ElementName::Kind::kId, 1}});
  EXPECT_EQ(structures(), 1);
}

TEST(Workspace, OptimizesAfterAnEdit) {
  Workspace workspace;
  workspace.show(small_graph(), "small.g2o");
  Workspace::Reader reader(workspace, "");
  workspace.optimize({});
  EXPECT_GT(settled(reader)["chi2"].get<double>(), 0.01);  // the closure measures 2.5 instead of 2
  workspace.edit(1, {Edit::Kind::kDisable, {ElementName::Kind::kEdge, 2}});
  workspace.optimize({});
  EXPECT_NEAR(settled(reader)["chi2"].get<double>(), 0, 1e-9);
  workspace.edit(1, {Edit::Kind::kRemove, {ElementName::Kind::kId, 2}});
  Json state = settled(reader);
  EXPECT_EQ(state["file"]["vertices"], 2);
  EXPECT_EQ(state["file"]["edges"], 1);
  workspace.optimize({});
  EXPECT_EQ(settled(reader)["run"]["status"], "converged");
  EXPECT_THAT(workspace.formatted("g2o"), Not(HasSubstr("VERTEX_SE2 2")));
}

TEST(Workspace, RestoresTheEstimatesOfTheVerticesThatAnEditLeft) {
  Workspace workspace;
  workspace.show(small_graph(), "small.g2o");
  Workspace::Reader reader(workspace, "");
  workspace.optimize({});
  settled(reader);
  workspace.edit(1, {Edit::Kind::kRemove, {ElementName::Kind::kId, 0}});
  for (int repetition = 0; repetition < 2; ++repetition) {
    workspace.reset();
    const Json state = settled(reader);
    EXPECT_THAT(workspace.formatted("g2o"), HasSubstr("VERTEX_SE2 1 3 0 0\nVERTEX_SE2 2 0 3 0\n"));
    EXPECT_EQ(state["chi2"].get<double>(), 16 + 9);  // of the edge from 1 to 2
    EXPECT_EQ(state["chi2"], state["chi2_initial"]);
    EXPECT_EQ(state["file"]["vertices"], 2);
    workspace.step({});
    EXPECT_NE(settled(reader)["chi2"], state["chi2"]);
  }
}

TEST(Workspace, DescribesTheGraphOfAProgramAndDoesNotEditIt) {
  GraphFile file = small_graph();
  Workspace workspace(nullptr);
  workspace.show(std::make_unique<GraphSubject>(file.graph, "own"));
  EXPECT_THAT(workspace.describe(1, {ElementName::Kind::kId, 1}), HasSubstr("VERTEX_SE2"));
  EXPECT_THROW(workspace.edit(1, {Edit::Kind::kRemove, {ElementName::Kind::kId, 1}}), InvalidArgument);
  EXPECT_EQ(file.graph.vertex_count(), 3U);
  workspace.hold();
  EXPECT_THROW(std::ignore = workspace.describe(1, {ElementName::Kind::kId, 1}), Busy);
}

TEST(Workspace, ForgetsEditsIfTheFileIsOpenedAgain) {
  Workspace workspace;
  workspace.show(small_graph(), "small.g2o");
  Workspace::Reader reader(workspace, "");
  workspace.edit(1, {Edit::Kind::kRemove, {ElementName::Kind::kId, 2}});
  workspace.open("small.g2o", format_graph(small_graph()));
  const Json state = settled(reader);
  EXPECT_EQ(state["file"]["edges"], 3);
  workspace.reset();
  EXPECT_THAT(settled_messages(reader).log.back(), Not(HasSubstr("edited")));
}

TEST(Workspace, RefusesCommandsWithoutAGraphUntilOneIsOpened) {
  Workspace workspace;
  Workspace::Reader reader(workspace, "");
  EXPECT_TRUE(settled(reader)["file"].is_null());
  EXPECT_THROW(workspace.optimize({}), InvalidArgument);
  EXPECT_THROW(workspace.formatted("g2o"), InvalidArgument);
  workspace.open("small.g2o", format_graph(small_graph()));
  EXPECT_EQ(settled(reader)["file"]["vertices"], 3);
  workspace.optimize({});
  EXPECT_EQ(settled(reader)["run"]["status"], "converged");
}

TEST(Workspace, MakesTheInitialGuessOfTheSettings) {
  Workspace workspace;
  workspace.show(small_graph(), "small.g2o");
  Workspace::Reader reader(workspace, "");
  workspace.guess("odometry");
  const Json state = settled(reader);
  EXPECT_NEAR(state["chi2"].get<double>(), 0.25, 1e-12);  // the closure measures 2.5 instead of 2
  EXPECT_TRUE(state["run"].is_null());
}

TEST(Workspace, RemovesKernelsThatTheNextRunDoesNotWant) {
  Workspace workspace;
  workspace.show(small_graph(), "small.g2o");
  Workspace::Reader reader(workspace, "");
  const Settings settings{{"kernel", "Huber"}, {"kernel-width", "1e-3"}};
  workspace.optimize(settings);
  const double robust = settled(reader)["chi2"].get<double>();
  workspace.optimize({});
  EXPECT_GT(settled(reader)["chi2"].get<double>(), 2 * robust);
  workspace.optimize(settings);
  settled(reader);
  workspace.reset();
  const Json state = settled(reader);
  EXPECT_EQ(state["chi2"], state["chi2_initial"]);
}

TEST(Workspace, SendsTheVerdictsOfTheLastRun) {
  Workspace workspace;
  workspace.show(small_graph(), "small.g2o");
  Workspace::Reader reader(workspace, "");
  EXPECT_FALSE(settled_frame(reader)["arrays"].contains("verdicts"));
  workspace.optimize({{"outliers", "loop-closures"}});
  EXPECT_EQ(settled_frame(reader)["arrays"]["verdicts"]["count"], 3);
  workspace.optimize({});
  EXPECT_FALSE(settled_frame(reader)["arrays"].contains("verdicts"));
}

TEST(Workspace, RefusesAChoiceThatMakesNoSenseForTheGraph) {
  GraphFile file;
  const auto a = file.graph.add_vertex(SE2()), b = file.graph.add_vertex(SE2(1, 0, 0));
  file.graph.add_edge(Between(SE2(1, 0, 0)), a, b);
  Workspace workspace;
  workspace.show(std::move(file), "own");
  EXPECT_THAT(
      [&] {
        workspace.optimize({{"outliers", "loop-closures"}});
      },
      testing::ThrowsMessage<InvalidArgument>(HasSubstr("this graph has no loop closures")));
}

TEST(Workspace, ReportsAnErrorFunctionThatThrows) {
  GraphFile file;
  const auto vertex = file.graph.add_vertex(1.0);
  file.graph.add_edge(
      [](double x) {
        if (x != 1.0) throw Error("the sensor is broken");
        return x - 3;
      },
      vertex);
  Workspace workspace;
  workspace.show(std::move(file), "own");
  Workspace::Reader reader(workspace, "");
  workspace.optimize({});
  const Json state = settled(reader);
  EXPECT_EQ(state["run"]["status"], "failed");
  EXPECT_THAT(state["run"]["headline"].get<std::string>(), HasSubstr("the sensor is broken"));
}

/// A workspace of the graph of a program, which holds it.
class HeldWorkspace : public testing::Test {
 protected:
  HeldWorkspace() {
    workspace_.show(std::make_unique<GraphSubject>(file_.graph, "own"));
    workspace_.hold();
  }

  /// Optimizes as a program does.
  Report optimize_as_program(int iterations) {
    Options options;
    options.max_iterations = iterations;
    options.cost_tolerance = options.step_tolerance = 0;
    options.callback = [&](const IterationRecord& record) { return workspace_.watch(record); };
    Report report = optimize(file_.graph, options);
    workspace_.watch_end(outcome_of(report));
    return report;
  }

  GraphFile file_ = small_graph();
  Workspace workspace_{nullptr};
};

TEST_F(HeldWorkspace, ShowsTheRunOfItsProgram) {
  Workspace::Reader reader(workspace_, "");
  const Report report = optimize_as_program(4);
  const Json state = last_state(reader);
  EXPECT_EQ(state["run"]["status"], to_string(report.status));
  EXPECT_EQ(state["run"]["rows"].size(), report.records.size());
  EXPECT_EQ(state["chi2"].get<double>(), report.chi2_final);
}

TEST_F(HeldWorkspace, RefusesCommandsUntilItIsHandedOver) {
  EXPECT_THROW(workspace_.optimize({}), Busy);
  EXPECT_THROW(workspace_.formatted("g2o"), Busy);
  workspace_.hand_over();
  Workspace::Reader reader(workspace_, "");
  workspace_.optimize({});
  EXPECT_EQ(settled(reader)["run"]["status"], "converged");
  EXPECT_THAT(workspace_.formatted("g2o"), HasSubstr("EDGE_SE2"));
  EXPECT_THROW(workspace_.open("a.g2o", "VERTEX_SE2 0 0 0 0"), InvalidArgument);
}

TEST_F(HeldWorkspace, StopsTheRunOfItsProgramOnlyWhileItGoesOn) {
  workspace_.stop();
  EXPECT_GT(optimize_as_program(3).iterations, 1);
  Options options;
  options.callback = [&](const IterationRecord& record) {
    const bool goes_on = workspace_.watch(record);
    workspace_.stop();
    return goes_on;
  };
  options.cost_tolerance = options.step_tolerance = 0;
  const Report report = optimize(file_.graph, options);
  EXPECT_EQ(report.reason, Report::Reason::kCallback);
  EXPECT_EQ(report.iterations, 2);
}

TEST_F(HeldWorkspace, ShowsElementsThatItsProgramAdds) {
  Workspace::Reader reader(workspace_, "");
  last_state(reader);
  file_.graph.add_vertex(SE2(1, 1, 0));
  workspace_.update();
  const std::vector<Message> messages = reader.wait(10s);
  ASSERT_EQ(messages.size(), 4U);
  EXPECT_EQ(kind_of(messages[2]), MessageKind::kStructure);
  EXPECT_EQ(Json::parse(messages[0]->substr(8))["file"]["vertices"], 4);
}

TEST_F(HeldWorkspace, FollowsAGraphThatGrowsAtAMeasuredPace) {
  file_.graph.add_vertex(SE2(1, 1, 0));
  workspace_.follow();  // nobody reads
  Workspace::Reader reader(workspace_, "");
  EXPECT_EQ(last_state(reader)["file"]["vertices"], 3);
  using Clock = std::chrono::steady_clock;
  const Clock::time_point begin = Clock::now();
  workspace_.follow();
  EXPECT_EQ(last_state(reader)["file"]["vertices"], 4);
  int frames = 1;
  while (frames < 3) {
    file_.graph.set_estimate(file_.graph.add_vertex(SE2(2, 1, 0)), SE2(3, 1, 0));
    workspace_.follow();
    frames += reader.wait(0ms).empty() ? 0 : 1;
  }
  EXPECT_GE(Clock::now() - begin, 2 * 33ms);
}

TEST_F(HeldWorkspace, LeavesTheStackOfTheGraphAsItWas) {
  workspace_.hand_over();
  Workspace::Reader reader(workspace_, "");
  const double before = settled(reader)["chi2"].get<double>();
  workspace_.step({});
  EXPECT_LT(settled(reader)["chi2"].get<double>(), before);
  workspace_.reset();
  EXPECT_EQ(settled(reader)["chi2"].get<double>(), before);
  workspace_.hold();
  EXPECT_THROW(file_.graph.pop(), InvalidArgument);
}

TEST(Workspace, WakesItsReadersWhenItEnds) {
  Workspace workspace;
  workspace.show(small_graph(), "small.g2o");
  Workspace::Reader reader(workspace, "");
  reader.wait(1s);
  workspace.end();
  reader.wait(1h);
  EXPECT_TRUE(reader.has_ended());
  EXPECT_THROW(workspace.step({}), InvalidArgument);
}

}  // namespace
}  // namespace boxplus::viewer
