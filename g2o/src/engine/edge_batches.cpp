// SPDX-License-Identifier: BSD-3-Clause
#include "engine/edge_batches.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <typeinfo>
#include <utility>

#include "boxplus/base/parallel.h"
#include "engine/last_type.h"
#include "g2o/core/robust_kernel_impl.h"
#include "kernels/kernel_table.h"

namespace g2o {
namespace internal {

namespace dense = boxplus::dense;

namespace {

constexpr int kTileEdges = 32, kMostParts = 8;
/// The smallest number of edges for which threads save more time than they cost.
constexpr std::size_t kFewestEdges = 1000;

/// The Hessian index of a vertex, or −1 if the vertex is fixed or missing.
int index_of(const HyperGraph::Vertex* v) {
  return v == nullptr ? -1 : static_cast<const OptimizableGraph::Vertex*>(v)->hessianIndex();
}

std::uint32_t positions_in_hessian(const OptimizableGraph::Edge& edge) {
  std::uint32_t mask = 0;
  for (std::size_t n = 0; n < edge.vertices().size(); ++n)
    mask |= (index_of(edge.vertex(n)) >= 0 ? 1u : 0u) << n;
  return mask;
}

/// Whether ρ(chi2) = chi2 because the kernel is a Huber kernel and the error is small. Most edges of visual
/// SLAM are inliers of a Huber kernel, and need no virtual call.
bool is_inlier_of_huber(const RobustKernel& kernel, double chi2) {
  return &typeid(kernel) == &typeid(RobustKernelHuber) && kernel.delta() > 0 &&
         chi2 <= kernel.delta() * kernel.delta();
}

/// A kernel of the engine for the edges of a batch, and the vertices in its order.
struct Adder {
  std::vector<int> positions;  // of the vertices that are not fixed
  dense::AddEdges in_lanes = nullptr;
  dense::AddUnaryEdges unary = nullptr;

  static std::optional<Adder> find(const EdgeKind& kind, std::uint32_t mask) {
    Adder adder;
    for (int n = 0; n < static_cast<int>(kind.dims.size()); ++n) {
      if ((mask >> n & 1u) != 0) adder.positions.push_back(n);
    }
    if (adder.choose(kind)) return adder;
    std::reverse(adder.positions.begin(), adder.positions.end());
    if (adder.choose(kind)) return adder;
    return std::nullopt;
  }
  bool is_usable() const { return in_lanes != nullptr || unary != nullptr; }

 private:
  bool choose(const EdgeKind& kind) {
    std::vector<int> dims;
    for (const int n : positions) dims.push_back(kind.dims[static_cast<std::size_t>(n)]);
    if (dims.size() == 1) {
      unary = dense::kernels().add_unary_edges_for(kind.rows, dims[0]);
    } else if (dims.size() > 1) {
      in_lanes = dense::kernels().add_edges_for(kind.rows, dims.data(), static_cast<int>(dims.size()));
    }
    return is_usable();
  }
};

/// Runs task(0) … task(count − 1) on all threads.
void for_each_number(int count, boxplus::detail::FunctionRef<void(int)> task) {
  const int threads = count > 1 ? std::min(boxplus::detail::hardware_threads(), count) : 1;
  boxplus::detail::parallel_tasks(threads, [&](int thread) {
    for (int k = thread; k < count; k += threads) task(k);
  });
}

void set_to_zero(double* values, std::size_t count, int slices) {
  const std::size_t size = count / static_cast<std::size_t>(slices) + 1;
  for_each_number(slices, [&](int slice) {
    const std::size_t begin = std::min(count, static_cast<std::size_t>(slice) * size);
    std::fill(values + begin, values + std::min(count, begin + size), 0.0);
  });
}

}  // namespace

/// Edges of one kind with the same positions in H.
struct EdgeBatches::Batch {
  const EdgeKind* kind = nullptr;
  std::uint32_t mask = 0;
  Adder adder;
  Edges edges;
  std::vector<int> vertices;           // the Hessian indices of the vertices in H of each edge
  int columns = 0;                     // of the Jacobians of these vertices
  std::vector<std::uint32_t> targets;  // of each edge, as in EdgeLanes and UnaryEdges

