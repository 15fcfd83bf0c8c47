// SPDX-License-Identifier: BSD-3-Clause
// Graph::add_edge_pool(): edges whose vertex types are known only at run time.
#include "boxplus/graph/edge_pool.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <vector>

#include "boxplus/boxplus.h"

namespace boxplus {
namespace {

using testing::HasSubstr;

/// Edges that pull every coordinate of a point and of a clock offset, which have different types, to a
/// number.
class PullPool final : public detail::EdgePool {
 public:
  PullPool(std::uint32_t points, std::uint32_t clocks, const detail::VertexPool* point,
           const detail::VertexPool* clock)
      : EdgePool({points, clocks}, 0), point_(point), clock_(clock) {}

  std::uint32_t add(double target, std::span<const std::uint32_t> slots) {
    const std::uint32_t slot = acquire_slot(slots, {}, Information(1.0), 3);
    targets_.resize(this->slots());
    targets_[slot] = target;
    return slot;
  }

  std::unique_ptr<EdgePool> clone(std::span<const std::unique_ptr<detail::VertexPool>> pools) const override {
    auto copy = std::make_unique<PullPool>(*this);
    copy->point_ = pools[argument_pool(0)].get();
    copy->clock_ = pools[argument_pool(1)].get();
    return copy;
  }
  std::string_view type_name() const override { return "Pull"; }
  detail::EdgeShape shape(std::uint32_t) const override { return {2, 3, 3}; }
  bool uniform_shape() const override { return true; }
  void errors(std::span<const std::uint32_t> edges, double* out) const override {
    for (const std::uint32_t edge : edges) {
      const auto slots = vertex_slots(edge);
      const Vector2& p = static_cast<const detail::TypedVertexPool<Vector2>&>(*point_).value(slots[0]);
      const double t = static_cast<const detail::TypedVertexPool<double>&>(*clock_).value(slots[1]);
      for (const double value : {p[0], p[1], t}) *out++ = value - targets_[edge];
    }
  }
  void linearize(std::span<const std::uint32_t> edges, detail::EdgeTile& tile, bool) const override {
    tile.count = static_cast<int>(edges.size());
    tile.rows = tile.cols = 3;
    tile.in_lanes = false;
    errors(edges, tile.error);
    for (std::size_t k = 0; k < edges.size(); ++k) {
      Eigen::Map<Eigen::Matrix3d> jacobian(tile.jacobian + 9 * k);
      jacobian.setIdentity();
    }
  }
  detail::JacobianSource jacobian_source() const override { return detail::JacobianSource::kAnalytic; }
  void reserve(std::size_t edges) override { reserve_slots(edges); }

 private:
  const detail::VertexPool *point_, *clock_;
  std::vector<double> targets_;
};

class RunTimeEdgePool : public testing::Test {
 protected:
  EdgeRef add(double target, std::array<VertexRef, 2> vertices) {
    return graph_.add_edge(pool_, vertices,
                           [&](std::span<const std::uint32_t> slots) { return pull_->add(target, slots); });
  }

  Graph graph_;
  VertexHandle<Vector2> point_ = graph_.add_vertex(Vector2(1, 2), 5);
  VertexHandle<double> clock_ = graph_.add_vertex(3.0, 6);
  PullPool* pull_ = new PullPool(point_.pool, clock_.pool, graph_.vertex_pools()[point_.pool].get(),
                                 graph_.vertex_pools()[clock_.pool].get());
  std::uint32_t pool_ = graph_.add_edge_pool(std::unique_ptr<detail::EdgePool>(pull_));
};

TEST_F(RunTimeEdgePool, TakesPartInEverything) {
  const EdgeRef edge = add(7, {point_, clock_});
  EXPECT_EQ(graph_.vertices(edge), (std::vector<VertexRef>{point_, clock_}));
  EXPECT_EQ(graph_.error(edge), (std::vector<double>{-6, -5, -4}));
  EXPECT_EQ(graph_.edges(clock_), std::vector<EdgeRef>{edge});
  const EdgeRef second = add(9, {point_, clock_});  // after edges() has built its index
  EXPECT_EQ(graph_.edges(clock_).size(), 2u);
  EXPECT_TRUE(optimize(graph_).converged());
  EXPECT_NEAR(graph_.estimate(clock_), 8, 1e-12);
  graph_.remove(second);
  EXPECT_TRUE(optimize(graph_).converged());
  EXPECT_NEAR(graph_.estimate(point_)[1], 7, 1e-12);
  const EdgeRef third = add(1, {point_, clock_});
  EXPECT_EQ(third.slot, second.slot);
  EXPECT_FALSE(graph_.contains(second));
}

TEST_F(RunTimeEdgePool, IsCopiedWithTheGraph) {
  add(7, {point_, clock_});
  Graph copy = graph_;
  EXPECT_TRUE(optimize(copy).converged());
  EXPECT_NEAR(copy.estimate(clock_), 7, 1e-12);
  EXPECT_EQ(graph_.estimate(clock_), 3);
}

TEST_F(RunTimeEdgePool, RefusesOtherVertices) {
  const auto complaint = [&](std::array<VertexRef, 2> vertices) -> std::string {
    try {
      add(7, vertices);
    } catch (const InvalidArgument& error) {
      return error.what();
    }
    return {};
  };
  EXPECT_THAT(complaint({clock_, point_}), HasSubstr("vertex 6: expected the type"));
  EXPECT_THAT(complaint({point_, VertexRef{clock_.pool, 77, 0}}), HasSubstr("stale"));
  EXPECT_EQ(graph_.edge_count(), 0u);
  EXPECT_THROW(graph_.add_edge(99, {}, [](auto) { return 0u; }), InvalidArgument);
  EXPECT_THROW(graph_.add_edge_pool(std::make_unique<PullPool>(0, 9, nullptr, nullptr)), InvalidArgument);
  EXPECT_EQ(graph_.edge_pools().size(), 1u);
}

TEST_F(RunTimeEdgePool, HasNoMeasurement) {
  const EdgeRef edge = add(7, {point_, clock_});
  EXPECT_THROW(graph_.measurement(EdgeHandle<Prior<double>>{edge}), InvalidArgument);
}

}  // namespace
}  // namespace boxplus
