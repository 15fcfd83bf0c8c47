// SPDX-License-Identifier: BSD-3-Clause
#include "kept_vertices.h"

#include <algorithm>
#include <bit>
#include <map>
#include <string>

#include "boxplus/base/error.h"

namespace boxplus::mpi {
namespace {

/// What a process tells others about a vertex that is not eliminated.
struct Record {
  static constexpr std::size_t kWords = 4;
  std::uint64_t is_vertex, id, flags, estimate;

  static constexpr std::uint64_t kMoves = 1ull << 32, kFixed = 1ull << 33;
  std::uint32_t dim() const { return static_cast<std::uint32_t>(flags); }
  bool moves() const { return (flags & kMoves) != 0; }
  auto key() const { return std::pair(is_vertex, static_cast<Id>(id)); }
};

/// A checksum (FNV-1a) of numbers.
class Checksum {
 public:
  void add(double number) { sum_ = (sum_ ^ std::bit_cast<std::uint64_t>(number)) * 0x100000001B3u; }
  std::uint64_t value() const { return sum_; }

 private:
  std::uint64_t sum_ = 0xCBF29CE484222325u;
};

std::uint64_t checksum(detail::VertexPool& pool, std::uint32_t slot) {
  Checksum sum;
  detail::Frame frame;
  if (pool.get_frame(slot, frame)) {
    for (const double number : frame.rotation) sum.add(number);
    for (const double number : frame.translation) sum.add(number);
  }
  for (int i = 0; i < pool.tangent_dim(slot); ++i) {
    if (const double* entry = pool.entry(slot, i)) sum.add(*entry);
  }
  for (const int direction : pool.fixed_directions(slot)) sum.add(direction);
  return sum.value();
}

/// The kept blocks of a plan. If it eliminates all vertices, none is eliminated in fact (SchurSolver).
std::uint32_t first_kept(const Plan& plan) {
  return plan.eliminated_blocks == plan.structure.blocks() ? 0 : plan.eliminated_blocks;
}

std::vector<std::uint64_t> describe(const Graph& graph, const Plan& plan) {
  std::vector<std::vector<std::uint8_t>> moves;
  for (const auto& pool : graph.vertex_pools()) moves.emplace_back(pool->slots(), 0);
  for (std::uint32_t block = first_kept(plan); block < plan.structure.blocks(); ++block)
    moves[plan.block_vertex[block].pool][plan.block_vertex[block].slot] = 1;
  std::vector<std::uint64_t> words;
  for (std::size_t p = 0; p < moves.size(); ++p) {
    detail::VertexPool& pool = *graph.vertex_pools()[p];
    for (std::uint32_t slot = 0; slot < pool.slots(); ++slot) {
      if (!pool.alive(slot) || (pool.eliminated(slot) && moves[p][slot] == 0)) continue;
      const std::uint64_t flags = static_cast<std::uint32_t>(pool.tangent_dim(slot)) |
                                  (moves[p][slot] != 0 ? Record::kMoves : 0) |
                                  (pool.fixed(slot) ? Record::kFixed : 0);
      for (const std::uint64_t word :
           {std::uint64_t{pool.parameter(slot) ? 0u : 1u}, static_cast<std::uint64_t>(pool.id(slot)), flags,
            checksum(pool, slot)})
        words.push_back(word);
    }
  }
  return words;
}

/// Throws if two processes describe a vertex differently.
void check_equal(const Record& a, int rank_a, const Record& b, int rank_b) {
  const bool same = (a.flags & ~Record::kMoves) == (b.flags & ~Record::kMoves) && a.estimate == b.estimate;
  if (same) return;
  throw InvalidArgument("vertex " + std::to_string(static_cast<Id>(a.id)) +
                        " is not the same in the processes " + std::to_string(rank_a) + " and " +
                        std::to_string(rank_b) +
                        ": expected equal estimates, sizes, fixed flags and fixed directions");
}

}  // namespace

KeptVertices::KeptVertices(Communicator& communicator, const Graph& graph, const Plan& plan,
                           std::uint32_t most)
    : communicator_(&communicator) {
  struct Known {
    Record record;
    int rank, owner = -1;
  };
  std::map<std::pair<std::uint64_t, Id>, Known> known;
  std::vector<int> counts;
  const std::vector<std::uint64_t> words = communicator.gather(describe(graph, plan), &counts);
  const std::uint64_t* next = words.data();
  for (int rank = 0; rank < communicator.size(); ++rank) {
    for (int k = 0; k < counts[rank]; k += Record::kWords, next += Record::kWords) {
      const Record record{next[0], next[1], next[2], next[3]};
      Known& vertex = known.try_emplace(record.key(), Known{record, rank}).first->second;
      check_equal(vertex.record, vertex.rank, record, rank);
      if (record.moves() && vertex.owner < 0) vertex.owner = rank;
    }
  }
  struct Place {
    std::uint32_t vertex, first;
    int owner;
  };
  std::map<std::pair<std::uint64_t, Id>, Place> places;
  for (const auto& [key, vertex] : known) {
    if (vertex.owner < 0) continue;
    places[key] = {count(), scalars_, vertex.owner};
    ids_.push_back(key.second);
    dims_.push_back(vertex.record.dim());
    scalars_ += vertex.record.dim();
  }
  if (count() > most) {
    throw InvalidArgument("expected at most " + std::to_string(most) +
                          " vertices that are not eliminated, because each process solves for all of them "
                          "(unless PETSc divides their system); got " +
                          std::to_string(count()));
  }
  own_unknowns_ = plan.free_scalars();
  for (std::uint32_t block = first_kept(plan); block < plan.structure.blocks(); ++block) {
    const VertexRef& vertex = plan.block_vertex[block];
    const detail::VertexPool& pool = *graph.vertex_pools()[vertex.pool];
    const Place& place = places.at({pool.parameter(vertex.slot) ? 0 : 1, pool.id(vertex.slot)});
    const bool own = place.owner == communicator.rank();
    const std::uint32_t dim = plan.structure.dim(block);
    local_.push_back({place.vertex, plan.structure.offset[block], place.first, dim, own});
    own_ += own;
    if (!own) own_unknowns_ -= dim - static_cast<std::uint32_t>(pool.fixed_directions(vertex.slot).size());
  }
  shared_.resize(scalars_);
}

void KeptVertices::complete(std::span<double> of_plan) {
  std::ranges::fill(shared_, 0.0);
  for_each_scalar([&](std::uint32_t i, std::uint32_t all, bool own) {
    if (own) shared_[all] = of_plan[i];
  });
  communicator_->add_up(shared_);
  for_each_scalar([&](std::uint32_t i, std::uint32_t all, bool) { of_plan[i] = shared_[all]; });
}

void KeptVertices::leave_own(std::span<double> of_plan) const {
  for_each_scalar([&](std::uint32_t i, std::uint32_t, bool own) {
    if (!own) of_plan[i] = 0;
  });
}

}  // namespace boxplus::mpi
