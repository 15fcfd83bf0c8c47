// SPDX-License-Identifier: BSD-3-Clause
#include "gauge/similarity_freedom.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <tuple>

#include "base/disjoint_sets.h"
#include "base/paced_stop.h"
#include "gauge/resistance.h"
#include "gauge/subspace.h"

namespace boxplus {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// A sample of at most `count` edges of each pool, evenly spaced.
std::vector<EdgeSlot> sample_of(std::span<const EdgeSlot> edges, std::size_t count) {
  std::vector<EdgeSlot> sample;
  for (std::size_t begin = 0; begin < edges.size();) {
    std::size_t end = begin;
    while (end < edges.size() && edges[end].pool == edges[begin].pool) ++end;
    const std::size_t stride = (end - begin + count - 1) / count;
    for (std::size_t k = begin; k < end; k += stride) sample.push_back(edges[k]);
    begin = end;
  }
  return sample;
}

}  // namespace

MatrixXd SimilarityFreedom::of_vertex(const Graph& graph, VertexSlot vertex) const {
  const detail::VertexPool& pool = *graph.vertex_pools()[vertex.pool];
  MatrixXd tangents(pool.tangent_dim(vertex.slot), motions.count());
  motion_tangents(pool, vertex.slot, (*roles)[vertex.pool][vertex.slot], motions, tangents.data());
  MatrixXd result = tangents * basis;
  for (std::size_t i = 0; i < own.size(); ++i) {
    if (own[i].vertex.pool == vertex.pool && own[i].vertex.slot == vertex.slot)
      result.row(own[i].component) = own_basis.row(static_cast<Eigen::Index>(i));
  }
  return result;
}

void SimilarityFreedom::keep(const MatrixXd& combinations) {
  basis = (basis * combinations).eval();
  own_basis = (own_basis * combinations).eval();
}

/// A group of vertices of one type that occur at the same positions in the same types of edges.
struct SimilarityTest::Kind {
  std::uint32_t id;
  std::vector<WorldRole> candidates;  // the roles to try, with the most likely one first
};

SimilarityTest::SimilarityTest(const Graph& graph, const std::vector<std::vector<std::uint8_t>>& movable,
                               const StopToken& stop)
    : graph_(graph), movable_(movable), stop_(stop) {
  for (const auto& pool : graph.vertex_pools()) {
    roles_.emplace_back(pool->slots(), WorldRole::kNone);
    kind_of_.emplace_back(pool->slots(), 0);
    tangents_of_.emplace_back(pool->slots(), kStill);
  }
}

std::vector<SimilarityTest::Kind> SimilarityTest::list_kinds(std::span<const VertexSlot> vertices,
                                                             std::span<const EdgeSlot> edges, int dimension) {
  constexpr std::uint32_t kNew = 0xFFFFFFFFu;
  for (const VertexSlot v : vertices) kind_of_[v.pool][v.slot] = kNew;
  // Numbers the combinations of edge pool, position and vertex pool. In edges of run-time size, all positions
  // count as one position.
  std::map<std::tuple<std::uint32_t, int, std::uint32_t>, std::uint32_t> places;
  std::array<std::pair<std::tuple<std::uint32_t, int, std::uint32_t>, std::uint32_t>, 4> recent;
  recent.fill({{kNew, 0, 0}, 0});
  const auto place_of = [&](std::uint32_t edge_pool, int position, std::uint32_t vertex_pool) {
    const std::tuple key(edge_pool, position, vertex_pool);
    auto& [recent_key, place] = recent[static_cast<std::size_t>(position) % recent.size()];
    if (recent_key != key) {
      place = places.try_emplace(key, static_cast<std::uint32_t>(places.size())).first->second;
      recent_key = key;
    }
    return place;
  };
  std::vector<std::pair<std::uint32_t, std::uint32_t>> equal;
  for (const EdgeSlot edge : edges) {
    const detail::EdgePool& pool = *graph_.edge_pools()[edge.pool];
    const auto slots = pool.vertex_slots(edge.slot);
    for (std::size_t i = 0; i < slots.size(); ++i) {
      const std::uint32_t p = pool.vertex_pool(edge.slot, static_cast<int>(i));
      if (!movable_[p][slots[i]] || graph_.vertex_pools()[p]->parameter(slots[i])) continue;
      const std::uint32_t place = place_of(edge.pool, pool.uniform_shape() ? static_cast<int>(i) : -1, p);
      std::uint32_t& kind = kind_of_[p][slots[i]];
      if (kind == kNew) {
        kind = place;
      } else if (kind != place) {
        equal.emplace_back(kind, place);
      }
    }
  }
  DisjointSets sets(places.size());
  for (const auto& [a, b] : equal) sets.join(a, b);
  std::vector<Kind> kinds;
  for (const VertexSlot v : vertices) {
    const detail::VertexPool& pool = *graph_.vertex_pools()[v.pool];
    std::uint32_t& kind = kind_of_[v.pool][v.slot];
    kind = sets.find(kind);
    const auto known = std::find_if(kinds.begin(), kinds.end(), [&](const Kind& k) { return k.id == kind; });
    if (known != kinds.end()) continue;
    detail::Frame frame;
    if (!pool.get_frame(v.slot, frame) || frame.dimension != dimension) continue;
    if (frame.has_rotation) {
      kinds.push_back({kind, {WorldRole::kFrame, WorldRole::kInverse, WorldRole::kNone}});
    } else {
      kinds.push_back({kind, {WorldRole::kFrame, WorldRole::kNone}});
    }
  }
  return kinds;
}

