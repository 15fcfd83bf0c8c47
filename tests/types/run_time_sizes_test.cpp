// SPDX-License-Identifier: BSD-3-Clause
// Ready-made edges whose sizes are chosen at run time refuse vertices of other sizes.
#include <gmock/gmock.h>

#include <functional>

#include "boxplus/graph/graph.h"
#include "boxplus/manifold/rn.h"
#include "boxplus/types/between.h"
#include "boxplus/types/dense_prior.h"
#include "boxplus/types/prior.h"
#include "boxplus/types/range.h"

namespace boxplus {
namespace {

using Dynamic = Vector<double, kDynamic>;
using testing::ElementsAre;

Dynamic ones(int size) {
  return Dynamic::Ones(size);
}

/// The message of the InvalidArgument that f throws.
std::string refusal(const std::function<void()>& f) {
  try {
    f();
  } catch (const InvalidArgument& error) {
    return error.what();
  }
  return "accepted";
}

TEST(EdgesOfRunTimeSize, AreRefusedIfAVertexHasAnotherSize) {
  Graph graph;
  const auto two = graph.add_vertex(ones(2), 2), three = graph.add_vertex(ones(3), 3),
             other = graph.add_vertex(ones(3), 4);
  const auto fixed = graph.add_vertex(Vector3(1, 2, 3), 5);
  EXPECT_EQ(refusal([&] { graph.add_edge(Prior(ones(5)), three); }),
            "edge of vertex 3 (size 3): expected 5 entries, as the measurement has, got 3");
  EXPECT_EQ(refusal([&] { graph.add_edge(Prior(ones(5)), fixed); }),
            "edge of vertex 5 (size 3): expected 5 entries, as the measurement has, got 3");
  EXPECT_EQ(refusal([&] { graph.add_edge(Prior(Vector3(1, 2, 3)), two); }),
            "edge of vertex 2 (size 2): expected 3 entries, as the measurement has, got 2");
  EXPECT_EQ(
      refusal([&] { graph.add_edge(Between(ones(3)), two, three); }),
      "edge of vertex 2 (size 2), vertex 3 (size 3): expected 2 entries, as the first vertex has, got 3");
  EXPECT_EQ(
      refusal([&] { graph.add_edge(Between(ones(2)), three, other); }),
      "edge of vertex 3 (size 3), vertex 4 (size 3): expected 2 entries, as the measurement has, got 3");
  EXPECT_EQ(
      refusal([&] { graph.add_edge(Range(1), three, two); }),
      "edge of vertex 3 (size 3), vertex 2 (size 2): expected 3 entries, as the first vertex has, got 2");
  const DensePrior<Dynamic> dense({{ones(2), ones(4)}}, Eigen::MatrixXd::Identity(6, 6));
  EXPECT_EQ(refusal([&] {
              graph.add_edge(dense, std::vector{two, three});
            }),
            "edge of vertex 2 (size 2), vertex 3 (size 3): expected 4 entries, as the mean has, got 3");
  EXPECT_EQ(graph.edge_count(), 0u);
}

TEST(EdgesOfRunTimeSize, KeepTheirMeasurementIfANewOneHasAnotherSize) {
  Graph graph;
  const auto vertex = graph.add_vertex(ones(3));
  const auto edge = graph.add_edge(Prior(Dynamic(2 * ones(3))), vertex);
  EXPECT_EQ(refusal([&] { graph.set_measurement(edge, Prior(ones(30))); }),
            "edge of vertex 0 (size 3): expected 30 entries, as the measurement has, got 3");
  EXPECT_THAT(graph.error(edge), ElementsAre(-1, -1, -1));
  graph.set_measurement(edge, Prior(ones(3)));
  EXPECT_EQ(graph.chi2(edge), 0);
}

TEST(EdgesOfRunTimeSize, KeepTheirVerticesFromChangingTheirSize) {
  Graph graph;
  const auto a = graph.add_vertex(ones(3)), b = graph.add_vertex(ones(3)), c = graph.add_vertex(ones(3));
  const auto prior = graph.add_edge(Prior(ones(3)), a);
  graph.add_edge(Between(ones(3)), a, b);
  const auto revision = graph.revision();
  EXPECT_EQ(refusal([&] { graph.set_estimate(a, ones(2)); }),
            "edge of vertex 0 (size 2): expected 3 entries, as the measurement has, got 2");
  EXPECT_EQ(
      refusal([&] { graph.set_estimate(b, ones(4)); }),
      "edge of vertex 0 (size 3), vertex 1 (size 4): expected 3 entries, as the first vertex has, got 4");
  EXPECT_EQ(graph.tangent_dim(a), 3);
  EXPECT_EQ(graph.tangent_dim(b), 3);
  EXPECT_EQ(graph.revision(), revision);
  graph.set_estimate(a, Dynamic(2 * ones(3)));
  EXPECT_EQ(graph.chi2(prior), 3);
  graph.set_estimate(c, ones(7));  // c has no edges
  EXPECT_EQ(graph.tangent_dim(c), 7);
}

TEST(Edge, AnErrorFunctionOfOneRowMayAcceptEverySizeOfItsVertex) {
  Graph graph;
  const auto vertex = graph.add_vertex(ones(3));
  const auto edge = graph.add_edge([](const auto& x) { return x.sum(); }, vertex);
  graph.set_estimate(vertex, ones(5));
  EXPECT_EQ(graph.chi2(edge), 25);
}

}  // namespace
}  // namespace boxplus
