// SPDX-License-Identifier: BSD-3-Clause
#include "system/trial.h"

#include <algorithm>
#include <cmath>

#include "base/vector_math.h"

namespace boxplus {

double Trial::try_step(const Move& move) {
  double largest = 0;
  for (std::size_t i = 0; i < move.step.size(); ++i)
    largest = std::max(largest, move.diagonal[i] * move.step[i] * move.step[i]);
  step_in_deviations_ = std::sqrt(largest);
  before_.take(*graph_, *plan_);
  order_.moved();
  try {
    for (const VertexList& list : plan_->vertices)
      graph_->vertex_pools()[list.pool]->oplus(list.slots, list.offsets, move.step.data());
    move.arrive();
    tried_ = {move.chi2(), max_abs(move.step)};
    return tried_.chi2;
  } catch (...) {
    take_back();
    throw;
  }
}

void Trial::accept() {
  order_.expect_trial("System::accept");
  order_.accepted();
  accepted_ = tried_;
}

void Trial::reject() {
  order_.expect_trial("System::reject");
  take_back();
}

void Trial::take_back() {
  before_.put_back(*graph_, *plan_);
  order_.rejected();
}

void Trial::describe_step(double chi2, IterationRecord& record) const {
  order_.expect_accepted_in_iteration("Algorithm::iterate");
  record.chi2 = accepted_.chi2;
  record.chi2_decrease = chi2 - record.chi2;
  record.step_max = accepted_.step_max;
}

}  // namespace boxplus
