// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/constraints.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "boxplus/base/error.h"
#include "optimize/non_finite.h"

namespace boxplus {

Constraints::Constraints(Graph& graph, const Plan& plan) : graph_(graph) {
  for (const EdgeList& list : plan.edges) {
    detail::EdgePool& pool = *graph.edge_pools()[list.pool];
    if (list.edges.empty() || pool.shift(list.edges.front()) == nullptr) continue;
    for (const std::uint32_t slot : list.edges) {
      if (!pool.enabled(slot)) continue;
      const EdgeRef edge{list.pool, slot, pool.generation(slot)};
      if (pool.kernel(slot) != nullptr)
        throw InvalidArgument("optimize: expected constraints without robust kernels, but " +
                              edge_text(graph, edge) + " has one");
      items_.push_back({edge, pool.shift(slot), graph.information(edge).matrix()});
    }
  }
}

Constraints::~Constraints() {
  set_weight(1);
  for (const Item& item : items_) item.shift->clear();
}

void Constraints::begin(double chi2) {
  constexpr double kBalance = 10, kLeast = 1, kMost = 1e6, kTolerance = 1e-9;
  double penalty = 0;
  for (const Item& item : items_) penalty += graph_.chi2(item.edge);
  measure();
  tolerance_ = kTolerance * std::max(1.0, violation_);
  const double balanced = kBalance * (chi2 - penalty) / penalty;
  set_weight(std::isfinite(balanced) ? std::clamp(balanced, kLeast, kMost) : kBalance);
}

/// Sets the violation, and the multipliers for which the last run was at a minimum.
void Constraints::measure() {
  violation_ = 0;
  for (Item& item : items_) {
    const std::vector<double> values = graph_.error(item.edge);
    const auto shifted = Eigen::VectorXd::Map(values.data(), std::ssize(values));
    item.multipliers = 2 * weight_ * item.information * shifted;
    for (std::size_t i = 0; i < values.size(); ++i) {
      const double error = std::abs(item.shift->empty() ? values[i] : values[i] - (*item.shift)[i]);
      if (!(error <= violation_)) violation_ = error;  // also if it is NaN
    }
  }
}

void Constraints::set_weight(double weight) {
  weight_ = weight;
  for (const Item& item : items_) graph_.set_information(item.edge, Information(weight * item.information));
}

bool Constraints::improve() {
  constexpr int kMostRounds = 60, kMostInVain = 6;
  constexpr double kFast = 0.1, kGrowth = 10, kLargestWeight = 1e12, kExact = 1e-4;
  ++rounds_;
  measure();
  if (violation_ <= kExact * tolerance_ || !std::isfinite(violation_) || rounds_ == kMostRounds) return false;
  in_vain_ = violation_ < best_ / 2 ? 0 : in_vain_ + 1;
  if (in_vain_ == (hold() ? 1 : kMostInVain)) return false;
  const bool grows = !(violation_ <= kFast * best_) && weight_ < kLargestWeight;
  best_ = std::min(best_, violation_);
  const double growth = grows ? kGrowth : 1;
  for (const Item& item : items_) {
    *item.shift = graph_.error(item.edge);
    for (double& shift : *item.shift) shift /= growth;
  }
  if (grows) set_weight(weight_ * growth);
  return true;
}

void Constraints::report(Report& report) const {
  report.constraint_violation = violation_;
  report.constraint_rounds = rounds_;
  report.constraints.clear();
  for (const Item& item : items_)
    report.constraints.push_back({item.edge, {item.multipliers.begin(), item.multipliers.end()}});
}

}  // namespace boxplus