/// Assigns a role to each vertex. `choice` has one digit for each kind, which selects one of its candidates.
void SimilarityTest::assign_roles(std::span<const VertexSlot> vertices, const std::vector<Kind>& kinds,
                                  unsigned choice) {
  std::map<std::uint32_t, WorldRole> role_of;
  for (const Kind& kind : kinds) {
    const auto options = static_cast<unsigned>(kind.candidates.size());
    role_of[kind.id] = kind.candidates[choice % options];
    choice /= options;
  }
  for (const VertexSlot v : vertices) {
    const auto found = role_of.find(kind_of_[v.pool][v.slot]);
    roles_[v.pool][v.slot] = found == role_of.end() ? WorldRole::kNone : found->second;
  }
}

/// The motions about the center of the vertices. The unit of translation is the root mean square distance of
/// the vertices from the center.
WorldMotions SimilarityTest::motions_for(std::span<const VertexSlot> vertices, int dimension) const {
  WorldMotions motions;
  motions.dimension = dimension;
  std::array<double, 3> sum{};
  double squares = 0, count = 0;
  for (const VertexSlot v : vertices) {
    detail::Frame frame;
    const detail::VertexPool& pool = *graph_.vertex_pools()[v.pool];
    if (!world_frame(pool, v.slot, roles_[v.pool][v.slot], dimension, frame)) continue;
    ++count;
    for (std::size_t i = 0; i < 3; ++i) {
      sum[i] += frame.translation[i];
      squares += frame.translation[i] * frame.translation[i];
    }
  }
  if (count == 0) return motions;
  double center_squared = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    motions.center[i] = sum[i] / count;
    center_squared += motions.center[i] * motions.center[i];
  }
  const double variance = squares / count - center_squared;
  if (std::isfinite(variance) && variance > 1e-20 * center_squared) motions.length = std::sqrt(variance);
  return motions;
}

/// An orthonormal basis of the motions that move at least one vertex. Stores the tangents of all motions in
/// tangents_.
MatrixXd SimilarityTest::moving(std::span<const VertexSlot> vertices, const WorldMotions& motions) {
  const int count = motions.count();
  MatrixXd sum = MatrixXd::Zero(count, count), tangents;
  const Eigen::Index row = columns(motions);
  tangents_.clear();
  PacedStop pace(stop_, 64);
  for (const VertexSlot v : vertices) {
    pace.step();
    const detail::VertexPool& pool = *graph_.vertex_pools()[v.pool];
    tangents_of_[v.pool][v.slot] = kStill;
    if (roles_[v.pool][v.slot] == WorldRole::kNone) continue;
    tangents.resize(pool.tangent_dim(v.slot), count);
    motion_tangents(pool, v.slot, roles_[v.pool][v.slot], motions, tangents.data());
    if (!tangents.allFinite()) continue;
    sum.noalias() += tangents.transpose() * tangents;
    tangents_of_[v.pool][v.slot] = tangents_.size();
    tangents_.resize(tangents_.size() + static_cast<std::size_t>(tangents.rows() * row));
    Eigen::Map<RowMajor>(tangents_.data() + tangents_of_[v.pool][v.slot], tangents.rows(), row)
        .leftCols(count) = tangents;
  }
  const double least = 1e-12 * std::max(sum.trace(), 1e-300);
  return eigenvectors_of(sum, [&](double squared) { return squared > least; });
}