  /// Whether edge k still has the vertices that it had when it was taken, and the same ones are fixed.
  bool is_current(std::size_t k) const {
    const Edge& edge = *edges[k];
    const int* index = vertices.data() + k * adder.positions.size();
    if (positions_in_hessian(edge) != mask) return false;
    for (const int n : adder.positions) {
      if (index_of(edge.vertex(static_cast<std::size_t>(n))) != *index++) return false;
    }
    return true;
  }
  std::size_t targets_per_edge() const {
    const std::size_t n = adder.positions.size();
    return n + n * (n + 1) / 2;
  }
};

/// The memory for the numbers of one tile of edges.
struct EdgeBatches::Tile {
  std::array<EdgeState, kTileEdges> state{};
  std::array<double, kTileEdges> chi2{}, weight{};
  std::array<const double*, kTileEdges> omegas{};
  std::array<const std::uint32_t*, kTileEdges> targets{};
  std::vector<double> jacobian, error, omega, unused, jacobian_lanes, error_lanes;
  std::array<double*, 8> jacobian_of{};
  std::array<int, 8> stride{};
  std::vector<std::uint32_t> nowhere;
  std::vector<std::vector<double>> outgrown;  // edges may keep pointers into this memory

  void grow(std::vector<double>& memory, int values) {
    if (memory.size() >= static_cast<std::size_t>(values)) return;
    std::vector<double> larger(static_cast<std::size_t>(values));
    memory.swap(larger);
    if (!larger.empty()) outgrown.push_back(std::move(larger));
  }
};

struct EdgeBatches::Part {
  explicit Part(Tile& memory) : tile(memory) {}

  std::vector<Batch> batches;
  Tile& tile;
  LastType kernel_type;

  /// The sum of the part for one block and its part of the gradient, behind H and behind the gradient.
  struct Sum {
    int vertex, dim;
    std::uint32_t from_value, from_scalar, to_value, to_scalar;
  };
  std::vector<Sum> sums;

  /// Gives the tile memory for edges of a batch. The edges keep pointers to their Jacobians in this memory.
  void make_room(const Batch& batch) {
    const int rows = batch.kind->rows;
    int largest = 0;
    for (const int dim : batch.kind->dims) largest = std::max(largest, rows * dim);
    tile.grow(tile.jacobian, kTileEdges * rows * batch.columns);
    tile.grow(tile.jacobian_lanes, kTileEdges * rows * batch.columns);
    tile.grow(tile.error, kTileEdges * rows);
    tile.grow(tile.error_lanes, kTileEdges * rows);
    tile.grow(tile.omega, kTileEdges * rows * (rows + 1) / 2);
    tile.grow(tile.unused, largest);
    tile.nowhere.resize(std::max(tile.nowhere.size(), batch.targets_per_edge()), dense::kNoTarget);
  }

  EdgeRun run(const Batch& batch, std::size_t begin) {
    const int left = static_cast<int>(batch.edges.size() - begin), count = std::min(left, kTileEdges);
    return {batch.edges.data() + begin,
            count,
            left - count,
            tile.state.data(),
            tile.chi2.data(),
            tile.jacobian_of.data(),
            tile.stride.data(),
            tile.error.data(),
            tile.omega.data()};
  }

