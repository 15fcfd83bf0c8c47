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
    vertex_ = graph_.add_vertex(0.0);
    graph_.add_edge([](double x) { return x * x - 2; }, vertex_);
    graph_.set_estimate(vertex_, 1.0);
  }

  Graph graph_;
  VertexHandle<double> vertex_;
};

TEST_F(ViewerTest, CallsTheCallbackOfTheOptionsToo) {
  Viewer viewer(graph_);
  EXPECT_THAT(viewer.url(), StartsWith("http://127.0.0.1:"));
  Options options;
  int calls = 0;
  options.callback = [&](const IterationRecord&) { return ++calls < 2; };
  const Report report = optimize(graph_, viewer.watch(options));
  viewer.show(report);
  EXPECT_EQ(report.reason, Report::Reason::kCallback);
  EXPECT_EQ(calls, 2);
}

TEST_F(ViewerTest, ChangesNoResult) {
  Graph copy(graph_);
  Viewer viewer(graph_);
  EXPECT_EQ(optimize(graph_, viewer.watch()).chi2_final, optimize(copy).chi2_final);
  EXPECT_EQ(graph_.estimate(vertex_), copy.estimate(vertex_));
}

TEST_F(ViewerTest, GivesTheGraphBack) {
  Viewer viewer(graph_);
  viewer.hand_over();
  viewer.hand_over();
  viewer.take_back();
  viewer.take_back();
  EXPECT_TRUE(optimize(graph_, viewer.watch()).converged());
  EXPECT_THROW(graph_.pop(), InvalidArgument);
}

TEST_F(ViewerTest, LeavesTheStackOfTheGraphAsItWas) {
  {
    Viewer viewer(graph_);
    viewer.hand_over();
  }
  EXPECT_THROW(graph_.pop(), InvalidArgument);
}

TEST_F(ViewerTest, TakesAFreePortIfTheUsualOneIsTaken) {
  const Viewer one(graph_), other(graph_);
  EXPECT_NE(one.url(), other.url());
}

}  // namespace
}  // namespace boxplus