/// Stores the tangents of the vertices of own_, whose directions are motions of their own.
void SimilarityTest::set_own_tangents(const WorldMotions& motions) {
  const auto row = static_cast<std::size_t>(columns(motions));
  for (const OwnDirection& own : own_) tangents_of_[own.vertex.pool][own.vertex.slot] = kStill;
  for (std::size_t i = 0; i < own_.size(); ++i) {
    const auto [vertex, component] = own_[i];
    std::size_t& begin = tangents_of_[vertex.pool][vertex.slot];
    if (begin == kStill) {
      begin = tangents_.size();
      const int dim = graph_.vertex_pools()[vertex.pool]->tangent_dim(vertex.slot);
      tangents_.resize(tangents_.size() + static_cast<std::size_t>(dim) * row);
    }
    tangents_[begin + static_cast<std::size_t>(component) * row + row - own_.size() + i] = 1;
  }
}

void SimilarityTest::tangents_of_edge(const detail::EdgePool& pool, std::uint32_t edge, RowMajor& out) const {
  double* row = out.data();
  const auto slots = pool.vertex_slots(edge);
  for (std::size_t i = 0; i < slots.size(); ++i) {
    const std::uint32_t p = pool.vertex_pool(edge, static_cast<int>(i));
    const detail::VertexPool& vertices = *graph_.vertex_pools()[p];
    const auto size = static_cast<std::size_t>(vertices.tangent_dim(slots[i]) * out.cols());
    const std::size_t from = movable_[p][slots[i]] ? tangents_of_[p][slots[i]] : kStill;
    if (from == kStill) {
      std::fill_n(row, size, 0.0);
    } else {
      std::copy_n(tangents_.data() + from, size, row);
    }
    row += size;
  }
}

/// The linear combinations of the candidates that neither an edge nor a fixed direction resists.
MatrixXd SimilarityTest::unresisted(std::span<const VertexSlot> vertices, std::span<const EdgeSlot> edges,
                                    const WorldMotions& world, const MatrixXd& candidates) const {
  constexpr double kExact = 1e-7, kNumeric = 1e-5;
  constexpr std::int64_t kBetweenStops = 64;         // edges between two checks of the stop token
  constexpr std::size_t kEdgesBetweenChecks = 1024;  // edges between two checks for free motions
  const auto motions = static_cast<int>(candidates.rows());
  const auto own = static_cast<Eigen::Index>(own_.size());
  Resistance resistance(motions);
  for (const VertexSlot v : vertices) {
    const auto fixed = graph_.vertex_pools()[v.pool]->fixed_directions(v.slot);
    const std::size_t from = tangents_of_[v.pool][v.slot];
    if (from != kStill) resistance.add_fixed(fixed, tangents_.data() + from, kExact * world.unit());
  }
  RowMajor tangents;
  MatrixXd jacobian;
  VectorXd error;
  PacedStop pace(stop_, kBetweenStops);
  for (std::size_t k = 0; k < edges.size() && candidates.cols() > 0; ++k) {
    pace.step();
    const detail::EdgePool& pool = *graph_.edge_pools()[edges[k].pool];
    const detail::EdgeShape shape = pool.shape(edges[k].slot);
    tangents.resize(shape.cols, motions);
    tangents_of_edge(pool, edges[k].slot, tangents);
    jacobian.resize(shape.rows, shape.cols);
    error.resize(shape.rows);
    detail::EdgeTile tile;
    tile.error = error.data();
    tile.jacobian = jacobian.data();
    pool.linearize(std::span(&edges[k].slot, 1), tile, false);
    const bool exact = pool.jacobian_source() != detail::JacobianSource::kNumeric;
    resistance.add(tile, tangents.data(), exact ? kExact : kNumeric);
    if (k % kEdgesBetweenChecks == kEdgesBetweenChecks - 1 &&
        resistance.unresisted(candidates, own).cols() == 0)
      break;
  }
  return resistance.unresisted(candidates, own);
}

SimilarityFreedom SimilarityTest::free_motions(std::span<const VertexSlot> vertices,
                                               std::span<const EdgeSlot> edges, int dimension) {
  SimilarityFreedom freedom;
  freedom.motions = motions_for(vertices, dimension);
  const MatrixXd moves = moving(vertices, freedom.motions);
  set_own_tangents(freedom.motions);
  const Eigen::Index world = freedom.motions.count(), own = columns(freedom.motions) - world;
  MatrixXd candidates = MatrixXd::Zero(world + own, moves.cols() + own);
  candidates.topLeftCorner(world, moves.cols()) = moves;
  if (own > 0) candidates.bottomRightCorner(own, own).setIdentity();
  const MatrixXd free = unresisted(vertices, edges, freedom.motions, candidates);
  freedom.basis = free.topRows(world);
  freedom.own_basis = MatrixXd::Zero(own, free.cols());
  if (freedom.own_basis.size() > 0) freedom.own_basis = free.bottomRows(own);
  freedom.own = own_;
  freedom.roles = &roles_;
  return freedom;
}

