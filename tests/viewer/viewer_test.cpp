// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/viewer/viewer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "boxplus/base/error.h"
#include "boxplus/optimize/optimizer.h"

namespace boxplus {
namespace {

using testing::StartsWith;

class ViewerTest : public testing::Test {
 protected:
  ViewerTest() {
    vertex = graph.add_vertex(0.0);
    graph.add_edge([](double x) { return x * x - 2; }, vertex);
    graph.set_estimate(vertex, 1.0);
  }

  Graph graph;
  VertexHandle<double> vertex;
};

TEST_F(ViewerTest, CallsTheCallbackOfTheOptionsToo) {
  Viewer viewer(graph);
  EXPECT_THAT(viewer.url(), StartsWith("http://127.0.0.1:"));
  Options options;
  int calls = 0;
  options.callback = [&](const IterationRecord&) { return ++calls < 2; };
  const Report report = optimize(graph, viewer.watch(options));
  viewer.show(report);
  EXPECT_EQ(report.reason, Report::Reason::kCallback);
  EXPECT_EQ(calls, 2);
}

TEST_F(ViewerTest, ChangesNoResult) {
  Graph copy(graph);
  Viewer viewer(graph);
  EXPECT_EQ(optimize(graph, viewer.watch()).chi2_final, optimize(copy).chi2_final);
  EXPECT_EQ(graph.estimate(vertex), copy.estimate(vertex));
}

TEST_F(ViewerTest, GivesTheGraphBack) {
  Viewer viewer(graph);
  viewer.hand_over();
  viewer.hand_over();
  viewer.take_back();
  viewer.take_back();
  EXPECT_TRUE(optimize(graph, viewer.watch()).converged());
  EXPECT_THROW(graph.pop(), InvalidArgument);
}

TEST_F(ViewerTest, LeavesTheStackOfTheGraphAsItWas) {
  {
    Viewer viewer(graph);
    viewer.hand_over();
  }
  EXPECT_THROW(graph.pop(), InvalidArgument);
}

TEST_F(ViewerTest, TakesAFreePortIfTheUsualOneIsTaken) {
  const Viewer one(graph), other(graph);
  EXPECT_NE(one.url(), other.url());
}

}  // namespace
}  // namespace boxplus
