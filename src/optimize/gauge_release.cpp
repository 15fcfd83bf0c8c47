// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/gauge_release.h"

namespace boxplus {
namespace {

/// Lets go the held vertices whose own gradient does not vanish; false where there is none.
bool release_observable_vertices(Run& run, const RunResult& result) {
  constexpr double kNoticeable = 1e-8;
  if (result.status != Status::kConverged || run.session().keeps_held() || !run.may_go_on()) return false;
  const Plan& plan = run.system().plan();
  std::vector<VertexRef> observable;
  for (std::size_t k = 0; k < plan.held.size(); ++k) {
    const double decrease =
        run.system().linearizer().held_vertex_decrease(k, run.system().linearize_options());
    if (decrease > kNoticeable * result.chi2) {
      observable.push_back(plan.held[k].vertex);
    }
  }
  if (observable.empty()) return false;
  run.plan_again([&] { run.session().release(run.graph(), observable); });
  return true;
}

/// Runs on with the released vertices; where that brings nothing, they are held again, for good. A run that
/// was interrupted proves nothing.
RunResult minimize_released(Run& run, const RunResult& held) {
  constexpr double kWorthwhile = 1 - 1e-8;
  run.system().save(VertexPool::kStartLevel);
  const RunResult released = run.minimize(held.chi2);
  if (released.status != Status::kFailed && released.chi2 < kWorthwhile * held.chi2) return released;
  run.system().restore(VertexPool::kStartLevel);
  if (is_interruption(released.reason))
    return {released.status, released.reason, held.chi2, released.iterations};
  run.plan_again([&] { run.session().hold_again(run.graph()); });
  return held;
}

}  // namespace

RunResult release_and_go_on(Run& run, const RunResult& held) {
  return release_observable_vertices(run, held) ? minimize_released(run, held) : held;
}

}  // namespace boxplus