/// The directions of all moving vertices without a frame; none if there are too many.
std::vector<OwnDirection> SimilarityTest::own_directions() const {
  std::vector<OwnDirection> own;
  for (std::uint32_t p = 0; p < movable_.size(); ++p) {
    const detail::VertexPool& pool = *graph_.vertex_pools()[p];
    for (std::uint32_t slot = 0; slot < movable_[p].size(); ++slot) {
      detail::Frame frame;
      if (!movable_[p][slot]) continue;
      if (pool.get_frame(slot, frame)) break;  // all vertices of a pool have one type
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

/// The vertices of the edges that move, each once per edge.
std::vector<VertexSlot> SimilarityTest::moving_ends(std::span<const EdgeSlot> edges) const {
  std::vector<VertexSlot> ends;
  for (const EdgeSlot edge : edges) {
    const detail::EdgePool& pool = *graph_.edge_pools()[edge.pool];
    const auto slots = pool.vertex_slots(edge.slot);
    for (std::size_t i = 0; i < slots.size(); ++i) {
      const std::uint32_t p = pool.vertex_pool(edge.slot, static_cast<int>(i));
      if (movable_[p][slots[i]] && !graph_.vertex_pools()[p]->parameter(slots[i]))
        ends.push_back({p, slots[i]});
    }
  }
  return ends;
}

SimilarityFreedom SimilarityTest::find(std::span<const VertexSlot> vertices, std::span<const EdgeSlot> edges,
                                       int dimension, Extent extent) {
  constexpr double kInWorld = 1e-6;
  SimilarityFreedom freedom = find_roles_and_motions(vertices, edges, dimension, extent);
  if (freedom.has_scale()) return freedom;
  own_ = own_directions();
  if (own_.empty()) return freedom;
  SimilarityFreedom wider = find_with_roles(vertices, edges, dimension, extent);
  for (const OwnDirection& own : own_) tangents_of_[own.vertex.pool][own.vertex.slot] = kStill;
  own_.clear();
  // Motions of vertices without a frame alone are no similarities.
  const MatrixXd world = wider.basis.transpose() * wider.basis;
  wider.keep(eigenvectors_of(world, [&](double squared) { return squared > kInWorld * kInWorld; }));
  for (int i = 0; i < wider.directions(); ++i) {
    const double size = wider.basis.col(i).norm();
    wider.basis.col(i) /= size;
    wider.own_basis.col(i) /= size;
  }
  return wider.directions() > freedom.directions() && wider.has_scale() ? wider : freedom;
}

/// Assigns the roles, and finds the free motions that change no vertex without a frame.
SimilarityFreedom SimilarityTest::find_roles_and_motions(std::span<const VertexSlot> vertices,
                                                         std::span<const EdgeSlot> edges, int dimension,
                                                         Extent extent) {
  constexpr unsigned kMostChoices = 100;
  const std::vector<Kind> kinds = list_kinds(vertices, edges, dimension);
  unsigned choices = 1;
  for (const Kind& kind : kinds) {
    choices *= static_cast<unsigned>(kind.candidates.size());
    if (choices > kMostChoices) break;
  }
  if (choices > kMostChoices) choices = 1;
  unsigned best = 0;
  int most = -1;
  const std::vector<EdgeSlot> sample = sample_of(edges, 8);
  const std::vector<VertexSlot> seen = moving_ends(sample);
  for (unsigned choice = 0; choice < choices && choices > 1; ++choice) {
    assign_roles(seen, kinds, choice);
    const int directions = free_motions(seen, sample, dimension).directions();
    if (directions <= most) continue;
    most = directions;
    best = choice;
  }
  assign_roles(vertices, kinds, best);
  return find_with_roles(vertices, edges, dimension, extent);
}

SimilarityFreedom SimilarityTest::find_with_roles(std::span<const VertexSlot> vertices,
                                                  std::span<const EdgeSlot> edges, int dimension,
                                                  Extent extent) {
  if (extent == Extent::kAllEdges) return free_motions(vertices, edges, dimension);
  const std::vector<EdgeSlot> tested = sample_of(edges, kTestedEdges);
  if (tested.size() == edges.size()) return free_motions(vertices, edges, dimension);
  std::vector<VertexSlot> ends = moving_ends(tested);
  std::copy_if(vertices.begin(), vertices.end(), std::back_inserter(ends), [this](VertexSlot v) {
    return !graph_.vertex_pools()[v.pool]->fixed_directions(v.slot).empty();
  });
  return free_motions(ends, tested, dimension);
}

}  // namespace boxplus
