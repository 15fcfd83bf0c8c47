// SPDX-License-Identifier: BSD-3-Clause
#include "viewer/scene/element.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "boxplus/base/error.h"
#include "boxplus/io/graph_file.h"
#include "boxplus/robust/huber.h"

namespace boxplus::viewer {
namespace {

using Kind = ElementName::Kind;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

/// A prior, a wrong step from 4 to 5, and a correct one from 5 to 7.
class ElementTest : public testing::Test {
 protected:
  GraphFile file_ = parse_graph(
      "VERTEX_SE2 4 0 0 0\n"
      "VERTEX_SE2 5 1 0 0\n"
      "VERTEX_SE2 7 2 0.5 0\n"
      "FIX 4\n"
      "EDGE_PRIOR_SE2 4 0 0 0 1 0 0 1 0 1\n"
      "EDGE_SE2 5 7 1 0.5 0 1 0 0 1 0 1\n"
      "EDGE_SE2 4 5 3 0 0 4 0 0 4 0 4\n",
      "test");
  Graph& graph_ = file_.graph;
  Structure structure_ = make_structure(graph_);

  VertexRef vertex(Kind kind, std::uint64_t number) {
    return std::get<VertexRef>(find_element(graph_, structure_, {kind, number}));
  }
  EdgeRef edge(Kind kind, std::uint64_t number) {
    return std::get<EdgeRef>(find_element(graph_, structure_, {kind, number}));
  }
};

TEST_F(ElementTest, IsFoundByItsNumberInThePictureOrItsId) {
  EXPECT_EQ(graph_.id(vertex(Kind::kVertex, 2)), 7);
  EXPECT_EQ(graph_.id(vertex(Kind::kId, 7)), 7);
  EXPECT_EQ(edge(Kind::kLine, 0), file_.edges[1]);
  EXPECT_EQ(edge(Kind::kLine, 1), file_.edges[2]);
}

TEST_F(ElementTest, OfEachEdgeHasANumber) {
  for (const EdgeRef& ref : file_.edges)
    EXPECT_EQ(edge(Kind::kEdge, facts_of(graph_, structure_, ref).number), ref);
}

TEST_F(ElementTest, WithAWrongNumberIsRefused) {
  constexpr auto kLargest = std::numeric_limits<std::uint64_t>::max();
  for (const std::uint64_t number : {std::uint64_t{3}, kLargest}) {
    EXPECT_THROW(vertex(Kind::kVertex, number), InvalidArgument);
    EXPECT_THROW(vertex(Kind::kId, number), InvalidArgument);
    EXPECT_THROW(edge(Kind::kLine, number), InvalidArgument);
    EXPECT_THROW(edge(Kind::kEdge, number), InvalidArgument);
  }
  const std::uint64_t removed = facts_of(graph_, structure_, file_.edges[1]).number;
  graph_.remove(file_.edges[1]);
  EXPECT_THROW(edge(Kind::kEdge, removed), InvalidArgument);
}

TEST_F(ElementTest, ThatIsAVertexListsItsWorstEdgesFirst) {
  const VertexFacts facts = facts_of(graph_, structure_, vertex(Kind::kId, 5));
  EXPECT_EQ(facts.id, 5);
  EXPECT_EQ(facts.number, 1U);
  EXPECT_EQ(facts.tag, "VERTEX_SE2");
  EXPECT_EQ(facts.estimate, "1 0 0");
  EXPECT_FALSE(facts.is_fixed);
  ASSERT_THAT(facts.edges, SizeIs(2));
  EXPECT_DOUBLE_EQ(facts.edges[0].chi2, 4 * 2 * 2);
  EXPECT_EQ(facts.edges[0].line, 1U);
  EXPECT_DOUBLE_EQ(facts.edges[1].chi2, 0);
  EXPECT_TRUE(facts_of(graph_, structure_, vertex(Kind::kId, 4)).is_fixed);
}

TEST_F(ElementTest, ThatIsAnEdgeHasItsErrorAndItsWeight) {
  graph_.set_kernel(file_.edges[2], Huber(1));
  const EdgeFacts facts = facts_of(graph_, structure_, file_.edges[2]);
  EXPECT_EQ(facts.tag, "EDGE_SE2");
  EXPECT_EQ(facts.fields, "3 0 0 4 0 0 4 0 4");
  EXPECT_THAT(facts.error, ElementsAre(-2, 0, 0));
  EXPECT_EQ(facts.rows, 3);
  EXPECT_DOUBLE_EQ(facts.chi2, 16);
  EXPECT_DOUBLE_EQ(facts.weight, 1.0 / 4);
  EXPECT_EQ(facts.kernel, "Huber");
  ASSERT_THAT(facts.ends, SizeIs(2));
  EXPECT_EQ(facts.ends[1].id, 5);
  EXPECT_EQ(facts.ends[1].number, 1U);
}

TEST_F(ElementTest, ThatIsNotDrawnHasNoLine) {
  const EdgeFacts facts = facts_of(graph_, structure_, file_.edges[0]);
  EXPECT_EQ(facts.line, std::nullopt);
  EXPECT_EQ(facts.vertices, 1U);
}

TEST(Element, WithoutATagHasNoFields) {
  Graph own;
  const auto vertex = own.add_vertex(1.0);
  own.add_edge([](double x) { return x - 3; }, vertex);
  const VertexFacts facts = facts_of(own, make_structure(own), vertex);
  EXPECT_THAT(facts.tag, IsEmpty());
  EXPECT_THAT(facts.estimate, IsEmpty());
  EXPECT_EQ(facts.number, std::nullopt);
  ASSERT_THAT(facts.edges, SizeIs(1));
  EXPECT_THAT(facts.edges[0].error, ElementsAre(-2));
}

TEST(Element, WithManyEdgesListsTheWorstOnes) {
  Graph own;
  const auto vertex = own.add_vertex(0.0);
  for (int k = 0; k < 150; ++k) {
    own.add_edge([k](double x) { return x - k; }, vertex);
  }
  const VertexFacts facts = facts_of(own, make_structure(own), vertex);
  EXPECT_EQ(facts.edge_count, 150U);
  ASSERT_THAT(facts.edges, SizeIs(100));
  EXPECT_DOUBLE_EQ(facts.edges.front().chi2, 149 * 149);
  EXPECT_DOUBLE_EQ(facts.edges.back().chi2, 50 * 50);
}

}  // namespace
}  // namespace boxplus::viewer
