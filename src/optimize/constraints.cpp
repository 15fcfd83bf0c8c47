// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/constraints.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/vector_math.h"
#include "boxplus/base/error.h"
#include "linearize/non_finite.h"

namespace boxplus {
namespace {

/// The largest error with which a constraint holds, unless its rounding errors are larger.
constexpr double kTolerance = 1e-9;

/// The magnitude of what a direction of the tangent changes: of a number, of a position, or 1.
double magnitude(detail::VertexPool& pool, std::uint32_t slot, int direction) {
  if (const double* entry = pool.entry(slot, direction)) return std::abs(*entry);
  detail::Frame frame;
  return std::max(1.0, pool.get_frame(slot, frame) ? max_abs(frame.translation) : 1.0);
}

}  // namespace

bool Constraints::exist_in(const Graph& graph) {
  return std::ranges::any_of(graph.all_edges(), [&](const EdgeRef& edge) {
    return graph.edge_pools()[edge.pool]->shift(edge.slot) != nullptr;
  });
}

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
  constexpr double kBalance = 10, kLeast = 1, kMost = 1e6;
  double penalty = 0;
  for (const Item& item : items_) penalty += graph_.chi2(item.edge);
  measure();
  const double balanced = kBalance * (chi2 - penalty) / penalty;
  set_weight(std::isfinite(balanced) ? std::clamp(balanced, kLeast, kMost) : kBalance);
}

/// The error with which each row of a constraint holds. The rounding of the estimates alone changes an error
/// e(x) by up to ε Σ |∂e/∂x| |x|.
Eigen::VectorXd Constraints::tolerances(const EdgeRef& edge) const {
  constexpr double kRoundings = 4 * std::numeric_limits<double>::epsilon();
  const std::vector<Eigen::MatrixXd> jacobians = graph_.jacobian(edge);
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(jacobians.front().rows());
  std::size_t k = 0;
  for (const VertexRef& vertex : graph_.vertices(edge)) {
    detail::VertexPool& pool = *graph_.vertex_pools()[vertex.pool];
    const Eigen::MatrixXd& J = jacobians[k++];
    for (int i = 0; i < J.cols(); ++i) sum += J.col(i).cwiseAbs() * magnitude(pool, vertex.slot, i);
  }
  return (kRoundings * sum).cwiseMax(kTolerance);
}

/// Sets the violation, and the multipliers for which the last run was at a minimum.
void Constraints::measure() {
  violation_ = excess_ = 0;
  const auto raise = [](double& largest, double value) {
    if (!(value <= largest)) largest = value;  // also if it is NaN
  };
  for (Item& item : items_) {
    const std::vector<double> values = graph_.error(item.edge);
    const auto shifted = Eigen::VectorXd::Map(values.data(), std::ssize(values));
    item.multipliers = 2 * weight_ * item.information * shifted;
    Eigen::VectorXd errors = shifted;
    if (!item.shift->empty()) errors -= Eigen::VectorXd::Map(item.shift->data(), std::ssize(values));
    const double largest = values.empty() ? 0 : errors.cwiseAbs().maxCoeff<Eigen::PropagateNaN>();
    raise(violation_, largest);
    const bool needs_jacobian = largest > kTolerance && std::isfinite(largest);
    if (needs_jacobian) errors = errors.cwiseQuotient(tolerances(item.edge));
    raise(excess_, needs_jacobian ? errors.cwiseAbs().maxCoeff() : largest / kTolerance);
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
  if (excess_ <= kExact || !std::isfinite(violation_) || rounds_ == kMostRounds) return false;
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
