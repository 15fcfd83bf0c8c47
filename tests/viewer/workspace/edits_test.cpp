// SPDX-License-Identifier: BSD-3-Clause
#include "viewer/workspace/edits.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "boxplus/base/error.h"
#include "boxplus/io/graph_file.h"

namespace boxplus::viewer {
namespace {

using Kind = Edit::Kind;
using Name = ElementName::Kind;

class Edits : public testing::Test {
 protected:
  GraphFile file_ = parse_graph(
      "VERTEX_SE2 4 0 0 0\n"
      "VERTEX_SE2 5 1 0 0\n"
      "VERTEX_SE2 7 2 0.5 0\n"
      "FIX 4\n"
      "EDGE_SE2 4 5 1 0 0 4 1 0 4 0 4\n"
      "EDGE_SE2 5 7 1 0 0 1 0 0 1 0 1\n",
      "test");
  Graph& graph_ = file_.graph;

  std::string apply_to(Kind kind, Name name, std::uint64_t number, double factor = 1) {
    return apply({kind, {name, number}, factor}, graph_, make_structure(graph_));
  }
};

TEST_F(Edits, FixAndFreeAVertex) {
  const VertexRef vertex = *graph_.find_vertex(5);
  EXPECT_EQ(apply_to(Kind::kFix, Name::kId, 5), "vertex 5 is fixed");
  EXPECT_TRUE(graph_.is_fixed(vertex));
  EXPECT_EQ(apply_to(Kind::kFree, Name::kVertex, 1), "vertex 5 is free");
  EXPECT_FALSE(graph_.is_fixed(vertex));
  graph_.fix_directions(vertex, {2});
  EXPECT_EQ(apply_to(Kind::kFree, Name::kId, 5), "vertex 5 is free");
  EXPECT_TRUE(graph_.fixed_directions(vertex).empty());
}

TEST_F(Edits, RemoveAVertexWithItsEdges) {
  EXPECT_EQ(apply_to(Kind::kRemove, Name::kId, 5), "vertex 5 is removed, with its 2 edges");
  EXPECT_EQ(graph_.vertex_count(), 2U);
  EXPECT_EQ(graph_.edge_count(), 0U);
  EXPECT_EQ(apply_to(Kind::kRemove, Name::kId, 4), "vertex 4 is removed");
  EXPECT_THROW(apply_to(Kind::kRemove, Name::kId, 7), InvalidArgument);  // the last one
  EXPECT_EQ(graph_.vertex_count(), 1U);
}

TEST_F(Edits, RemoveAnEdge) {
  EXPECT_EQ(apply_to(Kind::kRemove, Name::kLine, 1), "edge 5 – 7 is removed");
  EXPECT_FALSE(graph_.contains(file_.edges[1]));
  EXPECT_EQ(graph_.vertex_count(), 3U);
}

TEST_F(Edits, DisableAndEnableAnEdge) {
  EXPECT_EQ(apply_to(Kind::kDisable, Name::kLine, 1), "edge 5 – 7 is disabled");
  EXPECT_DOUBLE_EQ(graph_.chi2(), 0);
  EXPECT_EQ(apply_to(Kind::kEnable, Name::kLine, 1), "edge 5 – 7 is enabled");
  EXPECT_DOUBLE_EQ(graph_.chi2(), 0.25);
}

TEST_F(Edits, ScaleTheInformationOfAnEdge) {
  EXPECT_EQ(apply_to(Kind::kScale, Name::kLine, 0, 0.5), "Ω of edge 4 – 5 is multiplied by 0.5");
  const Eigen::MatrixXd omega = graph_.information(file_.edges[0]).matrix();
  EXPECT_DOUBLE_EQ(omega(0, 0), 2);
  EXPECT_DOUBLE_EQ(omega(0, 1), 0.5);
  EXPECT_DOUBLE_EQ(omega(1, 0), 0.5);
  apply_to(Kind::kScale, Name::kLine, 1, 3);
  EXPECT_DOUBLE_EQ(graph_.chi2(), 0.75);
}

TEST_F(Edits, WithAWrongFactorAreRefused) {
  for (const double factor : {0.0, -1.0, 1e10, std::nan(""), std::numeric_limits<double>::infinity()})
    EXPECT_THROW(apply_to(Kind::kScale, Name::kLine, 1, factor), InvalidArgument);
  graph_.set_information(file_.edges[1], Information(1e300));
  EXPECT_THROW(apply_to(Kind::kScale, Name::kLine, 1, 1e9), InvalidArgument);
  EXPECT_DOUBLE_EQ(graph_.information(file_.edges[1])(0, 0), 1e300);
}

TEST_F(Edits, ThatMakeNoSenseAreRefused) {
  const std::uint64_t revision = graph_.revision();
  EXPECT_THROW(apply_to(Kind::kFix, Name::kLine, 0), InvalidArgument);
  EXPECT_THROW(apply_to(Kind::kDisable, Name::kId, 5), InvalidArgument);
  EXPECT_THROW(apply_to(Kind::kFix, Name::kId, 4), InvalidArgument);   // it is fixed
  EXPECT_THROW(apply_to(Kind::kFree, Name::kId, 5), InvalidArgument);  // it is free
  EXPECT_THROW(apply_to(Kind::kEnable, Name::kLine, 0), InvalidArgument);
  EXPECT_THROW(apply_to(Kind::kRemove, Name::kId, 6), InvalidArgument);
  EXPECT_EQ(graph_.revision(), revision);
}

}  // namespace
}  // namespace boxplus::viewer
