// SPDX-License-Identifier: BSD-3-Clause
#include "linearize/stiff_edge.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "linearize/edge_rows.h"

namespace boxplus {
namespace {

/// The smallest and the largest positive value of a list.
struct Span {
  double least = std::numeric_limits<double>::infinity(), most = 0;
  void add(double value) {
    if (!(value > 0)) return;
    least = std::min(least, value);
    most = std::max(most, value);
  }
  void add_least_of(const Span& other) { least = std::min(least, other.least); }
  bool exceeds(double ratio) const { return most >= ratio * least; }
};

/// Calls f(pool, edge) for each enabled edge. Returns false if the token was raised.
template <class F>
bool for_each_enabled_edge(const Graph& graph, const Plan& plan, const StopToken& stop, F&& f) {
  constexpr std::size_t kEdgesBetweenStops = 64;
  for (const EdgeList& list : plan.edges) {
    const detail::EdgePool& pool = *graph.edge_pools()[list.pool];
    for (std::size_t k = 0; k < list.edges.size(); ++k) {
      if (k % kEdgesBetweenStops == 0 && stop.raised()) return false;
      const std::uint32_t edge = list.edges[k];
      if (pool.enabled(edge)) f(pool, EdgeRef{list.pool, edge, pool.generation(edge)});
    }
  }
  return true;
}

/// The weights of the rows of an edge at a moving vertex.
struct WeightsAtBlock {
  std::uint32_t block;
  Span span;
};

class RowWeights {
 public:
  RowWeights(const Graph& graph, const Plan& plan, const LinearizeOptions& options)
      : options_(options), rows_(graph, plan) {}

  std::span<const WeightsAtBlock> of(const detail::EdgePool& pool, std::uint32_t edge) {
    rows_.linearize(pool, edge, options_.numeric_jacobians);
    const auto n = static_cast<std::size_t>(rows_.rows());
    find_root(pool.information(edge, rows_.rows()), n);
    weights_.clear();
    weighted_rows_ = 0;
    for (std::size_t row = 0; row < n; ++row) {
      add_row(row, n);
      weighted_rows_ += root_[row * n + row] > 0;
    }
    return weights_;
  }

  /// Whether the last edge only fixes a vertex, in all directions.
  bool is_anchor(double ratio) const {
    const auto unknowns =
        std::count_if(rows_.columns().begin(), rows_.columns().end(),
                      [](const EdgeRows::Column& column) { return column.block != BlockStructure::kAbsent; });
    return weights_.size() == 1 && !weights_[0].span.exceeds(ratio) && weighted_rows_ >= unknowns;
  }

  /// The largest entry of Ω off the diagonal, as a fraction of the largest one on the diagonal.
  double share_off_diagonal() const { return diagonal_ > 0 ? off_diagonal_ / diagonal_ : 0; }

 private:
  /// Computes the upper triangle √Ω with √Ωᵀ√Ω = Ω. Rows that are only rounding errors are zero.
  void find_root(const detail::InformationView& omega, std::size_t n) {
    constexpr double kRounding = 1e-13;
    root_.assign(n * n, 0.0);
    diagonal_ = off_diagonal_ = 0;
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = i; j < n; ++j) {
        const double entry = omega(static_cast<int>(i), static_cast<int>(j));
        double& largest = i == j ? diagonal_ : off_diagonal_;
        largest = std::max(largest, std::abs(entry));
        double rest = entry;
        for (std::size_t k = 0; k < i; ++k) rest -= root_[k * n + i] * root_[k * n + j];
        if (i == j) {
          root_[i * n + i] = rest > kRounding * entry ? std::sqrt(rest) : 0;
        } else if (root_[i * n + i] > 0) {
          root_[i * n + j] = rest / root_[i * n + i];
        }
      }
    }
  }

