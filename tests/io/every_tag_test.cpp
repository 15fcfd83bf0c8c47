// SPDX-License-Identifier: BSD-3-Clause
// What holds for every tag of the library, checked with the example in its registration.
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <random>
#include <sstream>

#include "boxplus/io/registry.h"
#include "io/complaint.h"

namespace boxplus {
namespace {

class EveryTag : public testing::TestWithParam<std::string> {
 protected:
  const std::string text_ = default_registry().example(GetParam());
};

INSTANTIATE_TEST_SUITE_P(Library, EveryTag, testing::ValuesIn(default_registry().names()),
                         [](const auto& test) {
                           std::string name = test.param;
                           std::replace(name.begin(), name.end(), ':', '_');
                           return name;
                         });

TEST_P(EveryTag, IsWrittenAsItIsReadUnlessItIsOld) {
  const GraphFile file = parse_graph(text_, "g");
  EXPECT_TRUE(file.kept.empty());
  EXPECT_TRUE(file.notes.empty());
  const std::string written = format_graph(file);
  if (default_registry().find(GetParam())->written) {
    EXPECT_EQ(written, text_);
  } else {
    EXPECT_EQ(written.find(GetParam() + " "), std::string::npos);
    EXPECT_EQ(format_graph(parse_graph(written, "g")), written);
  }
}

/// The last line of a text, which is an example of a tag.
struct LastLine {
  std::string before;  ///< the lines before it
  std::vector<std::string> fields;
  std::int64_t number = 1;

  explicit LastLine(const std::string& text) {
    const std::size_t begin = text.rfind('\n', text.size() - 2) + 1;  // 0 if there is only one line
    before = text.substr(0, begin);
    number += std::count(before.begin(), before.end(), '\n');
    std::istringstream line(text.substr(begin));
    for (std::string field; line >> field;) fields.push_back(field);
  }

  /// The first `count` fields.
  std::string begin(std::size_t count) const {
    std::string line = fields[0];
    for (std::size_t i = 1; i < count; ++i) line += ' ' + fields[i];
    return line;
  }
};

/// The reader must name this place. The lenient reader must skip the line and nothing else.
void expect_complaint(const LastLine& last, const std::string& bad, std::size_t column) {
  const std::string place = "g:" + std::to_string(last.number) + ":" + std::to_string(column) + ": expected ";
  EXPECT_EQ(complaint(last.before + bad + "\n").substr(0, place.size()), place) << bad;
  ReadOptions lenient;
  lenient.lenient = true;
  const GraphFile file = parse_graph(last.before + bad + "\n", "g", lenient);
  EXPECT_EQ(file.skipped, 1) << bad;
  EXPECT_EQ(format_graph(file), format_graph(parse_graph(last.before, "g", lenient)));
}

TEST_P(EveryTag, HasNoLineThatCanEndEarlier) {
  const LastLine last(text_);
  const auto optional = static_cast<std::size_t>(default_registry().find(GetParam())->optional_fields);
  for (std::size_t count = 1; count < last.fields.size(); ++count) {
    if (optional > 0 && count == last.fields.size() - optional) continue;
    expect_complaint(last, last.begin(count), last.begin(count).size() + 1);
  }
}

TEST_P(EveryTag, CanEndBeforeItsOptionalFieldsWithANote) {
  const auto optional = static_cast<std::size_t>(default_registry().find(GetParam())->optional_fields);
  if (optional == 0) GTEST_SKIP() << "no optional fields";
  const LastLine last(text_);
  const std::string line = last.begin(last.fields.size() - optional);
  const GraphFile file = parse_graph(last.before + line + "\n", "g");
  ASSERT_EQ(file.notes.size(), 1u);
  EXPECT_EQ(file.notes[0].line, last.number);
  const LastLine written(format_graph(file));
  EXPECT_EQ(written.fields.size(), last.fields.size());
  EXPECT_EQ(written.begin(last.fields.size() - optional), line);
}

TEST_P(EveryTag, HasNoFieldThatCanBeAWord) {
  const LastLine last(text_);
  for (std::size_t i = 1; i < last.fields.size(); ++i) {
    LastLine bad = last;
    bad.fields[i] = "word";
    expect_complaint(last, bad.begin(bad.fields.size()), last.begin(i).size() + 2);
  }
}

TEST_P(EveryTag, HasNoLineThatCanBeLonger) {
  const LastLine last(text_);
  const std::string line = last.begin(last.fields.size());
  expect_complaint(last, line + " 1", line.size() + 2);
}

void move_all_vertices(const Graph& graph, std::mt19937& random) {
  for (const VertexRef& vertex : graph.all_vertices()) {
    detail::VertexPool& pool = *graph.vertex_pools()[vertex.pool];
    std::vector<double> delta(static_cast<std::size_t>(pool.tangent_dim(vertex.slot)));
    for (double& d : delta) d = std::uniform_real_distribution<double>(-0.5, 0.5)(random);
    const std::uint32_t offset = 0;
    pool.oplus(std::span(&vertex.slot, 1), std::span(&offset, 1), delta.data());
  }
}

Eigen::VectorXd jacobian(const Graph& graph, EdgeRef edge, bool force_numeric) {
  const detail::EdgePool& pool = *graph.edge_pools()[edge.pool];
  const detail::EdgeShape shape = pool.shape(edge.slot);
  Eigen::VectorXd error(shape.rows), jacobian(shape.rows * shape.cols);
  detail::EdgeTile tile;
  tile.error = error.data();
  tile.jacobian = jacobian.data();
  pool.linearize(std::span(&edge.slot, 1), tile, force_numeric);
  return jacobian;
}

TEST_P(EveryTag, HasCorrectJacobiansAtRandomEstimates) {
  if (default_registry().find(GetParam())->kind != Tag::Kind::kEdge) GTEST_SKIP() << "not an edge";
  // A numeric derivative is wrong if an error jumps (half a turn) or has a pole (points in the plane of a
  // camera).
  constexpr int kTrials = 1000, kMostAtJumps = 3;
  std::mt19937 random(1);
  int wrong = 0;
  for (int trial = 0; trial < kTrials; ++trial) {
    const GraphFile file = parse_graph(text_, "g");
    move_all_vertices(file.graph, random);
    ASSERT_FALSE(file.edges.empty());
    for (const EdgeRef& edge : file.edges) {
      const Eigen::VectorXd expected = jacobian(file.graph, edge, true);
      EXPECT_GT(expected.norm(), 0);
      wrong += !((jacobian(file.graph, edge, false) - expected).norm() < 1e-6 * (1 + expected.norm()));
    }
  }
  EXPECT_LE(wrong, kMostAtJumps);
}

}  // namespace
}  // namespace boxplus
