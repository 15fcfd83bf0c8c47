// SPDX-License-Identifier: BSD-3-Clause
#include "system/model.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/stopwatch.h"
#include "base/vector_math.h"
#include "system/forcing_term.h"

namespace boxplus {
namespace {

/// Entries that bounds hold get this multiple of their diagonal entries of H.
constexpr double kOfBounds = 1e8;

}  // namespace

Model::Model(Graph& observed, Plan made, GaugePolicy policy)
    : graph(observed),
      plan(std::move(made)),
      linearizer(graph, plan),
      assembled(plan.structure, linearizer.values()),
      gauge(graph, plan, policy) {
  for (auto* vector : {&gradient, &right_hand_side}) vector->resize(plan.scalars());
  diagonal.resize(plan.scalars());
  if (stores_all_columns() || !plan.fixed_scalars.empty()) product_.resize(plan.scalars());
}

void Model::begin_run(const Options& of_run, detail::Timings& timings_of_run) {
  options = {of_run.numeric_jacobians, of_run.triggs_correction};
  control = {.relative_tolerance = forcing_term(of_run, plan)};
  timings = &timings_of_run;
  diagonal.begin_run();
  move_within_bounds(graph, of_run.vertices);
  bounds.read(graph, plan);
  gauge.begin_run(!bounds.empty());
}

void Model::set_stop(const StopToken& stop) {
  control.stop = stop;
  linearizer.set_stop(stop);
}

void Model::collect(std::uint32_t first, std::uint32_t last, const double* values) {
  const double* from = linearizer.gradient().data();
  for (std::uint32_t block = first; block < last; ++block) {
    const std::uint32_t dim = plan.structure.dim(block), offset = plan.structure.offset[block];
    for (std::uint32_t i = 0; i < dim; ++i) {
      diagonal.set(offset + i, values[i * (dim + 1)]);
      gradient[offset + i] = from[offset + i];
      right_hand_side[offset + i] = -from[offset + i];
    }
    values += plan.first_value(block + 1) - plan.first_value(block);
  }
}

void Model::collect_kept() {
  const auto kept = linearizer.values().last(plan.shared_values());
  collect(plan.eliminated_blocks, plan.structure.blocks(), kept.data());
  if (add_other_processes) add_other_processes();
}

SolveControl Model::control_with_right_hand_side() const {
  SolveControl result = control;
  result.right_hand_side = right_hand_side.data();
  return result;
}

double Model::curvature(std::span<const double> d) {
  if (!is_complete) return std::numeric_limits<double>::quiet_NaN();
  const ScopedTimer adder(timings->solve_s);
  if (stores_all_columns()) {
    assembled.multiply(d.data(), product_.data());
    return dot(d, product_);
  }
  if (plan.fixed_scalars.empty()) return linearizer.curvature(options, d.data());
  std::copy(d.begin(), d.end(), product_.begin());
  double along_fixed = 0;  // H has only a diagonal there
  for (const std::uint32_t i : plan.fixed_scalars) {
    along_fixed += diagonal_of_hessian()[i] * d[i] * d[i];
    product_[i] = 0;
  }
  return along_fixed + linearizer.curvature(options, product_.data());
}

bool Model::is_uniform(const StepDamping& damping) const {
  return StepDiagonal::is_uniform(damping) && gauge.fraction() == 0 && !bounds.holds_any() &&
         !gauge.holds_any(damping.lambda);
}

void Model::hold_scalars(const StepDamping& damping) {
  gauge.for_each_held(damping.lambda, [&](std::uint32_t i) { diagonal.hold(i, 1); });
  bounds.for_each_held([&](std::uint32_t i) { diagonal.hold(i, kOfBounds); });
}

Damping Model::full_damping(const StepDamping& damping) {
  if (is_uniform(damping)) return {damping.lambda, nullptr};
  diagonal.fill(damping, gauge.fraction(), diagonal.floor(), 0, plan.scalars());
  hold_scalars(damping);
  return {1.0, diagonal.added()};
}

double Model::stiffness(std::uint32_t scalar) const {
  return kOfBounds * std::max(diagonal_of_hessian()[scalar], diagonal.floor());
}

}  // namespace boxplus
