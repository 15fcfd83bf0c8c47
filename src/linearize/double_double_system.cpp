// SPDX-License-Identifier: BSD-3-Clause
#include "linearize/double_double_system.h"

#include "linearize/accumulate.h"
#include "linearize/edge_rows.h"
#include "plan/fixed_directions.h"

namespace boxplus {
namespace {

/// Adds edges to H and to the gradient.
class Adder {
 public:
  Adder(const Graph& graph, const Plan& plan, const LinearizeOptions& options, DoubleDoubleSystem& system)
      : plan_(plan), options_(options), system_(system), rows_(graph, plan) {}

  void add(const detail::EdgePool& pool, std::uint32_t edge) {
    rows_.linearize(pool, edge, options_.numeric_jacobians);
    const detail::InformationView omega = pool.information(edge, rows_.rows());
    const double e2 = omega.squared_norm(rows_.error());
    const EdgeWeight weight = edge_weight(pool.kernel(edge), e2, options_.triggs_correction);
    weigh(omega);
    for (std::size_t a = 0; a < rows_.columns().size(); ++a) {
      if (rows_.columns()[a].block != BlockStructure::kAbsent) add_column(a, weight);
    }
  }

 private:
  using Column = EdgeRows::Column;

  /// Sums jacobian column a · x.
  DoubleDouble product(std::size_t a, const DoubleDouble* x) const {
    const double* column = rows_.column(a);
    DoubleDouble sum;
    for (std::size_t r = 0; r < count(); ++r) sum += x[r] * column[r];
    return sum;
  }

  /// Computes ΩJ, Ωe and JᵀΩe.
  void weigh(const detail::InformationView& omega) {
    const std::size_t n = count(), columns = rows_.columns().size();
    weighted_.assign(n * (columns + 1), 0.0);
    for (std::size_t c = 0; c <= columns; ++c) {
      const double* x = c < columns ? rows_.column(c) : rows_.error();
      for (std::size_t i = 0; i < n; ++i) {
        DoubleDouble& sum = weighted_[c * n + i];
        for (std::size_t j = 0; j < n; ++j) {
          const double entry = omega(static_cast<int>(i), static_cast<int>(j));
          if (entry != 0) sum += DoubleDouble::product(entry, x[j]);
        }
      }
    }
    gradient_.resize(columns);
    for (std::size_t c = 0; c < columns; ++c) gradient_[c] = product(c, &weighted_[columns * n]);
  }

  /// Adds to the gradient entry of column a, and to the entries of H in its row.
  void add_column(std::size_t a, const EdgeWeight& weight) {
    const Column& row = rows_.columns()[a];
    const BlockStructure& structure = plan_.structure;
    system_.gradient[structure.offset[row.block] + row.direction] += gradient_[a] * weight.first;
    for (std::size_t b = 0; b < rows_.columns().size(); ++b) {
      const Column& column = rows_.columns()[b];
      if (column.block == BlockStructure::kAbsent || column.block > row.block) continue;
      DoubleDouble entry = product(a, &weighted_[b * count()]) * weight.first;
      if (weight.second != 0) entry += gradient_[a] * gradient_[b] * weight.second;
      const std::uint32_t first = structure.value_start[structure.find(row.block, column.block)];
      system_.values[first + column.direction * structure.dim(row.block) + row.direction] += entry;
    }
  }

  std::size_t count() const { return static_cast<std::size_t>(rows_.rows()); }

  const Plan& plan_;
  const LinearizeOptions& options_;
  DoubleDoubleSystem& system_;
  EdgeRows rows_;
  std::vector<DoubleDouble> weighted_, gradient_;
};

/// As leave_out_fixed() (fixed_directions.h).
void leave_out(const Chunk::FixedScalars& fixed, DoubleDoubleSystem& system) {
  for (const std::uint32_t scalar : fixed.scalars) system.gradient[scalar] = 0;
  for (const std::uint32_t value : fixed.values) system.values[value] = 0;
  for (const std::uint32_t diagonal : fixed.diagonals) {
    if (!(system.values[diagonal].high > 0)) system.values[diagonal] = 1;
  }
}

}  // namespace

void linearize_in_double_double(const Graph& graph, const Plan& plan, const LinearizeOptions& options,
                                const StopToken& stop, DoubleDoubleSystem& system) {
  system.values.assign(plan.structure.nonzero_values(), 0.0);
  system.gradient.assign(plan.scalars(), 0.0);
  Adder adder(graph, plan, options, system);
  for (const EdgeList& list : plan.edges) {
    const detail::EdgePool& pool = *graph.edge_pools()[list.pool];
    for (std::size_t k = 0; k < list.edges.size(); ++k) {
      if (k % 64 == 0) stop.check();
      if (pool.enabled(list.edges[k])) adder.add(pool, list.edges[k]);
    }
  }
  leave_out(all_fixed_scalars(graph, plan), system);
}

}  // namespace boxplus
