// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "guess/frame_math.h"
#include "guess/initial_guess.h"
#include "guess/notes.h"
#include "guess/propagate.h"
#include "guess/restore.h"

namespace boxplus {
namespace {

using guess::FrameGraph;
using guess::Measurement;

double mean_squared_length(const FrameGraph& frames, const StopToken& stop) {
  PacedStop pace(stop, guess::kBetweenStops);
  double sum = 0;
  for (const Measurement& m : frames.measurements()) {
    pace.step();
    sum += guess::translation_of(frames.motion(m)).squaredNorm();
  }
  return sum / static_cast<double>(frames.measurements().size());
}

/// The variance for a weight. A weight of zero gives a very large variance, but not an infinite one.
double variance(double weight) {
  constexpr double kLeastWeight = 1e-12;
  return 1 / std::max(weight, kLeastWeight);
}

std::vector<double> variances(const FrameGraph& frames, const StopToken& stop) {
  const double lever = mean_squared_length(frames, stop);
  std::vector<double> cost;
  cost.reserve(frames.measurements().size());
  for (const Measurement& m : frames.measurements()) {
    cost.push_back(variance(m.translation_weight) +
                   (m.has_rotation ? lever * variance(m.rotation_weight) : 0));
  }
  return cost;
}

}  // namespace

GuessResult guess_spanning_tree(Graph& graph, const Plan& plan, const GuessLimits& limits) {
  return guess::guess_or_restore(graph, plan, [&]() -> GuessResult {
    FrameGraph frames(graph, plan, limits.stop);
    if (frames.measurements().empty()) return {false, guess::kNothingMeasured};
    guess::propagate(frames, variances(frames, limits.stop), limits.stop);
    return {true, {}};
  });
}

}  // namespace boxplus
