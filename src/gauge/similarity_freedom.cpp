// SPDX-License-Identifier: BSD-3-Clause
#include "gauge/similarity_freedom.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/paced_stop.h"
#include "gauge/subspace.h"
#include "graph/weighted_rows.h"

namespace boxplus {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Adds the squares of the changes of errors, relative to the sums of the magnitudes of their terms.
void add_resistance(const MatrixXd& changes, const VectorXd& magnitudes, MatrixXd& sum) {
  constexpr double kRounding = 1e-7;
  for (Eigen::Index row = 0; row < changes.rows(); ++row) {
    if (!(changes.row(row).norm() > kRounding * magnitudes[row])) continue;  // also if it is not finite
    const VectorXd change = changes.row(row).transpose() / magnitudes[row];
    sum.noalias() += change * change.transpose();
  }
}

}  // namespace

SimilarityTest::SimilarityTest(const Graph& graph, const std::vector<std::vector<std::uint8_t>>& movable,
                               const EdgeEnds& ends, std::span<const std::uint8_t> shared,
                               const StopToken& stop)
    : graph_(graph),
      ends_(ends),
      stop_(stop),
      all_own_(own_directions(movable, shared)),
      kind_of_(ends.view().numbers()),
      tangents_(ends.view().numbers()) {
  for (const auto& pool : graph.vertex_pools()) roles_.emplace_back(pool->slots(), WorldRole::kNone);
}

void SimilarityTest::select(std::span<const VertexSlot> vertices, std::span<const EdgeSlot> edges,
                            std::span<const EdgeSlot> anchors, std::span<const VertexSlot> left_out) {
  constexpr std::uint32_t kNone = 0xFFFFFFFFu;
  vertices_ = vertices;
  edges_ = edges;
  anchors_ = anchors;
  own_ = all_own_;
  for (const VertexSlot v : left_out) {
    roles_[v.pool][v.slot] = WorldRole::kNone;
    tangents_[ends_.number(v)] = {};
    std::erase_if(own_, [&](const OwnDirection& direction) { return direction.vertex == v; });
  }
  // The first vertex at each position of the edges of the current pool. In edges of run-time size, all
  // positions of vertices of one type count as one position.
  std::vector<std::uint32_t> first_at;
  for (std::size_t k = 0; k < edges.size(); ++k) {
    if (k == 0 || edges[k].pool != edges[k - 1].pool) first_at.clear();
    const bool uniform = graph_.edge_pools()[edges[k].pool]->uniform_shape();
    ends_.for_each_moving(edges[k], [&](VertexSlot v, std::size_t position) {
      const std::size_t place = uniform ? position : v.pool;
      if (first_at.size() <= place) first_at.resize(place + 1, kNone);
      if (first_at[place] == kNone) first_at[place] = ends_.number(v);
      kind_of_.join(first_at[place], ends_.number(v));
    });
  }
  kinds_.clear();
  for (const VertexSlot v : vertices) {
    const std::uint32_t id = kind_of_.find(ends_.number(v));
    if (std::any_of(kinds_.begin(), kinds_.end(), [&](const Kind& k) { return k.id == id; })) continue;
    detail::Frame frame;
    if (!graph_.vertex_pools()[v.pool]->get_frame(v.slot, frame)) continue;
    std::vector<WorldRole> candidates{WorldRole::kFrame, WorldRole::kInverse, WorldRole::kNone};
    if (!frame.has_rotation) std::erase(candidates, WorldRole::kInverse);
    // A similarity has as many directions as the similarities of its world.
    if (frame.has_rotation &&
        graph_.vertex_pools()[v.pool]->tangent_dim(v.slot) == (frame.dimension == 2 ? 4 : 7))
      candidates.push_back(WorldRole::kSimilarity);
    kinds_.push_back({id, frame.dimension, std::move(candidates)});
  }
}

SimilarityFreedom SimilarityTest::find(int dimension, Extent extent) {
  constexpr double kInWorld = 1e-6;
  if (std::ranges::none_of(kinds_, [&](const Kind& kind) { return kind.dimension == dimension; })) return {};
  constexpr std::size_t kFewEdges = 8;
  const int expected = choose_roles(dimension, kFewEdges);
  SimilarityFreedom freedom = find_with_roles(dimension, extent);
  if (freedom.directions() < expected) {  // other edges may leave more free with other roles
    choose_roles(dimension, kTestedEdges);
    freedom = find_with_roles(dimension, extent);
  }
  if (freedom.motions.own.empty()) return freedom;
  // Motions of vertices without a frame alone are no similarities.
  const MatrixXd world = freedom.basis.topRows(freedom.motions.in_world());
  freedom.keep(eigenvectors_of(world.transpose() * world,
                               [&](double squared) { return squared > kInWorld * kInWorld; }));
  return freedom;
}

SimilarityFreedom SimilarityTest::find_with_roles(int dimension, Extent extent) {
  assign_roles(vertices_, dimension);
  if (extent == Extent::kAllEdges) return free_motions(vertices_, edges_, dimension, own_);
  const std::vector<EdgeSlot> tested = sample(kTestedEdges);
  return free_motions(moving_ends(tested), tested, dimension, own_);
}

