// SPDX-License-Identifier: BSD-3-Clause
// If add_vertex() or add_edge() throws, the graph is unchanged, no matter which copy of a user type or which
// call of a user function threw.
#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

#include "boxplus/graph/graph.h"
#include "boxplus/manifold/rn.h"

namespace boxplus {

/// A number whose copies and moves throw if the countdown has reached zero.
struct Fragile {
  static inline int countdown = 1 << 30;
  static void tick() {
    if (countdown-- <= 0) throw std::runtime_error("fragile");
  }
  double x = 0;
  explicit Fragile(double value) : x(value) {}
  Fragile(const Fragile& other) : x(other.x) { tick(); }
  Fragile& operator=(const Fragile& other) {
    tick();
    x = other.x;
    return *this;
  }
};

template <>
struct Manifold<Fragile> {
  static constexpr int kDim = 1;
  static Fragile oplus(const Fragile& x, const double* delta) { return Fragile(x.x + delta[0]); }
  static void ominus(const Fragile& y, const Fragile& x, double* delta) { delta[0] = y.x - x.x; }
};

namespace {

/// Calls `f` until it succeeds. The n-th call of `f` throws at the n-th copy of a Fragile. After each
/// exception, calls `check`.
template <class F, class Check>
void fail_everywhere(F&& f, Check&& check) {
  for (int allowed = 0; allowed < 20; ++allowed) {
    Fragile::countdown = allowed;
    try {
      f();
      Fragile::countdown = 1 << 30;
      return;
    } catch (const std::runtime_error&) {
      Fragile::countdown = 1 << 30;
      check();
    }
  }
  FAIL() << "f failed 20 times";
}

TEST(ExceptionSafety, AVertexThatCannotBeCopiedIsNotAdded) {
  Graph graph;
  const auto first = graph.add_vertex(Fragile(0), 0);
  for (Id id = 1; id < 5; ++id) {
    fail_everywhere([&] { graph.add_vertex(Fragile(static_cast<double>(id)), id); },
                    [&] {
                      EXPECT_EQ(graph.vertex_count(), static_cast<std::size_t>(id));
                      EXPECT_EQ(graph.find_vertex(id), std::nullopt);
                      EXPECT_EQ(graph.vertex_pools()[0]->alive_count(), static_cast<std::uint32_t>(id));
                    });
    EXPECT_EQ(graph.estimate(graph.vertex<Fragile>(id)).x, static_cast<double>(id));
  }
  graph.remove(first);
  fail_everywhere([&] { graph.add_vertex(Fragile(9), 9); },
                  [&] { EXPECT_EQ(graph.vertex_pools()[0]->alive_count(), 4u); });
  EXPECT_EQ(graph.estimate(graph.vertex<Fragile>(9)).x, 9);
  EXPECT_EQ(graph.estimate(graph.vertex<Fragile>(3)).x, 3);
}

struct FragileError {
  Fragile target;
  double operator()(double x) const { return x - target.x; }
};

TEST(ExceptionSafety, AnEdgeThatCannotBeCopiedIsNotAdded) {
  Graph graph;
  const auto a = graph.add_vertex(1.0);
  std::vector<EdgeHandle<FragileError>> edges;
  for (int k = 0; k < 5; ++k) {
    fail_everywhere([&] { edges.push_back(graph.add_edge(FragileError{Fragile(k)}, 2.0 + k, a)); },
                    [&] { EXPECT_EQ(graph.edge_count(), edges.size()); });
  }
  for (int k = 0; k < 5; ++k) {
    const auto& edge = edges[static_cast<std::size_t>(k)];
    EXPECT_EQ(graph.measurement(edge).target.x, k);
    EXPECT_EQ(graph.information(edge)(0, 0), 2.0 + k);
    EXPECT_EQ(graph.chi2(edge), (2.0 + k) * (1 - k) * (1 - k));
  }
  graph.remove(edges[2]);
  fail_everywhere([&] { edges[2] = graph.add_edge(FragileError{Fragile(7)}, 3.0, a); },
                  [&] { EXPECT_EQ(graph.edge_count(), 4u); });
  EXPECT_EQ(graph.chi2(edges[2]), 108);
}

TEST(ExceptionSafety, AnEdgeWhoseErrorThrowsIsNotAdded) {
  Graph graph;
  const auto a = graph.add_vertex(1.0);
  bool fail = true;
  const auto error = [&fail](double x) {
    if (fail) throw std::runtime_error("no error today");
    return std::vector{x, x};
  };
  EXPECT_THROW(graph.add_edge(error, a), std::runtime_error);
  EXPECT_EQ(graph.edge_count(), 0u);
  fail = false;
  EXPECT_EQ(graph.chi2(graph.add_edge(error, a)), 2);
}

}  // namespace
}  // namespace boxplus
