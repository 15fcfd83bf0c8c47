// SPDX-License-Identifier: BSD-3-Clause
// Measures several contestants (such as boxplus and Ceres) in turns, again and again, so that disturbances of
// the machine affect all of them equally.
#pragma once

#include <functional>
#include <vector>

namespace boxplus::bench {

/// The figures of one run, mostly seconds. All runs of a contestant have the same number of figures.
using Figures = std::vector<double>;
using Contestant = std::function<Figures()>;

struct Effort {
  int least = 5;          ///< the minimum number of repetitions, however long they take
  int most = 25;          ///< the maximum number of repetitions, however short they are
  double enough_s = 1.0;  ///< after this many seconds, only the repetitions up to `least` are still run
};

/// Returns the median of each figure of each contestant. Each contestant first runs once without being
/// measured.
std::vector<Figures> interleaved_medians(const std::vector<Contestant>& contestants,
                                         const Effort& effort = {});

/// Returns the geometric mean, or 1 for an empty list.
double geometric_mean(const std::vector<double>& values);

}  // namespace boxplus::bench