/// Finds the combination of roles for which a sample of the edges leaves most motions free. Returns their
/// number, or 0 if there is nothing to choose.
int SimilarityTest::choose_roles(int dimension, std::size_t tested_edges) {
  constexpr std::size_t kMostCombinations = 100;
  std::size_t combinations = 1;
  for (Kind& kind : kinds_) {
    kind.choice = 0;
    if (kind.dimension == dimension && combinations <= kMostCombinations)
      combinations *= kind.candidates.size();
  }
  if (combinations == 1 || combinations > kMostCombinations) return 0;
  const std::vector<EdgeSlot> edges = sample(tested_edges);
  const std::vector<VertexSlot> ends = moving_ends(edges);
  std::vector<Kind> best = kinds_;
  int most = -1;
  for (std::size_t i = 0; i < combinations; ++i) {
    std::size_t digits = i;
    for (Kind& kind : kinds_) {
      if (kind.dimension != dimension) continue;
      kind.choice = digits % kind.candidates.size();
      digits /= kind.candidates.size();
    }
    assign_roles(ends, dimension);
    const int directions = free_motions(ends, edges, dimension, {}).directions();
    if (directions > most) best = kinds_;
    most = std::max(most, directions);
  }
  kinds_ = std::move(best);
  return most;
}

void SimilarityTest::assign_roles(std::span<const VertexSlot> vertices, int dimension) {
  for (const VertexSlot v : vertices) {
    const std::uint32_t id = kind_of_.find(ends_.number(v));
    const auto kind = std::find_if(kinds_.begin(), kinds_.end(),
                                   [&](const Kind& k) { return k.id == id && k.dimension == dimension; });
    roles_[v.pool][v.slot] = kind == kinds_.end() ? WorldRole::kNone : kind->candidates[kind->choice];
  }
}

/// A sample of at most `count` edges of each pool and `count` of its anchors, both evenly spaced.
std::vector<EdgeSlot> SimilarityTest::sample(std::size_t count) const {
  std::vector<EdgeSlot> sample;
  for (const std::span<const EdgeSlot> edges : {edges_, anchors_}) {
    for (std::size_t begin = 0; begin < edges.size();) {
      std::size_t end = begin;
      while (end < edges.size() && edges[end].pool == edges[begin].pool) ++end;
      const std::size_t stride = (end - begin + count - 1) / count;
      for (std::size_t k = begin; k < end; k += stride) sample.push_back(edges[k]);
      begin = end;
    }
  }
  return sample;
}

/// The vertices of the edges that move, each once per edge, and all vertices with fixed directions.
std::vector<VertexSlot> SimilarityTest::moving_ends(std::span<const EdgeSlot> edges) const {
  std::vector<VertexSlot> ends;
  for (const EdgeSlot edge : edges)
    ends_.for_each_moving(edge, [&](VertexSlot v, std::size_t) { ends.push_back(v); });
  for (const VertexSlot v : vertices_) {
    if (!graph_.vertex_pools()[v.pool]->fixed_directions(v.slot).empty()) ends.push_back(v);
  }
  return ends;
}

/// The directions of all moving vertices without a frame that belong to one component; none if there are too
/// many.
std::vector<OwnDirection> SimilarityTest::own_directions(
    const std::vector<std::vector<std::uint8_t>>& movable, std::span<const std::uint8_t> shared) const {
  std::vector<OwnDirection> own;
  for (std::uint32_t p = 0; p < movable.size(); ++p) {
    const detail::VertexPool& pool = *graph_.vertex_pools()[p];
    for (std::uint32_t slot = 0; slot < movable[p].size(); ++slot) {
      detail::Frame frame;
      if (!movable[p][slot]) continue;
      if (pool.get_frame(slot, frame)) break;  // all vertices of a pool have one type
      if (shared[ends_.number({p, slot})]) continue;
      const auto fixed = pool.fixed_directions(slot);
      for (int i = 0; i < pool.tangent_dim(slot); ++i) {
        if (std::find(fixed.begin(), fixed.end(), i) != fixed.end()) continue;
        if (own.size() == kMostOwn) return {};
        own.push_back({{p, slot}, i});
      }
    }
  }
  return own;
}

SimilarityFreedom SimilarityTest::free_motions(std::span<const VertexSlot> vertices,
                                               std::span<const EdgeSlot> edges, int dimension,
                                               std::vector<OwnDirection> own) {
  SimilarityFreedom freedom{motions_about_center(vertices, dimension), {}, &roles_};
  freedom.motions.own = std::move(own);
  freedom.basis = moving(vertices, freedom.motions);
  if (freedom.basis.cols() > 0) freedom.basis = unresisted(vertices, edges, freedom.motions, freedom.basis);
  for (const OwnDirection& direction : freedom.motions.own) tangents_[ends_.number(direction.vertex)] = {};
  return freedom;
}