  /// Adds ρ(chi2) of the edges of a run, and stores their weights ρ′. If the edges are linearized, they are
  /// those of `linearized` from `begin` on.
  void weigh(const EdgeRun& run, Pass& pass, const Batch* linearized = nullptr, std::size_t begin = 0) {
    for (int k = 0; k < run.count; ++k) {
      const auto at = static_cast<std::size_t>(k);
      tile.weight[at] = 1;
      if (run.state[k] == EdgeState::kIncomplete) {
        pass.any_incomplete = true;
        tile.targets[at] = tile.nowhere.data();
        continue;
      }
      Edge& edge = *run.edges[k];
      const RobustKernel* kernel = edge.robustKernel();
      const bool is_known = kernel == nullptr || kernel_type.allowed(typeid(*kernel));
      if (!is_known) {
        pass.with_unknown_kernels.push_back(&edge);
      } else if (kernel == nullptr) {
        pass.chi2 += run.chi2[k];
      } else if (is_inlier_of_huber(*kernel, run.chi2[k])) {
        pass.chi2 += run.chi2[k];
      } else {
        Vector3 rho;
        kernel->robustify(run.chi2[k], rho);
        pass.chi2 += rho[0];
        tile.weight[at] = std::max(0.0, rho[1]);
      }
      if (linearized == nullptr) continue;
      if (!is_known || run.state[k] == EdgeState::kAsymmetric || !linearized->is_current(begin + at)) {
        pass.not_added.push_back(&edge);
        tile.targets[at] = tile.nowhere.data();
      }
    }
  }

  void compute_errors(Pass& pass) {
    for (const Batch& batch : batches) {
      for (std::size_t begin = 0; begin < batch.edges.size(); begin += kTileEdges) {
        const EdgeRun tile_run = run(batch, begin);
        batch.kind->compute_errors(tile_run);
        weigh(tile_run, pass);
      }
    }
  }

  void linearize(double* values, double* gradient, bool with_errors, Pass& pass) {
    for (const Batch& batch : batches) {
      place_jacobians(batch);
      const std::size_t size = batch.targets_per_edge();
      for (std::size_t begin = 0; begin < batch.edges.size(); begin += kTileEdges) {
        const EdgeRun tile_run = run(batch, begin);
        for (std::size_t k = 0; k < static_cast<std::size_t>(tile_run.count); ++k)
          tile.targets[k] = batch.targets.data() + (begin + k) * size;
        batch.kind->linearize(tile_run, with_errors);
        weigh(tile_run, pass, &batch, begin);
        add(batch, tile_run.count, values, gradient);
      }
    }
  }

 private:
  /// Orders the Jacobians as the kernel expects them. The Jacobians of fixed vertices are not used.
  void place_jacobians(const Batch& batch) {
    const int rows = batch.kind->rows;
    tile.jacobian_of.fill(tile.unused.data());
    tile.stride.fill(0);
    int column = 0;
    for (const int n : batch.adder.positions) {
      tile.jacobian_of[static_cast<std::size_t>(n)] = tile.jacobian.data() + column * rows;
      tile.stride[static_cast<std::size_t>(n)] = batch.columns * rows;
      column += batch.kind->dims[static_cast<std::size_t>(n)];
    }
    for (int k = 0; k < kTileEdges; ++k)
      tile.omegas[static_cast<std::size_t>(k)] = tile.omega.data() + k * rows * (rows + 1) / 2;
  }

  void add(const Batch& batch, int count, double* values, double* gradient) {
    constexpr auto kFull = dense::EdgeNumbers::kFull;
    const int rows = batch.kind->rows;
    if (batch.adder.unary != nullptr) {
      batch.adder.unary({count, tile.jacobian.data(), tile.error.data(), kFull, tile.omegas.data(),
                         tile.weight.data(), tile.targets.data(), values, gradient});
      return;
    }
    const dense::KernelTable& kernels = dense::kernels();
    kernels.to_lanes(tile.jacobian.data(), rows * batch.columns, count, tile.jacobian_lanes.data());
    kernels.to_lanes(tile.error.data(), rows, count, tile.error_lanes.data());
    batch.adder.in_lanes({count, tile.jacobian_lanes.data(), tile.error_lanes.data(), kFull,
                          tile.omegas.data(), tile.weight.data(), tile.targets.data(), values, gradient});
  }
};

/// The edges that take() has found, before they are divided into parts.
struct EdgeBatches::Taken {
  struct Item {
    Edge* edge;
    std::uint32_t batch, begin;  // its Hessian indices begin here in `indices`
  };
  std::vector<Batch> batches;  // without edges
  std::vector<Item> items;
  std::vector<int> indices;
  std::vector<char> is_marginalized;  // by Hessian index

