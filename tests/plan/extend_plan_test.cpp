// SPDX-License-Identifier: BSD-3-Clause
#include "plan/extend_plan.h"

#include <gtest/gtest.h>

#include <map>
#include <random>

#include "boxplus/types/slam2d.h"
#include "linearize/linearizer.h"

namespace boxplus {
namespace {

constexpr auto kSighting = [](const auto& pose, const auto& point) {
  return (pose.inverse() * point).eval();
};
constexpr auto kNear = [](const auto& a, const auto& b) {
  return (b.translation() - a.translation()).eval();
};

/// A growing chain of poses that see points, and its plan, which can be extended.
class Growing {
 public:
  explicit Growing(unsigned seed, bool fix_first = true) : random_(seed) {
    poses_.push_back(graph.add_vertex(SE2(), next_id_++));
    if (fix_first) graph.fix(poses_[0]);
    for (int k = 0; k < 5; ++k) append();
    if (!fix_first) return;
    points_.push_back(graph.add_vertex(Vector2(1, 2), next_id_++));
    see(points_[0]);
    add_near(poses_[1]);
  }

  void append() {
    poses_.push_back(graph.add_vertex(SE2(number(), number(), number()), next_id_++));
    graph.add_edge(Between(SE2(number(), number(), number())), 2.0, poses_[poses_.size() - 2], poses_.back());
  }
  void close() { add_near(poses_[random_() % (poses_.size() - 1)]); }
  void add_point() {
    points_.push_back(graph.add_vertex(Vector2(number(), number()), next_id_++));
    see(points_.back());
  }
  void see_again() { see(points_[random_() % points_.size()]); }
  void any_addition() {
    if (points_.empty()) {  // no vertex is fixed, so only relative measurements between poses are added
      graph.add_edge(Between(SE2(number(), number(), number())), poses_[random_() % (poses_.size() - 1)],
                     poses_.back());
      return;
    }
    const std::array<void (Growing::*)(), 4> additions{&Growing::append, &Growing::close, &Growing::add_point,
                                                       &Growing::see_again};
    (this->*additions[random_() % 4])();
  }

  void plan(const PlanRequest& request) {
    plan_ = make_plan(graph, request);
    note();
  }
  /// Removes poses in the middle of the chain. Their neighbors stay connected by an edge.
  void remove_some(std::size_t count) {
    for (; count > 0; --count) {
      const std::size_t k = 2 + random_() % (poses_.size() - 4);
      graph.add_edge(Between(SE2(number(), number(), number())), poses_[k - 1], poses_[k + 1]);
      graph.remove(poses_[k]);
      poses_.erase(poses_.begin() + static_cast<std::ptrdiff_t>(k));
    }
    std::erase_if(points_, [&](VertexHandle<Vector2> point) {  // of those that no pose sees any more
      if (!graph.edges(point).empty()) return false;
      graph.remove(point);
      return true;
    });
  }
  bool extend(const PlanRequest& request) {
    const bool done = is_extensible(graph, plan_) && extend_plan(graph, request, planned_, plan_);
    if (done) note();
    return done;
  }
  const Plan& extended() const { return plan_; }
  std::uint32_t count_poses() const { return static_cast<std::uint32_t>(poses_.size()); }
  const std::vector<VertexHandle<SE2>>& poses() const { return poses_; }

  Graph graph;

 private:
  double number() { return std::uniform_real_distribution<>(-1, 1)(random_); }
  void note() { planned_.note(graph); }
  void see(VertexHandle<Vector2> point) { graph.add_edge(kSighting, poses_.back(), point); }
  void add_near(VertexHandle<SE2> pose) { graph.add_edge(kNear, poses_.back(), pose); }

