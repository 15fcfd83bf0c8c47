// SPDX-License-Identifier: BSD-3-Clause
// Loads and saves .g2o files with unassigned vertices, lines in any order, comments and errors.
#include <gmock/gmock.h>

#include <fstream>
#include <sstream>
#include <stdexcept>
#include <streambuf>
#include <string>
#include <vector>

#include "g2o/core/base_vertex.h"
#include "g2o/core/factory.h"
#include "g2o/core/small_graph.h"
#include "g2o/stuff/logger.h"

G2O_USE_TYPE_GROUP(slam2d);

namespace {

/// A graph in which two edges have an unassigned vertex (-1).
const char* const kUnassigned =
    "PARAMS_SE2OFFSET 3 1 1 0\n"
    "VERTEX_SE2 0 0 0 0\n"
    "FIX 0\n"
    "VERTEX_SE2 1 1 0 0.5\n"
    "VERTEX_XY 2 3 1\n"
    "EDGE_SE2 0 1 1 0 0.25 1 0 0 1 0 1\n"
    "EDGE_SE2_XY 0 -1 0.5 0.5 20 0 20\n"
    "EDGE_SE2_POINTXY_OFFSET 1 -1 3 1 0 1 0 1\n";

TEST(Files, EdgesWithUnassignedVerticesAreSavedButNotOptimized) {
  g2o::SparseOptimizer optimizer;
  std::istringstream in(kUnassigned);
  ASSERT_TRUE(optimizer.load(in));
  EXPECT_EQ(optimizer.edges().size(), 3u);
  EXPECT_EQ(optimizer.vertex(0)->edges().size(), 2u);
  optimizer.setAlgorithm(new g2o::OptimizationAlgorithmGaussNewton(small_graph::make_solver()));
  ASSERT_TRUE(optimizer.initializeOptimization());
  EXPECT_EQ(optimizer.activeEdges().size(), 1u);
  optimizer.computeActiveErrors();
  EXPECT_EQ(optimizer.chi2(), optimizer.activeChi2());
  std::ostringstream out;
  ASSERT_TRUE(optimizer.save(out));
  EXPECT_EQ(out.str(), kUnassigned);
}

TEST(Files, AnEdgeWithAnUnassignedVertexTakesPartOnceTheVertexIsSet) {
  g2o::SparseOptimizer optimizer;
  std::istringstream in(kUnassigned);
  ASSERT_TRUE(optimizer.load(in));
  std::vector<g2o::OptimizableGraph::Edge*> unassigned;
  for (g2o::HyperGraph::Edge* e : optimizer.edges()) {
    if (e->numUndefinedVertices() > 0) unassigned.push_back(static_cast<g2o::OptimizableGraph::Edge*>(e));
  }
  ASSERT_EQ(unassigned.size(), 2u);
  for (auto* e : unassigned) {
    EXPECT_FALSE(optimizer.setEdgeVertex(e, 1, optimizer.vertex(e->vertex(0)->id() == 0 ? 1 : 0)))
        << "a pose is not a point";
    EXPECT_EQ(e->vertex(1), nullptr);
    EXPECT_TRUE(optimizer.setEdgeVertex(e, 1, optimizer.vertex(2)));
  }
  optimizer.setAlgorithm(new g2o::OptimizationAlgorithmGaussNewton(small_graph::make_solver()));
  ASSERT_TRUE(optimizer.initializeOptimization());
  EXPECT_EQ(optimizer.activeEdges().size(), 3u);
  EXPECT_EQ(optimizer.optimize(2), 2);
}

TEST(Files, AnEdgeWithAnUnassignedVertexIsRefusedIfItsOtherVertexIsUnsuitable) {
  g2o::SparseOptimizer optimizer;
  small_graph::add_pose(optimizer, 0, 0, 0, 0);
  auto e = std::make_unique<g2o::EdgeSE2PointXY>();
  e->setVertex(1, optimizer.vertex(0));
  EXPECT_FALSE(optimizer.addUnassignedEdge(e.get()));
  g2o::VertexSE2 stranger;
  stranger.setId(0);
  e->setVertex(0, &stranger);
  e->setVertex(1, nullptr);
  EXPECT_FALSE(optimizer.addUnassignedEdge(e.get()));
  EXPECT_TRUE(optimizer.edges().empty());
}

TEST(Files, ALineWithTooManyFieldsIsRefused) {
  std::vector<std::string> messages;
  g2o::logging::setSink([&](g2o::logging::Level, const std::string& text) { messages.push_back(text); });
  for (const std::string line : {"PARAMS_SE2OFFSET 3 1 1 0 7", "VERTEX_XY 6 1 0 7",
                                 "EDGE_SE2 0 5 1 0 0 1 0 0 1 0 1 7", "FIX 0 seven"}) {
    SCOPED_TRACE(line);
    g2o::SparseOptimizer optimizer;
    messages.clear();
    std::istringstream file("VERTEX_SE2 0 0 0 0\nVERTEX_SE2 5 1 0 0\n" + line + "\n");
    EXPECT_FALSE(optimizer.load(file));
    EXPECT_THAT(messages, testing::ElementsAre(testing::AllOf(testing::HasSubstr("line 3"),
                                                              testing::HasSubstr("expected the end"))));
    EXPECT_EQ(optimizer.vertices().size(), 2u);
    EXPECT_TRUE(optimizer.edges().empty());
  }
  g2o::logging::setSink({});
}

TEST(Files, ALineMayEndWithACommentOrACarriageReturn) {
  g2o::SparseOptimizer optimizer;
  std::istringstream file("VERTEX_SE2 0 0 0 0 # the start\nVERTEX_XY 6 1 0\r\nFIX 0 # fixed\n");
  EXPECT_TRUE(optimizer.load(file));
  EXPECT_EQ(optimizer.vertices().size(), 2u);
}

/// Loads a graph from text and checks that load() returns `expected`. Returns the logged messages.
std::vector<std::string> messages_of(const std::string& text, bool expected) {
  std::vector<std::string> messages;
  g2o::logging::setSink([&](g2o::logging::Level, const std::string& said) { messages.push_back(said); });
  g2o::SparseOptimizer optimizer;
  std::istringstream file(text);
  EXPECT_EQ(optimizer.load(file), expected);
  g2o::logging::setSink({});
  return messages;
}

TEST(Files, AMessageNamesTheLineTheExpectedFieldAndTheActualText) {
  using testing::ElementsAre;
  EXPECT_THAT(messages_of("VERTEX_SE2 1 0 nan 0\n", false),
              ElementsAre("line 1: VERTEX_SE2 1: expected y (a finite number), got 'nan'"));
  EXPECT_THAT(messages_of("\nVERTEX_SE2 1 0 0\n", false),
              ElementsAre("line 2: VERTEX_SE2 1: expected more fields, got the end of the line"));
  EXPECT_THAT(messages_of("VERTEX_SE2 one 0 0 0\n", false),
              ElementsAre("line 1: VERTEX_SE2: expected the id of a vertex, got 'one'"));
  EXPECT_THAT(messages_of("VERTEX_SE2 -1 0 0 0\n", false),
              ElementsAre("line 1: VERTEX_SE2: expected the id of a vertex, got '-1'"));
  EXPECT_THAT(messages_of("EDGE_SE2 0\n", false),
              ElementsAre("line 1: EDGE_SE2: expected the id of a vertex, got the end of the line"));
  EXPECT_THAT(
      messages_of("PARAMS_SE2OFFSET\n", false),
      ElementsAre("line 1: PARAMS_SE2OFFSET: expected the id of a parameter, got the end of the line"));
  EXPECT_THAT(messages_of("VERTEX_SE2 0 0 0 0 \x01\n", false),
              ElementsAre("line 1: VERTEX_SE2: expected the end of the line, got '\\x01'"));
}

/// A client type whose read() refuses negative values.
class VertexLevel : public g2o::BaseVertex<1, double> {
 public:
  void setToOriginImpl() override { _estimate = 0; }
  void oplusImpl(const double* update) override { _estimate += *update; }
  bool read(std::istream& is) override { return is >> _estimate && _estimate >= 0; }
  bool write(std::ostream& os) const override { return static_cast<bool>(os << _estimate); }
};

TEST(Files, AMessageNamesTheLineIfTheReadFunctionOfAClientTypeFails) {
  using testing::ElementsAre;
  const g2o::RegisterTypeProxy<VertexLevel> registered("VERTEX_LEVEL");
  EXPECT_THAT(messages_of("VERTEX_LEVEL 0 high\n", false),
              ElementsAre("line 1: VERTEX_LEVEL 0: expected a number, got 'high'"));
  EXPECT_THAT(messages_of("VERTEX_LEVEL 0\n", false),
              ElementsAre("line 1: VERTEX_LEVEL 0: expected more fields, got the end of the line"));
  EXPECT_THAT(messages_of("VERTEX_LEVEL 0 -1\n", false),
              ElementsAre("line 1: VERTEX_LEVEL 0: the read() of this type does not accept the fields"));
}

/// A client type whose read() ends with `return is.good()`, which is false if read() reached the end of the
/// line. Many clients do this.
class VertexGood : public VertexLevel {
 public:
  bool read(std::istream& is) override {
    is >> _estimate;
    return is.good();
  }
};

TEST(Files, AReadFunctionThatReturnsIsGoodMayReachTheEndOfTheLine) {
  const g2o::RegisterTypeProxy<VertexGood> registered("VERTEX_GOOD");
  using testing::ElementsAre;
  EXPECT_THAT(messages_of("VERTEX_GOOD 0 1.5\nVERTEX_GOOD 1 -2.5\r\nVERTEX_GOOD 2 3 \n", true),
              ElementsAre());
  EXPECT_THAT(messages_of("VERTEX_GOOD 0 1.5 2\n", false),
              ElementsAre("line 1: VERTEX_GOOD: expected the end of the line, got '2'"));
  EXPECT_THAT(messages_of("VERTEX_GOOD 0\n", false),
              ElementsAre("line 1: VERTEX_GOOD 0: expected more fields, got the end of the line"));
}

class VertexUnwritten : public VertexLevel {
 public:
  bool write(std::ostream&) const override { return false; }
};

TEST(Files, AMessageNamesTheTypeOfAnElementThatCannotBeWritten) {
  const g2o::RegisterTypeProxy<VertexUnwritten> registered("VERTEX_UNWRITTEN");
  std::vector<std::string> messages;
  g2o::logging::setSink([&](g2o::logging::Level, const std::string& text) { messages.push_back(text); });
  g2o::SparseOptimizer optimizer;
  auto* v = new VertexUnwritten;
  v->setId(0);
  optimizer.addVertex(v);
  std::ostringstream out;
  EXPECT_FALSE(optimizer.save(out));
  g2o::logging::setSink({});
  EXPECT_THAT(messages, testing::ElementsAre("save: write() of VERTEX_UNWRITTEN returned false"));
}

TEST(Files, AnEdgeWithAZeroInformationMatrixHasNoWeight) {
  const std::string text = "VERTEX_SE2 0 0 0 0\nFIX 0\nVERTEX_SE2 1 1 0 0\nEDGE_SE2 0 1 2 0 0 0 0 0 0 0 0\n";
  g2o::SparseOptimizer optimizer;
  std::istringstream in(text);
  ASSERT_TRUE(optimizer.load(in));
  ASSERT_TRUE(optimizer.initializeOptimization());
  optimizer.computeActiveErrors();
  EXPECT_EQ(optimizer.activeChi2(), 0);
  std::ostringstream out;
  EXPECT_TRUE(optimizer.save(out));
  EXPECT_EQ(out.str(), text);
}

TEST(Files, AnIndefiniteInformationMatrixIsRefused) {
  EXPECT_THAT(messages_of("VERTEX_XY 0 0 0\nVERTEX_XY 1 1 0\nEDGE_POINTXY 0 1 1 0 1 2 1\n", false),
              testing::ElementsAre(testing::HasSubstr("line 3: EDGE_POINTXY: ")));
}

/// A file that cannot be read.
struct BrokenFile : std::streambuf {
  int_type underflow() override { throw std::runtime_error("broken"); }
};

TEST(Files, AFolderAndABrokenFileCannotBeLoaded) {
  std::vector<std::string> messages;
  g2o::logging::setSink([&](g2o::logging::Level, const std::string& said) { messages.push_back(said); });
  g2o::SparseOptimizer optimizer;
  EXPECT_FALSE(optimizer.load("/"));
  BrokenFile buffer;
  std::istream broken(&buffer);
  EXPECT_FALSE(optimizer.load(broken));
  g2o::logging::setSink({});
  EXPECT_THAT(messages, testing::ElementsAre("/ cannot be opened", "line 1: this line cannot be read"));
}

TEST(Files, AFullDiskIsReportedAsAFailure) {
  if (!std::ifstream("/dev/full")) GTEST_SKIP() << "there is no /dev/full";
  std::string message;
  int messages = 0;
  g2o::logging::setSink([&](g2o::logging::Level, const std::string& said) {
    message = said;
    ++messages;
  });
  g2o::SparseOptimizer optimizer;
  small_graph::add_square(optimizer);
  EXPECT_FALSE(optimizer.save("/dev/full"));
  EXPECT_EQ(message, "/dev/full cannot be written");
  // The text of so many poses is longer than one output buffer.
  for (int id = 4; id < 5000; ++id) small_graph::add_pose(optimizer, id, id, 0, 0);
  messages = 0;
  EXPECT_FALSE(optimizer.save("/dev/full"));
  EXPECT_EQ(message, "/dev/full cannot be written");
  EXPECT_LE(messages, 3);
  g2o::logging::setSink({});
}

TEST(Files, LinesMayReferToLaterLines) {
  g2o::SparseOptimizer optimizer;
  std::istringstream file(
      "FIX 0\nEDGE_SE2_POINTXY_OFFSET 0 6 3 1 0 1 0 1\nVERTEX_XY 6 1 0\nVERTEX_SE2 0 0 0 0\n"
      "PARAMS_SE2OFFSET 3 1 1 0\n");
  EXPECT_TRUE(optimizer.load(file));
  EXPECT_EQ(optimizer.edges().size(), 1u);
  EXPECT_TRUE(optimizer.vertex(0)->fixed());
}

}  // namespace
