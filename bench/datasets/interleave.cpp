// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/interleave.h"

#include <cmath>
#include <numeric>

#include "base/stopwatch.h"
#include "datasets/median.h"

namespace boxplus::bench {

double geometric_mean(const std::vector<double>& values) {
  if (values.empty()) return 1;
  const double sum = std::accumulate(values.begin(), values.end(), 0.0,
                                     [](double total, double value) { return total + std::log(value); });
  return std::exp(sum / static_cast<double>(values.size()));
}

std::vector<Figures> interleaved_medians(const std::vector<Contestant>& contestants, const Effort& effort) {
  std::vector<std::vector<std::vector<double>>> samples;  // [contestant][figure][repetition]
  for (const Contestant& run : contestants) samples.emplace_back(run().size());
  const Stopwatch clock;
  for (int done = 0; done < effort.most; ++done) {
    if (done >= effort.least && clock.seconds() > effort.enough_s) break;
    for (std::size_t c = 0; c < contestants.size(); ++c) {
      const Figures figures = contestants[c]();
      for (std::size_t f = 0; f < figures.size(); ++f) samples[c][f].push_back(figures[f]);
    }
  }
  std::vector<Figures> medians;
  for (const auto& figures : samples) {
    medians.emplace_back();
    for (const auto& figure : figures) medians.back().push_back(median(figure));
  }
  return medians;
}

}  // namespace boxplus::bench