  std::mt19937 random_;
  Id next_id_ = 0;
  std::vector<VertexHandle<SE2>> poses_;
  std::vector<VertexHandle<Vector2>> points_;
  Plan plan_;
  PlannedElements planned_;
};

void expect_equal(const Plan& a, const Plan& b) {
  EXPECT_EQ(a.block_vertex, b.block_vertex);
  EXPECT_EQ(a.structure, b.structure);
  EXPECT_EQ(a.edge_count, b.edge_count);
  ASSERT_EQ(a.edges.size(), b.edges.size());
  for (std::size_t k = 0; k < a.edges.size(); ++k) {
    EXPECT_EQ(a.edges[k].first, b.edges[k].first);
    EXPECT_EQ(a.edges[k].edges, b.edges[k].edges);
  }
  ASSERT_EQ(a.vertices.size(), b.vertices.size());
  for (std::size_t k = 0; k < a.vertices.size(); ++k) {
    EXPECT_EQ(a.vertices[k].slots, b.vertices[k].slots);
    EXPECT_EQ(a.vertices[k].offsets, b.vertices[k].offsets);
  }
  ASSERT_EQ(a.held.size(), b.held.size());
  for (std::size_t k = 0; k < a.held.size(); ++k) {
    EXPECT_EQ(a.held[k].vertex, b.held[k].vertex);
  }
  EXPECT_EQ(a.held_scalars, b.held_scalars);
  EXPECT_EQ(a.undetermined_blocks, b.undetermined_blocks);
}

void expect_equal_chunks(const Plan& a, const Plan& b) {
  ASSERT_EQ(a.chunks.size(), b.chunks.size());
  for (std::size_t c = 0; c < a.chunks.size(); ++c) {
    EXPECT_EQ(a.chunks[c].last_column, b.chunks[c].last_column);
    ASSERT_EQ(a.chunks[c].scatters.size(), b.chunks[c].scatters.size());
    for (std::size_t k = 0; k < a.chunks[c].scatters.size(); ++k) {
      EXPECT_EQ(a.chunks[c].scatters[k].edges, b.chunks[c].scatters[k].edges);
      EXPECT_EQ(a.chunks[c].scatters[k].targets, b.chunks[c].scatters[k].targets);
    }
  }
}

TEST(ExtendPlan, ReturnsTheSamePlanAsMakePlan) {
  int extended = 0;
  for (unsigned seed = 0; seed < 20; ++seed) {
    Growing growing(seed, seed % 2 == 0);
    growing.plan({});
    for (int step = 0; step < 40; ++step) {
      growing.append();
      for (unsigned k = 0; k < seed % 4; ++k) growing.any_addition();
      if (growing.extend({})) {
        ++extended;
        const Plan expected = make_plan(growing.graph, {});
        expect_equal(growing.extended(), expected);
        expect_equal_chunks(growing.extended(), expected);
      } else {
        growing.plan({});
      }
    }
  }
  EXPECT_GT(extended, 700) << "most of the 800 extensions must succeed";
}

/// The same lists as in a new plan, except that additions in old slots come last.
void expect_equal_up_to_order(Plan a, Plan b) {
  EXPECT_EQ(a.block_vertex, b.block_vertex);
  EXPECT_EQ(a.structure, b.structure);
  EXPECT_EQ(a.edge_count, b.edge_count);
  ASSERT_EQ(a.edges.size(), b.edges.size());
  for (std::size_t k = 0; k < a.edges.size(); ++k) {
    std::ranges::sort(a.edges[k].edges);
    EXPECT_EQ(a.edges[k].edges, b.edges[k].edges);
  }
  ASSERT_EQ(a.vertices.size(), b.vertices.size());
  for (std::size_t k = 0; k < a.vertices.size(); ++k) {
    std::map<std::uint32_t, std::uint32_t> of_a, of_b;
    for (std::size_t i = 0; i < a.vertices[k].slots.size(); ++i) {
      of_a[a.vertices[k].slots[i]] = a.vertices[k].offsets[i];
      of_b[b.vertices[k].slots[i]] = b.vertices[k].offsets[i];
    }
    EXPECT_EQ(of_a, of_b);
  }
}

TEST(ExtendPlan, AcceptsElementsInSlotsThatRemovedElementsHadLeft) {
  for (unsigned seed = 0; seed < 10; ++seed) {
    Growing growing(seed);
    for (int k = 0; k < 200; ++k) growing.any_addition();
    for (int k = 0; k < 60; ++k) growing.append();
    growing.remove_some(40);
    const std::uint32_t slots = growing.graph.vertex_pools()[0]->slots();
    growing.plan({});
    for (int step = 0; step < 50; ++step) {
      growing.append();
      growing.any_addition();
      ASSERT_TRUE(growing.extend({})) << step;
      const Plan expected = make_plan(growing.graph, {});
      expect_equal_up_to_order(growing.extended(), expected);
      Linearizer a(growing.graph, growing.extended()), b(growing.graph, expected);
      a.linearize({});
      b.linearize({});
      EXPECT_NEAR(a.chi2(), b.chi2(), 1e-12 * b.chi2());
      ASSERT_EQ(a.values().size(), b.values().size());
      for (std::size_t i = 0; i < a.values().size(); ++i) {
        ASSERT_NEAR(a.values()[i], b.values()[i], 1e-11 * (1 + std::abs(b.values()[i])));
      }
    }
    EXPECT_EQ(growing.graph.vertex_pools()[0]->slots(), std::max(slots, growing.count_poses()))
        << "the slots are used again";
  }
}

TEST(ExtendPlan, LeadsToTheSameBitsOfHForAnyNumberOfWorkers) {
  Growing one(3), three(3);
  for (int k = 0; k < 8000; ++k) {
    one.any_addition();
    three.any_addition();
  }
  one.plan({.threads = 1});
  three.plan({.threads = 3});
  ASSERT_GT(three.extended().chunks.size(), 1u);
  for (int step = 0; step < 20; ++step) {
    for (Growing* growing : {&one, &three}) {
      growing->append();
      growing->any_addition();
      growing->any_addition();
      ASSERT_TRUE(growing->extend({}));
    }
    Linearizer a(one.graph, one.extended()), b(three.graph, three.extended());
    a.linearize({});
    b.linearize({});
    EXPECT_TRUE(std::equal(a.values().begin(), a.values().end(), b.values().begin(), b.values().end()));
    EXPECT_TRUE(
        std::equal(a.gradient().begin(), a.gradient().end(), b.gradient().begin(), b.gradient().end()));
    EXPECT_EQ(a.chi2(), b.chi2());
  }
}

/// Each change in the list `changes` requires a new plan.
TEST(ExtendPlan, IsRefusedIfTheStructureChangesAnywhereButAtItsEnd) {
  using Change = void (*)(Growing&);
  const std::vector<std::pair<const char*, Change>> changes{
      {"a vertex with a lower id",
       [](Growing& g) { g.graph.add_edge(kNear, g.poses()[2], g.graph.add_vertex(SE2(), 0)); }},
      {"a second component",
       [](Growing& g) {
         const auto a = g.graph.add_vertex(SE2()), b = g.graph.add_vertex(SE2());
         g.graph.add_edge(Between(SE2()), a, b);
       }},
      {"a new type of edges",
       [](Growing& g) { g.graph.add_edge([](const auto& p) { return p.x(); }, g.poses()[2]); }},
      {"a new type of vertices",
       [](Growing& g) {
         g.graph.add_edge([](const auto& p, const auto& x) { return p.x() - x; }, g.poses()[2],
                          g.graph.add_vertex(1.0));
       }},
      {"an eliminated vertex", [](Growing& g) {
         g.add_point();
         const auto all = g.graph.all_vertices();  // the last vertex is the first pose, which has the id 1000
         g.graph.set_eliminated(all[all.size() - 2], true);
       }}};
  for (const auto& [name, change] : changes) {
    SCOPED_TRACE(name);
    Growing growing(1);
    growing.graph.change_id(growing.poses()[0], 5000);
    growing.graph.change_id(growing.poses()[0], 1000);
    growing.plan({});
    change(growing);
    EXPECT_FALSE(growing.extend({}));
  }
}

TEST(ExtendPlan, IsRefusedForTwoComponentsOrIfANewEdgeFixesTheGauge) {
  Growing growing(1, false);
  // A vertex with a prior is a second component.
  growing.graph.add_edge(Prior(SE2()), growing.graph.add_vertex(SE2()));
  growing.plan({});
  EXPECT_FALSE(growing.extend({})) << "two components";
  Growing held(1, false);
  const auto fixed = held.graph.add_vertex(SE2());
  held.graph.fix(fixed);
  held.plan({});
  ASSERT_EQ(held.extended().held.size(), 1u);
  held.graph.add_edge(Between(SE2()), held.poses()[3], fixed);
  EXPECT_FALSE(held.extend({}));
}

TEST(ExtendPlan, IsRefusedForSubsets) {
  Growing growing(1);
  const std::vector<VertexRef> subset{growing.poses()[2], growing.poses()[3]};
  growing.plan({.vertices = subset});
  growing.append();
  EXPECT_FALSE(growing.extend({.vertices = subset}));
}

}  // namespace
}  // namespace boxplus
