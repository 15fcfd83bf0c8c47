// SPDX-License-Identifier: BSD-3-Clause
// The times of IMU preintegration: per measurement, and per edge and linearization.
#include <benchmark/benchmark.h>

#include <numeric>
#include <span>
#include <vector>

#include "boxplus/testing/simulate_inertial.h"
#include "boxplus/types/inertial.h"
#include "linearize/linearizer.h"

namespace boxplus {
namespace {

/// The motions between the keyframes of a flight, at 100 measurements per motion.
std::vector<Preintegration> motions_of(const InertialSimulation& flight) {
  std::vector<Preintegration> motions;
  for (std::size_t k = 0; k + 1 < flight.keyframes.size(); ++k) {
    motions.emplace_back(ImuNoise{});
    for (int i = flight.keyframes[k].next_sample; i < flight.keyframes[k + 1].next_sample; ++i) {
      const auto& [omega, force] = flight.samples[static_cast<std::size_t>(i)];
      motions.back().integrate(omega, force, flight.sample_seconds);
    }
  }
  return motions;
}

const InertialSimulation& flight() {
  static const InertialSimulation simulation = simulate_inertial({.landmarks = 1});
  return simulation;
}

/// All keyframes at their true states. With an unknown direction of gravity, the edges have a seventh vertex.
Graph make_graph(bool with_down) {
  Graph graph;
  std::vector<VertexHandle<SE3>> poses;
  std::vector<VertexHandle<Vector3>> velocities;
  std::vector<VertexHandle<ImuBias>> biases;
  for (const auto& keyframe : flight().keyframes) {
    poses.push_back(graph.add_vertex(keyframe.true_state.pose));
    velocities.push_back(graph.add_vertex(keyframe.true_state.velocity));
    biases.push_back(graph.add_vertex(keyframe.true_bias));
  }
  const auto down = graph.add_vertex(S2(flight().gravity));
  const std::vector<Preintegration> motions = motions_of(flight());
  for (std::size_t k = 0; k < motions.size(); ++k) {
    const InertialBetween edge(motions[k].motion());
    const Information information = motions[k].information();
    if (with_down) {
      graph.add_edge(edge, information, poses[k], velocities[k], biases[k], poses[k + 1], velocities[k + 1],
                     biases[k + 1], down);
    } else {
      graph.add_edge(edge, information, poses[k], velocities[k], biases[k], poses[k + 1], velocities[k + 1],
                     biases[k + 1]);
    }
  }
  return graph;
}

void preintegrate(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(motions_of(flight()));
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(flight().samples.size()));
}
BENCHMARK(preintegrate);

/// Errors and Jacobians, a tile at a time as in the solver. state.range(0): with gravity as a vertex.
void linearize(benchmark::State& state) {
  const Graph graph = make_graph(state.range(0) != 0);
  const detail::EdgePool& pool = *graph.edge_pools()[0];
  const detail::EdgeShape shape = pool.shape(0);
  std::vector<std::uint32_t> edges(static_cast<std::size_t>(tile_capacity(shape)));
  std::iota(edges.begin(), edges.end(), 0);
  const std::size_t rows = edges.size() * static_cast<std::size_t>(shape.rows);
  std::vector<double> error(rows), jacobian(rows * static_cast<std::size_t>(shape.cols));
  detail::EdgeTile tile;
  tile.error = error.data();
  tile.jacobian = jacobian.data();
  for (auto _ : state) {
    pool.linearize(edges, tile, false);
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(edges.size()));
}
BENCHMARK(linearize)->Arg(0)->Arg(1);

/// The same for all edges, and the products with Ω that are added to H and to the gradient, on one thread.
void linearize_and_add(benchmark::State& state) {
  const Graph graph = make_graph(state.range(0) != 0);
  PlanRequest request;
  request.threads = 1;
  const Plan plan = make_plan(graph, request);
  Linearizer linearizer(graph, plan);
  for (auto _ : state) {
    linearizer.linearize({});
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(plan.edge_count));
}
BENCHMARK(linearize_and_add)->Arg(0)->Arg(1);

}  // namespace
}  // namespace boxplus