/// The motions about the center of the vertices. The unit of translation is the root mean square distance of
/// the vertices from the center.
WorldMotions SimilarityTest::motions_about_center(std::span<const VertexSlot> vertices, int dimension) const {
  WorldMotions motions;
  motions.dimension = dimension;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double squares = 0, count = 0;
  for (const VertexSlot v : vertices) {
    detail::Frame frame;
    if (!world_frame(graph_, v, roles_[v.pool][v.slot], dimension, frame)) continue;
    const Eigen::Map<const Eigen::Vector3d> position(frame.translation.data());
    ++count;
    sum += position;
    squares += position.squaredNorm();
  }
  if (count == 0) return motions;
  motions.center = sum / count;
  const double center_squared = motions.center.squaredNorm();
  const double variance = squares / count - center_squared;
  if (variance > 1e-20 * center_squared) motions.length = std::sqrt(variance);
  return motions;
}

/// An orthonormal basis of the motions that move at least one vertex. Stores their tangents.
MatrixXd SimilarityTest::moving(std::span<const VertexSlot> vertices, const WorldMotions& motions) {
  const int world = motions.in_world(), own = motions.count() - world;
  MatrixXd sum = MatrixXd::Zero(world, world);
  PacedStop pace(stop_, 64);
  for (const VertexSlot v : vertices) {
    pace.step();
    Tangents& tangents = tangents_[ends_.number(v)];
    const WorldRole role = roles_[v.pool][v.slot];
    if (role == WorldRole::kNone) {
      tangents = {};
      continue;
    }
    tangents.set(motion_tangents(graph_, v, role, motions));
    const auto in_world = tangents.values.leftCols(world);
    sum += in_world.transpose().lazyProduct(in_world);
  }
  for (const auto& [v, component] : motions.own)
    tangents_[ends_.number(v)].set(motion_tangents(graph_, v, WorldRole::kNone, motions));
  const double least = 1e-12 * sum.trace();
  const MatrixXd moves = eigenvectors_of(sum, [&](double squared) { return squared > least; });
  MatrixXd candidates = MatrixXd::Zero(world + own, moves.cols() + own);
  if (candidates.cols() == 0) return candidates;
  candidates.topLeftCorner(world, moves.cols()) = moves;
  candidates.bottomRightCorner(own, own).setIdentity();
  return candidates;
}

/// The linear combinations of the candidates that neither an edge nor a fixed direction resists. Flattened,
/// because a client's allocation of dynamic matrices must not replace that of the library (tests/abi).
[[gnu::flatten]] MatrixXd SimilarityTest::unresisted(std::span<const VertexSlot> vertices,
                                                     std::span<const EdgeSlot> edges,
                                                     const WorldMotions& motions, MatrixXd candidates) const {
  constexpr double kNothing = 1e-12, kRounding = 1e-15;
  MatrixXd sum = MatrixXd::Zero(motions.count(), motions.count()), jacobian, changes;
  for (const VertexSlot v : vertices) {
    const Tangents& tangents = tangents_[ends_.number(v)];
    for (const int direction : graph_.vertex_pools()[v.pool]->fixed_directions(v.slot)) {
      if (tangents.values.size() == 0) continue;
      add_resistance(tangents.values.row(direction), tangents.norms.row(direction), sum);
    }
  }
  VectorXd error, magnitudes;
  PacedStop pace(stop_, 64);
  for (const EdgeSlot edge : edges) {
    pace.step();
    const detail::EdgePool& pool = *graph_.edge_pools()[edge.pool];
    const detail::EdgeShape shape = pool.shape(edge.slot);
    jacobian.resize(shape.rows, shape.cols);
    error.resize(shape.rows);
    detail::EdgeTile tile;
    tile.error = error.data();
    tile.jacobian = jacobian.data();
    pool.linearize(std::span(&edge.slot, 1), tile, false);
    changes.setZero(shape.rows, motions.count());
    magnitudes.setZero(shape.rows);
    Eigen::Index column = 0;
    ends_.for_each(edge, [&](VertexSlot v, EdgeEnds::End, std::size_t) {
      const Tangents& tangents = tangents_[ends_.number(v)];
      const Eigen::Index dim = graph_.vertex_pools()[v.pool]->tangent_dim(v.slot);
      const auto of_vertex = jacobian.middleCols(std::exchange(column, column + dim), dim);
      if (tangents.values.size() == 0) return;
      changes += of_vertex.lazyProduct(tangents.values);
      magnitudes += of_vertex.cwiseAbs().lazyProduct(tangents.norms);
    });
    const detail::InformationView omega = pool.information(edge.slot, shape.rows);
    for (int row = 0; row < shape.rows; ++row) {
      if (!is_structural(omega, row)) changes.row(row).setZero();
    }
    add_resistance(changes, magnitudes, sum);
  }
  // The directions `own` have units of their own, so their resistance is 1 by definition.
  for (int i = motions.in_world(); i < motions.count(); ++i) {
    if (sum(i, i) > 0) candidates.row(i) /= std::sqrt(sum(i, i));
  }
  const MatrixXd among = candidates.transpose() * sum * candidates;
  const double nothing = std::max(kNothing, kRounding * among.trace());  // eigenvalues have rounding errors
  return candidates * eigenvectors_of(among, [&](double resistance) { return resistance <= nothing; });
}

}  // namespace boxplus
