// SPDX-License-Identifier: BSD-3-Clause
// The linearizer finds errors and Jacobians that are not finite, and reports their edge.
#include "linearize/non_finite.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "boxplus/manifold/rn.h"
#include "boxplus/robust/redescending.h"

namespace boxplus {
namespace {

constexpr auto kSquareRoot = [](const auto& x) {
  using std::sqrt;
  return sqrt(x);
};
constexpr auto kIdentity = [](const auto& x) { return 1.0 * x; };

struct Roots {
  Graph graph;
  VertexHandle<double> negative, zero, one;
  EdgeRef of_one, of_negative, of_zero;

  Roots() {
    negative = graph.add_vertex(-1.0);
    zero = graph.add_vertex(0.0);
    one = graph.add_vertex(1.0);
    for (const auto& x : {negative, zero, one}) graph.add_edge(kIdentity, x);
    of_one = graph.add_edge(kSquareRoot, one);
    of_negative = graph.add_edge(kSquareRoot, negative);
    of_zero = graph.add_edge(kSquareRoot, zero);
  }
};

TEST(NonFinite, AnErrorIsFoundAndItsEdgeIsReported) {
  Roots r;
  const Plan plan = make_plan(r.graph, {});
  Linearizer linearizer(r.graph, plan);
  EXPECT_FALSE(std::isfinite(linearizer.chi2()));
  EXPECT_EQ(find_non_finite_error(r.graph, plan), r.of_negative);
  r.graph.set_estimate(r.negative, 4.0);
  EXPECT_TRUE(std::isfinite(linearizer.chi2()));
  EXPECT_EQ(find_non_finite_error(r.graph, plan), std::nullopt);
}

TEST(NonFinite, ADisabledEdgeIsNotEvaluated) {
  Roots r;
  r.graph.set_enabled(r.of_negative, false);
  r.graph.set_enabled(r.of_zero, false);
  const Plan plan = make_plan(r.graph, {});
  Linearizer linearizer(r.graph, plan);
  linearizer.linearize({});
  EXPECT_EQ(linearizer.chi2(), 1 + 1 + 1);
  EXPECT_EQ(find_non_finite_error(r.graph, plan), std::nullopt);
  EXPECT_EQ(find_non_finite_jacobian(r.graph, plan, {}), std::nullopt);
}

TEST(NonFinite, AJacobianIsFoundEvenIfTheErrorIsFinite) {
  Roots r;
  r.graph.set_estimate(r.negative, 4.0);
  const Plan plan = make_plan(r.graph, {});
  Linearizer linearizer(r.graph, plan);
  EXPECT_TRUE(std::isfinite(linearizer.chi2()));
  EXPECT_EQ(find_non_finite_jacobian(r.graph, plan, {}), r.of_zero);
}

TEST(NonFinite, AnErrorIsFoundUnderEveryKernel) {
  Roots r;
  r.graph.set_estimate(r.one, std::numeric_limits<double>::infinity());
  r.graph.set_kernel(r.of_negative, Tukey(1));
  r.graph.set_kernel(r.of_one, Saturated(1));
  const Plan plan = make_plan(r.graph, {});
  Linearizer linearizer(r.graph, plan);
  EXPECT_FALSE(std::isfinite(linearizer.chi2()));
  EXPECT_FALSE(std::isfinite(r.graph.chi2()));
  r.graph.remove(r.graph.all_edges()[2]);
  const Plan without_identity = make_plan(r.graph, {});
  EXPECT_EQ(find_non_finite_error(r.graph, without_identity), r.of_one);
}

}  // namespace
}  // namespace boxplus