  /// Adds the weights of a row of √Ω J. Leaves out weights that are rounding errors of the Jacobian.
  void add_row(std::size_t row, std::size_t n) {
    constexpr double kRounding = 1e-24;
    products_.clear();
    double terms = 0;
    for (std::size_t c = 0; c < rows_.columns().size(); ++c) {
      double product = 0, magnitude = 0;
      for (std::size_t k = row; k < n; ++k) {
        product += root_[row * n + k] * rows_.column(c)[k];
        magnitude += std::abs(root_[row * n + k] * rows_.column(c)[k]);
      }
      products_.push_back(product);
      terms += magnitude * magnitude;
    }
    for (std::size_t c = 0; c < products_.size();) {
      const std::uint32_t block = rows_.columns()[c].block;
      double weight = 0;
      do weight += products_[c] * products_[c];
      while (++c < products_.size() && rows_.columns()[c].direction > 0);
      if (block == BlockStructure::kAbsent) continue;
      const auto at = std::find_if(weights_.begin(), weights_.end(),
                                   [&](const WeightsAtBlock& w) { return w.block == block; });
      Span& span = at == weights_.end() ? weights_.emplace_back(WeightsAtBlock{block, {}}).span : at->span;
      if (weight > kRounding * terms) span.add(weight);
    }
  }

  const LinearizeOptions& options_;
  EdgeRows rows_;
  std::vector<double> root_, products_;
  std::ptrdiff_t weighted_rows_ = 0;        // the rows of √Ω that are not zero
  double diagonal_ = 0, off_diagonal_ = 0;  // the largest magnitudes in Ω
  std::vector<WeightsAtBlock> weights_;
};

/// Finds the edge with the largest weight at a vertex among those for which bound(edge, weights at the
/// vertex) is at least the smallest weight of all rows at the vertex.
template <class Bound>
std::optional<StiffEdge> find_heaviest(const Graph& graph, const Plan& plan, const LinearizeOptions& options,
                                       const StopToken& stop, Bound&& bound) {
  RowWeights weights(graph, plan, options);
  std::vector<Span> spans(plan.structure.blocks());
  const auto add = [&](const detail::EdgePool& pool, EdgeRef edge) {
    for (const WeightsAtBlock& at : weights.of(pool, edge.slot)) spans[at.block].add_least_of(at.span);
  };
  if (!for_each_enabled_edge(graph, plan, stop, add)) return std::nullopt;
  std::optional<StiffEdge> found;
  double heaviest = 0;
  const auto compare = [&](const detail::EdgePool& pool, EdgeRef edge) {
    for (const WeightsAtBlock& at : weights.of(pool, edge.slot)) {
      if (at.span.most <= heaviest || bound(weights, at.span) < spans[at.block].least) continue;
      heaviest = at.span.most;
      found = StiffEdge{edge, plan.block_vertex[at.block]};
    }
  };
  return for_each_enabled_edge(graph, plan, stop, compare) ? found : std::nullopt;
}

}  // namespace

std::optional<StiffEdge> find_stiff_edge(const Graph& graph, const Plan& plan,
                                         const LinearizeOptions& options, double ratio,
                                         const StopToken& stop) {
  return find_heaviest(graph, plan, options, stop, [&](const RowWeights& weights, const Span& at) {
    return weights.is_anchor(ratio) ? 0 : at.most / ratio;
  });
}

std::optional<StiffEdge> find_rounded_edge(const Graph& graph, const Plan& plan,
                                           const LinearizeOptions& options, const StopToken& stop) {
  constexpr double kDigits = 1e13;
  return find_heaviest(graph, plan, options, stop, [&](const RowWeights& weights, const Span& at) {
    return weights.share_off_diagonal() * at.most / kDigits;
  });
}

bool information_is_stiff(const Graph& graph, const Plan& plan) {
  Span all;  // without the largest values of edges that only fix a vertex
  for_each_enabled_edge(graph, plan, {}, [&](const detail::EdgePool& pool, EdgeRef edge) {
    const detail::EdgeShape shape = pool.shape(edge.slot);
    const detail::InformationView omega = pool.information(edge.slot, shape.rows);
    Span own;
    int weighted_rows = 0;
    for (int i = 0; i < shape.rows; ++i) {
      own.add(omega(i, i));
      weighted_rows += omega(i, i) > 0;
    }
    const bool is_anchor = shape.arity == 1 && weighted_rows >= shape.cols && !own.exceeds(kStiffRatio);
    all.add_least_of(own);
    if (!is_anchor) all.most = std::max(all.most, own.most);
  });
  return all.exceeds(kStiffRatio);
}

}  // namespace boxplus