  const int* begin(const Item& item) const { return indices.data() + item.begin; }
  const int* end(const Item& item) const { return begin(item) + batches[item.batch].adder.positions.size(); }

  /// Returns the batch of an edge, or none if edges like this are not taken.
  std::optional<std::uint32_t> batch_of(const Edge& edge, const EdgeKind& kind) {
    const std::uint32_t mask = positions_in_hessian(edge);
    for (std::uint32_t k = 0; k < batches.size(); ++k) {
      const Batch& batch = batches[k];
      if (batch.kind == &kind && batch.mask == mask) return k;
    }
    std::optional<Adder> adder = Adder::find(kind, mask);
    if (!adder) return std::nullopt;
    Batch batch;
    batch.kind = &kind;
    batch.mask = mask;
    batch.adder = std::move(*adder);
    for (const int n : batch.adder.positions) batch.columns += kind.dims[static_cast<std::size_t>(n)];
    batches.push_back(std::move(batch));
    return static_cast<std::uint32_t>(batches.size() - 1);
  }

  bool take(Edge& edge, const EdgeKind& kind) {
    if (edge.vertices().size() != kind.dims.size()) return false;
    for (const HyperGraph::Vertex* v : edge.vertices()) {
      if (index_of(v) >= static_cast<int>(is_marginalized.size())) return false;  // the client changed it
    }
    const std::optional<std::uint32_t> batch = batch_of(edge, kind);
    if (!batch) return false;
    items.push_back({&edge, *batch, static_cast<std::uint32_t>(indices.size())});
    for (const int n : batches[*batch].adder.positions) {
      const auto* v = static_cast<const OptimizableGraph::Vertex*>(edge.vertex(static_cast<std::size_t>(n)));
      is_marginalized[static_cast<std::size_t>(v->hessianIndex())] = v->marginalized() ? 1 : 0;
      indices.push_back(v->hessianIndex());
    }
    return true;
  }
};

/// Divides edges into parts. Vertices are numbered in the order in which edges first use them, and each part
/// owns the vertices of a range of numbers. The ranges have similar numbers of edges.
class EdgeBatches::Divider {
 public:
  explicit Divider(const Taken& taken) : taken_(taken), number_(taken.is_marginalized.size(), -1) {
    int seen = 0;
    for (const int h : taken.indices) {
      if (number(h) < 0) number_[static_cast<std::size_t>(h)] = seen++;
    }
    std::vector<std::int64_t> owned(static_cast<std::size_t>(seen));
    for (const Taken::Item& item : taken.items) ++owned[static_cast<std::size_t>(number(owner(item)))];
    const auto count = static_cast<std::int64_t>(taken.items.size());
    std::int64_t before = 0;
    for (const std::int64_t here : owned) {
      part_.push_back(static_cast<int>(std::min<std::int64_t>(kMostParts - 1, before * kMostParts / count)));
      before += here;
    }
  }
  int part_of_vertex(int h) const { return part_[static_cast<std::size_t>(number(h))]; }
  int part_of(const Taken::Item& item) const { return part_of_vertex(owner(item)); }

 private:
  int number(int h) const { return number_[static_cast<std::size_t>(h)]; }
  int owner(const Taken::Item& item) const {
    const auto is_before = [&](int a, int b) {
      const char marginalized_a = taken_.is_marginalized[static_cast<std::size_t>(a)];
      const char marginalized_b = taken_.is_marginalized[static_cast<std::size_t>(b)];
      return marginalized_a != marginalized_b ? marginalized_a < marginalized_b : number(a) < number(b);
    };
    return *std::max_element(taken_.begin(item), taken_.end(item), is_before);
  }

