// SPDX-License-Identifier: BSD-3-Clause
// For every tag that the engine and the g2o API know: both compute the same chi2 for a file.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "boxplus/io/graph_file.h"
#include "boxplus/io/registry.h"
#include "g2o/core/factory.h"
#include "g2o/core/sparse_optimizer.h"

G2O_USE_TYPE_GROUP(slam2d);
G2O_USE_TYPE_GROUP(slam2d_segment);
G2O_USE_TYPE_GROUP(sclam);
G2O_USE_TYPE_GROUP(slam3d);
G2O_USE_TYPE_GROUP(slam3d_addons);
G2O_USE_TYPE_GROUP(sba);
G2O_USE_TYPE_GROUP(expmap);
G2O_USE_TYPE_GROUP(sim3);
G2O_USE_TYPE_GROUP(icp);

namespace {

class EveryTag : public testing::TestWithParam<std::string> {};

INSTANTIATE_TEST_SUITE_P(Engine, EveryTag, testing::ValuesIn(boxplus::default_registry().names()),
                         [](const auto& test) {
                           std::string name = test.param;
                           std::replace(name.begin(), name.end(), ':', '_');
                           return name;
                         });

/// The example of a tag, with moved vertices.
std::string moved_example(const std::string& tag, std::mt19937& random) {
  const boxplus::GraphFile file = boxplus::parse_graph(boxplus::default_registry().example(tag), "example");
  for (const boxplus::VertexRef& vertex : file.graph.all_vertices()) {
    boxplus::detail::VertexPool& pool = *file.graph.vertex_pools()[vertex.pool];
    std::vector<double> delta(static_cast<std::size_t>(pool.tangent_dim(vertex.slot)));
    for (double& d : delta) d = std::uniform_real_distribution<double>(-0.3, 0.3)(random);
    const std::uint32_t offset = 0;
    pool.oplus(std::span(&vertex.slot, 1), std::span(&offset, 1), delta.data());
  }
  return boxplus::format_graph(file);
}

TEST_P(EveryTag, HasTheSameChi2InTheEngineAndInTheG2oApi) {
  if (!g2o::Factory::instance()->knowsTag(GetParam())) GTEST_SKIP() << "not in the g2o API";
  if (boxplus::default_registry().find(GetParam())->kind != boxplus::Tag::Kind::kEdge)
    GTEST_SKIP() << "not an edge";
  std::mt19937 random(1);
  for (int trial = 0; trial < 20; ++trial) {
    const std::string text = moved_example(GetParam(), random);
    const boxplus::GraphFile file = boxplus::parse_graph(text, "moved");
    g2o::SparseOptimizer optimizer;
    std::istringstream lines(text);
    ASSERT_TRUE(optimizer.load(lines));
    ASSERT_EQ(optimizer.edges().size(), file.edges.size());
    for (g2o::HyperGraph::Edge* edge : optimizer.edges())
      static_cast<g2o::OptimizableGraph::Edge*>(edge)->computeError();
    const double expected = optimizer.chi2();
    EXPECT_NEAR(file.graph.chi2(), expected, 1e-9 * (1 + expected)) << text;
  }
}

}  // namespace