  const Taken& taken_;
  std::vector<int> number_;  // of each vertex, by Hessian index
  std::vector<int> part_;    // of each vertex, by number
};

EdgeBatches::EdgeBatches() = default;
EdgeBatches::~EdgeBatches() = default;

void EdgeBatches::take(const Edges& edges, int vertices, Edges& others) {
  stamp_ = 0;
  extra_values_ = extra_scalars_ = 0;
  parts_.clear();
  Taken taken;
  taken.is_marginalized.resize(static_cast<std::size_t>(vertices));
  const std::type_info* type = nullptr;
  const EdgeKind* kind = nullptr;
  for_each_ahead(edges, [&](Edge& edge) {
    if (&typeid(edge) != type) {
      type = &typeid(edge);
      kind = edge_kind(*type);
    }
    if (kind == nullptr || !taken.take(edge, *kind)) others.push_back(&edge);
  });
  if (taken.items.empty()) return;
  std::optional<Divider> divider;
  if (taken.items.size() >= kFewestEdges) divider.emplace(taken);
  for (int p = 0; p < (divider ? kMostParts : 1); ++p) {
    if (static_cast<std::size_t>(p) == tiles_.size()) tiles_.push_back(std::make_unique<Tile>());
    parts_.push_back(std::make_unique<Part>(*tiles_[static_cast<std::size_t>(p)]));
    parts_.back()->batches = taken.batches;
  }
  for (const Taken::Item& item : taken.items) {
    Part& part = *parts_[divider ? static_cast<std::size_t>(divider->part_of(item)) : 0];
    Batch& batch = part.batches[item.batch];
    batch.edges.push_back(item.edge);
    batch.vertices.insert(batch.vertices.end(), taken.begin(item), taken.end(item));
  }
  for (const std::unique_ptr<Part>& part : parts_) {
    for (const Batch& batch : part->batches) part->make_room(batch);
  }
  if (divider) make_sums(*divider, vertices);
}

/// Gives each part a sum for each vertex of its edges that belongs to another part.
void EdgeBatches::make_sums(const Divider& divider, int vertices) {
  std::vector<int> last_part(static_cast<std::size_t>(vertices), -1);
  for (int p = 0; p < static_cast<int>(parts_.size()); ++p) {
    Part& part = *parts_[static_cast<std::size_t>(p)];
    for (const Batch& batch : part.batches) {
      const std::size_t arity = batch.adder.positions.size();
      for (std::size_t k = 0; k < batch.vertices.size(); ++k) {
        const int h = batch.vertices[k];
        if (std::exchange(last_part[static_cast<std::size_t>(h)], p) == p || divider.part_of_vertex(h) == p)
          continue;
        const int dim = batch.kind->dims[static_cast<std::size_t>(batch.adder.positions[k % arity])];
        part.sums.push_back({h, dim, extra_values_, extra_scalars_, 0, 0});
        extra_values_ += static_cast<std::uint32_t>(dim * dim);
        extra_scalars_ += static_cast<std::uint32_t>(dim);
      }
    }
  }
}

void EdgeBatches::for_each(boxplus::detail::FunctionRef<void(Edge&)> f) const {
  for (const std::unique_ptr<Part>& part : parts_) {
    for (const Batch& batch : part->batches) {
      for (Edge* edge : batch.edges) f(*edge);
    }
  }
}

bool EdgeBatches::lay_out(const HessianPlaces& places, std::uint64_t stamp) {
  stamp_ = 0;
  values_ = places.values();
  scalars_ = places.scalars();
  if (std::uint64_t{values_} + extra_values_ >= dense::kTransposedTarget) return false;
  std::vector<const Part::Sum*> sum_of;
  for (std::unique_ptr<Part>& part : parts_) {
    sum_of.clear();
    for (Part::Sum& sum : part->sums) {
      sum.to_value = places.block(sum.vertex, sum.vertex).offset;
      sum.to_scalar = places.gradient(sum.vertex);
      sum_of.resize(std::max(sum_of.size(), static_cast<std::size_t>(sum.vertex) + 1), nullptr);
      sum_of[static_cast<std::size_t>(sum.vertex)] = &sum;
    }
    const auto find_sum = [&](int h) {
      return static_cast<std::size_t>(h) < sum_of.size() ? sum_of[static_cast<std::size_t>(h)] : nullptr;
    };
    for (Batch& batch : part->batches) {
      for (std::size_t k = 0; k < batch.edges.size(); ++k) {
        if (!batch.is_current(k)) return false;
      }
      batch.targets.clear();
      batch.targets.reserve(batch.edges.size() * batch.targets_per_edge());
      const std::size_t arity = batch.adder.positions.size();
      for (std::size_t first = 0; first < batch.vertices.size(); first += arity) {
        const auto at = [&](std::size_t i) { return batch.vertices[first + i]; };
        for (std::size_t i = 0; i < arity; ++i) {
          const Part::Sum* sum = find_sum(at(i));
          batch.targets.push_back(sum != nullptr ? scalars_ + sum->from_scalar : places.gradient(at(i)));
        }
        for (std::size_t i = 0; i < arity; ++i) {
          for (std::size_t j = 0; j <= i; ++j) {
            const Part::Sum* sum = i == j ? find_sum(at(i)) : nullptr;
            const HessianPlaces::Block block = places.block(at(i), at(j));
            batch.targets.push_back(sum != nullptr
                                        ? values_ + sum->from_value
                                        : block.offset | (block.transposed ? dense::kTransposedTarget : 0));
          }
        }
      }
    }
  }
  stamp_ = stamp;
  return true;
}

/// Runs the task of each part on all threads, and adds up the results in the order of the parts.
EdgeBatches::Pass EdgeBatches::for_each_part(boxplus::detail::FunctionRef<void(Part&, Pass&)> task) {
  if (parts_.size() == 1) {
    Pass pass;
    task(*parts_[0], pass);
    return pass;
  }
  std::array<Pass, kMostParts> passes;
  for_each_number(static_cast<int>(parts_.size()), [&](int p) {
    task(*parts_[static_cast<std::size_t>(p)], passes[static_cast<std::size_t>(p)]);
  });
  Pass total;
  for (const Pass& pass : passes) {
    total.chi2 += pass.chi2;
    total.any_incomplete = total.any_incomplete || pass.any_incomplete;
    const auto append = [](Edges& to, const Edges& from) { to.insert(to.end(), from.begin(), from.end()); };
    append(total.with_unknown_kernels, pass.with_unknown_kernels);
    append(total.not_added, pass.not_added);
  }
  return total;
}

EdgeBatches::Pass EdgeBatches::compute_errors() {
  return for_each_part([](Part& part, Pass& pass) { part.compute_errors(pass); });
}

void EdgeBatches::clear(double* values, double* gradient) const {
  set_to_zero(values, values_ + extra_values_, static_cast<int>(parts_.size()));
  std::fill_n(gradient, scalars_ + extra_scalars_, 0.0);
}

EdgeBatches::Pass EdgeBatches::linearize(double* values, double* gradient, bool with_errors) {
  Pass pass =
      for_each_part([&](Part& part, Pass& found) { part.linearize(values, gradient, with_errors, found); });
  add_sums(values, gradient);
  return pass;
}

void EdgeBatches::add_sums(double* values, double* gradient) const {
  for (const std::unique_ptr<Part>& part : parts_) {
    for (const Part::Sum& sum : part->sums) {
      for (int k = 0; k < sum.dim * sum.dim; ++k)
        values[sum.to_value + static_cast<std::uint32_t>(k)] +=
            values[values_ + sum.from_value + static_cast<std::uint32_t>(k)];
      for (int k = 0; k < sum.dim; ++k)
        gradient[sum.to_scalar + static_cast<std::uint32_t>(k)] +=
            gradient[scalars_ + sum.from_scalar + static_cast<std::uint32_t>(k)];
    }
  }
}

}  // namespace internal
}  // namespace g2o
